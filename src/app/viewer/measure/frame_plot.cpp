#include "app/viewer/measure/frame_plot.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace gnomon::viewer {
namespace {

constexpr ImU32 k_background = IM_COL32(20, 22, 26, 220), k_grid = IM_COL32(255, 255, 255, 40),
                k_text = IM_COL32(220, 220, 220, 255);
constexpr ImU32 k_whole_frame = IM_COL32(150, 160, 175, 255), k_hovered = IM_COL32(255, 255, 255, 60);

// The next of 1, 2, 5, 10, 20, ... above a value, so that the scale seldom moves.
double round_up(double ms) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(ms, 1e-3))));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (ms <= step * power) return step * power;
  }
  return 10.0 * power;
}

}  // namespace

uint32_t FramePlot::colour(const std::string& pass) {
  const auto found = colours_.find(pass);
  if (found != colours_.end()) return found->second;
  // Hues a golden section apart: however many there are, neighbours differ.
  const auto number = static_cast<float>(colours_.size());
  const float hue = std::fmod(0.58f + 0.61803399f * number, 1.0f);
  const float value = colours_.size() % 2 == 0 ? 0.95f : 0.72f;
  float r, g, b;
  ImGui::ColorConvertHSVtoRGB(hue, 0.6f, value, r, g, b);
  return colours_[pass] = ImGui::ColorConvertFloat4ToU32({r, g, b, 1.0f});
}

void FramePlot::column(const Timings& timings, const FrameResult& frame, float left, float right, float bottom,
                       float px_per_ms) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!timings.of_passes()) {
    list.AddRectFilled({left, bottom - px_per_ms * static_cast<float>(timings.frame_ms(frame))}, {right, bottom},
                       k_whole_frame);
    return;
  }
  // What is thinner than half a pixel is drawn with the next: triangles that cover nothing cost as much as others on a CPU
  // driver.
  double sum = 0.0;
  float drawn = 0.0f;
  for (size_t i = 0; i < frame.passes.size(); ++i) {
    sum += timings.pass_ms(frame, i);
    const float top = px_per_ms * static_cast<float>(sum);
    if (top - drawn < 0.5f) continue;
    list.AddRectFilled({left, bottom - top}, {right, bottom - drawn}, colour(frame.passes[i].name));
    drawn = top;
  }
}

std::optional<size_t> FramePlot::show(const Timings& timings, float height) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 50.0f);
  const ImVec2 to = {from.x + width, from.y + height};
  ImGui::InvisibleButton("frames", {width, height});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(from, to, k_background);
  const auto& frames = timings.frames();
  // One slow frame in twenty leaves the plot: it would press the others flat.
  const bool passes = timings.of_passes();
  const Summary whole = timings.summary([&](const FrameResult& f) { return passes ? timings.sum_ms(f) : timings.frame_ms(f); });
  const double top_ms = round_up(1.1 * whole.p95);
  const float step = width / static_cast<float>(Timings::k_frames), px_per_ms = height / static_cast<float>(top_ms);
  const auto left_of = [&](size_t i) { return to.x - step * static_cast<float>(frames.size() - i); };
  // Edges without blending: columns meet.
  const ImDrawListFlags flags = list.Flags;
  list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  ImGui::PushClipRect(from, to, true);
  for (size_t i = 0; i < frames.size(); ++i) column(timings, frames[i], left_of(i), left_of(i) + step, to.y, px_per_ms);
  ImGui::PopClipRect();
  list.Flags = flags;
  for (const float part : {0.0f, 0.5f}) {
    const float y = from.y + part * height;
    list.AddLine({from.x, y}, {to.x, y}, k_grid);
    list.AddText({from.x + 3.0f, y + 1.0f}, k_text,
                 fmt::format("{:.4g} ms", top_ms * static_cast<double>(1.0f - part)).c_str());
  }
  if (!ImGui::IsItemHovered()) return std::nullopt;
  const float back = (to.x - ImGui::GetIO().MousePos.x) / step;
  if (back < 0.0f || back >= static_cast<float>(frames.size())) return std::nullopt;
  const size_t hovered = frames.size() - 1 - static_cast<size_t>(back);
  list.AddRectFilled({left_of(hovered) - 1.0f, from.y}, {left_of(hovered) + step + 1.0f, to.y}, k_hovered);
  return hovered;
}

}  // namespace gnomon::viewer
