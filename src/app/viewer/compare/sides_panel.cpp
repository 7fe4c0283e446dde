// What the user sees of a comparison.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "app/viewer/compare/sides.h"
#include "app/viewer/panels/technique_list.h"
#include "app/viewer/status_file.h"

namespace gnomon::viewer {

void Sides::show(ViewState& state, const Session& session, size_t light) {
  if (light != light_) score_ = {}, settling_ = std::max(settling_, 1);
  light_ = std::min(light, session.chosen_lights().size() - 1);
  const int second = static_cast<int>(choice_.second);
  ImGui::SetNextItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
  constexpr std::array<const char*, 3> k_names = {"none", "other settings", "reference"};
  if (ImGui::BeginCombo("second side", k_names[static_cast<size_t>(second)])) {
    for (int i = 0; i < static_cast<int>(k_names.size()); ++i) {
      const char* name = k_names[static_cast<size_t>(i)];
      if (ImGui::Selectable(name, i == second)) choice_.second = static_cast<SecondSide>(i), second_key_.clear();
      note_widget("second_side", name);
    }
    ImGui::EndCombo();
  } else {
    note_widget("second_side");
  }
  if (choice_.second != SecondSide::none) {
    int flips = choice_.flip_mode;
    ImGui::RadioButton("split", &flips, 0);
    note_widget("split");
    ImGui::SameLine();
    ImGui::RadioButton("flip (B)", &flips, 1);
    note_widget("flip");
    choice_.flip_mode = flips != 0;
  }
  if (choice_.second == SecondSide::settings) {
    if (ImGui::Button("second as first")) choice_.other = state;
    note_widget("second_as_first");
    ImGui::SameLine();
    if (ImGui::Button("exchange")) {
      ViewState first = second_state(state);
      choice_.other = std::exchange(state, std::move(first));
      techniques_.clear();
    }
    note_widget("exchange");
    const auto lights = std::span(session.chosen_lights());
    const LightKind kind = lights[light_].kind;
    const std::string label = lights.size() > 1 ? fmt::format("for {}", lights[light_].name) : "technique";
    ImGui::SetNextItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
    const TechniqueSpec* chosen = show_technique_list((label + "###second_technique").c_str(), "second_technique",
                                                      technique_for(choice_.other.techniques, kind), kind);
    if (chosen) choice_.other.choose_technique(*chosen, kind, lights);
  }
  ImGui::Checkbox("error over the picture (X)", &choice_.error);
  note_widget("error");
  ImGui::SameLine();
  ImGui::Checkbox("scores", &choice_.scores);
  note_widget("scores");
  if (choice_.error) {
    ImGui::TextColored({0.95f, 0.33f, 0.05f, 1.0f}, "darker than the reference (false shadow)");
    ImGui::TextColored({0.15f, 0.55f, 0.98f, 1.0f}, "brighter (false light)");
  }
  if (!wants_reference()) return;
  show_reference();
  if (session.chosen_lights().size() > 1 && (choice_.error || choice_.scores)) {
    // Each light has a mask; the picture shows all of them.
    const std::string& name = session.chosen_lights()[light_].name;
    note_text("scored_light", name);
    ImGui::TextWrapped("error and scores: of the light '%s', as chosen in Technique", name.c_str());
  }
  show_scores();
}

void Sides::show_reference() const {
  const ProgressiveReference::Answer* answer = reference_ ? reference_->answer() : nullptr;
  const std::string text = answer && answer->complete
                               ? fmt::format("{} ray{}", answer->samples, answer->samples == 1 ? "" : "s")
                           : answer ? fmt::format("{} of {} rays", answer->samples, reference_->samples())
                                    : std::string("waits for a still view");
  const double share = answer && answer->complete ? 1.0 : reference_ ? reference_->share() : 0.0;
  note_text("reference", text);
  ImGui::ProgressBar(static_cast<float>(share), {-1.0f, 0.0f}, fmt::format("reference: {}", text).c_str());
}

void Sides::show_scores() const {
  if (!score_[0] || !ImGui::BeginTable("scores", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::TableSetupColumn("mask against the area reference");
  ImGui::TableSetupColumn("first");
  ImGui::TableSetupColumn(choice_.second == SecondSide::settings ? "second" : "");
  ImGui::TableHeadersRow();
  const auto row = [&](const char* name, const char* format, double factor, auto value) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    for (const auto& score : score_) {
      ImGui::TableNextColumn();
      if (score) ImGui::Text(format, factor * value(score->error));
    }
  };
  for (size_t side = 0; side < score_.size(); ++side) {
    if (score_[side]) note_text(side == 0 ? "mae.first" : "mae.second", fmt::format("{}", score_[side]->error.mae));
  }
  row("area mae", "%.4f", 1.0, [](const VisibilityError& e) { return e.mae; });
  row("area rmse", "%.4f", 1.0, [](const VisibilityError& e) { return e.rmse; });
  row("false shadow, area", "%.2f %%", 100.0, [](const VisibilityError& e) { return e.false_shadow.area; });
  row("false light, area", "%.2f %%", 100.0, [](const VisibilityError& e) { return e.false_light.area; });
  row("bias", "%+.4f", 1.0, [](const VisibilityError& e) { return e.bias; });
  ImGui::EndTable();
  if (reference_->answer())
    ImGui::TextDisabled("mean of the reference: +- %.4f", reference_->answer()->lights[light_].confidence);
}

void Sides::show_divider() {
  if (choice_.second == SecondSide::none) return;
  note_text("sides", fmt::format("{} | {}{}", names_[0], names_[1],
                                 choice_.flip_mode ? (choice_.flipped ? ", second" : ", first") : ""));
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImDrawList* lines = ImGui::GetBackgroundDrawList();
  const auto label = [&](const std::string& text, float x, bool before) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at(before ? x - size.x - 12.0f : x + 12.0f, screen.y - size.y - 10.0f);
    lines->AddRectFilled({at.x - 4.0f, at.y - 2.0f}, {at.x + size.x + 4.0f, at.y + size.y + 2.0f}, IM_COL32(0, 0, 0, 170),
                         3.0f);
    lines->AddText(at, IM_COL32_WHITE, text.c_str());
  };
  if (choice_.flip_mode) {
    label(names_[choice_.flipped ? 1 : 0] + (choice_.flipped ? " (second)" : " (first)"), screen.x, true);
    return;
  }
  const float x = choice_.divider * screen.x;
  constexpr float k_grip = 12.0f;
  ImGui::SetNextWindowPos({x - k_grip, 0.0f});
  ImGui::SetNextWindowSize({2.0f * k_grip, screen.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
  constexpr ImGuiWindowFlags k_bare = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (ImGui::Begin("##divider", nullptr, k_bare)) {
    ImGui::InvisibleButton("grip", {2.0f * k_grip, screen.y});
    note_widget("divider");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive()) choice_.divider = std::clamp(ImGui::GetIO().MousePos.x / screen.x, 0.02f, 0.98f);
  }
  ImGui::End();
  ImGui::PopStyleVar();
  lines->AddLine({x, 0.0f}, {x, screen.y}, IM_COL32(255, 255, 255, 220), 2.0f);
  label(names_[0], x, true);
  label(names_[1], x, false);
}

}  // namespace gnomon::viewer
