#include "app/viewer/timings.h"

#include <imgui.h>

#include <algorithm>

namespace gnomon::viewer {
namespace {

constexpr size_t k_frames = 30;

template <class Value>
double mean(const std::deque<FrameResult>& frames, Value value) {
  double sum = 0.0;
  for (const FrameResult& frame : frames) sum += value(frame);
  return sum / static_cast<double>(frames.size());
}

void row(const char* name, double ms, const PassResult* pass) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name);
  ImGui::TableNextColumn();
  ImGui::Text("%8.3f", ms);
  if (!pass) return;
  ImGui::TableNextColumn();
  ImGui::Text("%u", pass->draws + pass->dispatches);
}

}  // namespace

void Timings::add(const FrameResult& frame) {
  if (!frames_.empty() && frames_.back().passes.size() != frame.passes.size()) frames_.clear();
  frames_.push_back(frame);
  if (frames_.size() > k_frames) frames_.pop_front();
}

void Timings::show(bool software) const {
  if (frames_.empty()) return;
  const bool alone = frames_.back().submission_ms > 0.0;
  ImGui::TextDisabled("mean of %zu frames%s", frames_.size(),
                      !software ? "" : alone ? "; wall clock, each pass alone" : "; separate the passes to time each");
  if (!ImGui::BeginTable("passes", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::TableSetupColumn("pass");
  ImGui::TableSetupColumn(software ? "ms" : "GPU ms");
  ImGui::TableSetupColumn("calls");
  ImGui::TableHeadersRow();
  for (size_t i = 0; i < frames_.back().passes.size() && (alone || !software); ++i) {
    const PassResult& pass = frames_.back().passes[i];
    row(pass.name.c_str(), mean(frames_, [&](const FrameResult& f) { return alone ? f.passes[i].wall_ms : f.passes[i].gpu_ms; }), &pass);
  }
  if (!software) row("frame, GPU", mean(frames_, [](const FrameResult& f) { return f.gpu_ms; }), nullptr);
  row("frame, wall", mean(frames_, [](const FrameResult& f) { return f.wall_ms; }), nullptr);
  row("recording", mean(frames_, [](const FrameResult& f) { return f.record_ms; }), nullptr);
  ImGui::EndTable();
}

}  // namespace gnomon::viewer
