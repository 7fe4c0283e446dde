#include "app/viewer/measure/measure_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/viewer/panels/section.h"
#include "app/viewer/status_file.h"

namespace gnomon::viewer {
namespace {

// Figures that change with every frame cannot be read.
constexpr double k_rows_last_s = 0.25;
constexpr float k_plot_height = 110.0f;

void swatch(uint32_t colour) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetFontSize();
  if (colour != 0)
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 3.0f}, {at.x + size - 6.0f, at.y + size - 3.0f}, colour);
  ImGui::Dummy({size - 6.0f, size});
  ImGui::SameLine(0.0f, 5.0f);
}

void number(const std::string& text) {
  ImGui::TableNextColumn();
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  if (room > 0.0f) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
  ImGui::TextUnformatted(text.c_str());
}

std::string mib(uint64_t bytes) { return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / 1048576.0); }

}  // namespace

void MeasurePanel::show(Timings& timings, bool& separate_passes, Session& session, const TechniqueSet& techniques) {
  open_ = begin_section("Measure");
  if (open_ && !timings.frames().empty()) {
    if (ImGui::Button(timings.paused ? "Go on" : "Pause")) timings.paused = !timings.paused;
    note_widget("pause");
    ImGui::SameLine();
    ImGui::Checkbox("separate the passes (full barriers)", &separate_passes);
    note_widget("separate_passes");
    ImGui::TextWrapped("the last %zu frames, ms; %s", timings.counted(), timings.clock());
    if (const auto hovered = plot_.show(timings, k_plot_height)) one_frame(timings, timings.frames()[*hovered]);
    update_rows(timings);
    note_text("plot",
              fmt::format("{} frames, {} rows{}", timings.frames().size(), rows_.size(), timings.paused ? ", paused" : ""));
    table();
    memory(session, techniques);
  }
  end_section();
}

void MeasurePanel::update_rows(const Timings& timings) {
  rows_age_s_ += static_cast<double>(ImGui::GetIO().DeltaTime);
  if (!rows_.empty() && rows_age_s_ < k_rows_last_s) return;
  rows_age_s_ = 0.0;
  rows_.clear();
  const FrameResult& last = timings.frames().back();
  for (size_t i = 0; i < last.passes.size() && timings.of_passes(); ++i) {
    const PassResult& pass = last.passes[i];
    const std::string help = fmt::format("{}: {} dispatches", stage_name(pass.stage), pass.dispatches);
    const Summary ms = timings.summary([&](const FrameResult& f) { return timings.pass_ms(f, i); });
    rows_.push_back({pass.name, help, plot_.colour(pass.name), ms, pass.draws, pass.triangles});
  }
  const auto add = [&](const char* name, const char* help, auto value) {
    rows_.push_back({name, help, 0, timings.summary(value), 0, 0});
  };
  if (timings.of_passes()) {
    add("build", "passes that draw and convert maps",
        [&](const FrameResult& f) { return timings.stage_ms(f, PassStage::build); });
    add("resolve", "passes that fill the visibility mask",
        [&](const FrameResult& f) { return timings.stage_ms(f, PassStage::resolve); });
    add("sum of the passes", "", [&](const FrameResult& f) { return timings.sum_ms(f); });
  }
  if (!timings.of_software()) add("frame, GPU", timings.clock(), [&](const FrameResult& f) { return timings.frame_ms(f); });
  add("frame, wall clock", "from submission to completion", [](const FrameResult& f) { return f.wall_ms; });
  add("recording", "CPU time to record and submit", [](const FrameResult& f) { return f.record_ms; });
}

void MeasurePanel::table() const {
  if (!ImGui::BeginTable("passes", 5, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch);
  for (const char* name : {"median", "p95", "draws", "triangles"}) ImGui::TableSetupColumn(name);
  ImGui::TableHeadersRow();
  for (const Row& row : rows_) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    swatch(row.colour);
    ImGui::TextUnformatted(row.name.c_str());
    if (ImGui::IsItemHovered() && !row.help.empty()) ImGui::SetTooltip("%s", row.help.c_str());
    number(fmt::format("{:.3f}", row.ms.median));
    number(fmt::format("{:.3f}", row.ms.p95));
    number(row.draws > 0 ? fmt::format("{}", row.draws) : "");
    number(row.triangles > 0 ? fmt::format("{}", row.triangles) : "");
  }
  ImGui::EndTable();
}

void MeasurePanel::one_frame(const Timings& timings, const FrameResult& frame) {
  ImGui::BeginTooltip();
  for (size_t i = 0; i < frame.passes.size() && timings.of_passes(); ++i) {
    swatch(plot_.colour(frame.passes[i].name));
    ImGui::Text("%8.3f ms  %s", timings.pass_ms(frame, i), frame.passes[i].name.c_str());
  }
  ImGui::Text("frame %8.3f ms", timings.frame_ms(frame));
  ImGui::EndTooltip();
}

void MeasurePanel::memory(Session& session, const TechniqueSet& techniques) {
  const auto lights = session.frame().lights();
  for (size_t i = 0; i < lights.size(); ++i) {
    ImGui::Text("%10s  %s (%s)", mib(techniques.memory_bytes(i)).c_str(), techniques.spec(i).name.c_str(),
                lights[i].name.c_str());
  }
  ImGui::Text("%10s  all buffers and images of the program", mib(session.device().allocated_bytes()).c_str());
}

}  // namespace gnomon::viewer
