#include "app/viewer/panels/param_editor.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <vector>

#include "app/viewer/explain/legend.h"
#include "app/viewer/status_file.h"

namespace gnomon::viewer {
namespace {

// Over several powers of ten, small values need as much room as large ones.
ImGuiSliderFlags slider_flags(const ParamInfo& info) {
  return info.min >= 0.0 && info.max > 500.0 * std::max(info.min, 0.02) ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
}

// Draws the widget for `value`, which it changes.
void widget(const std::string& key, const ParamInfo& info, double& value) {
  switch (info.type) {
    case ParamType::float_: {
      float number = static_cast<float>(value);
      if (ImGui::SliderFloat("##value", &number, static_cast<float>(info.min), static_cast<float>(info.max), "%.4g",
                             slider_flags(info))) {
        value = number;
      }
      break;
    }
    case ParamType::int_: {
      int number = static_cast<int>(value);
      if (ImGui::SliderInt("##value", &number, static_cast<int>(info.min), static_cast<int>(info.max), "%d",
                           slider_flags(info))) {
        value = number;
      }
      break;
    }
    case ParamType::bool_: {
      bool on = value != 0.0;
      if (ImGui::Checkbox("##value", &on)) value = on ? 1.0 : 0.0;
      break;
    }
    case ParamType::choice: {
      const auto name = [&](size_t i) { return std::string(info.choices[i]); };
      if (!ImGui::BeginCombo("##value", name(static_cast<size_t>(value)).c_str())) break;
      for (size_t i = 0; i < info.choices.size(); ++i) {
        if (ImGui::Selectable(name(i).c_str(), value == static_cast<double>(i))) value = static_cast<double>(i);
        note_widget(key, info.choices[i]);
      }
      ImGui::EndCombo();
      return;  // the list is open: what follows is no longer about the closed box
    }
  }
  note_widget(key);
}

std::string text_of(const ParamInfo& info, double value) {
  switch (info.type) {
    case ParamType::float_:
      return fmt::format("{}", static_cast<float>(value));
    case ParamType::int_:
      return fmt::format("{}", static_cast<int>(value));
    case ParamType::bool_:
      return value != 0.0 ? "true" : "false";
    case ParamType::choice:
      return std::string(info.choices[static_cast<size_t>(value)]);
  }
  return {};
}

}  // namespace

void ParamEditor::search_field() {
  any_found_ = false;
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##search", "search the parameters", search_, sizeof search_);
  note_widget("search");
}

void ParamEditor::end_search() const {
  if (any_found_) return;
  const std::string text = fmt::format("no parameter contains '{}'", search_);
  note_text("search", text);
  remark(text.c_str());
}

bool ParamEditor::found(const std::string& key, const ParamInfo& info) const {
  return key.find(search_) != key.npos || info.help.find(search_) != info.help.npos;
}

void ParamEditor::show(const std::string& id, const ParamBlock& block, const ParamBlock& starts, const Change& change,
                       const Offers& offers) {
  std::vector<const ParamInfo*> shown;
  for (const ParamInfo& info : block.table()) {
    if ((!offers || offers(info.name)) && found(fmt::format("{}.{}", id, info.name), info)) shown.push_back(&info);
  }
  if (shown.empty()) return;
  any_found_ = true;
  if (!ImGui::TreeNodeEx(id.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) return;
  for (const ParamInfo* info : shown) row(fmt::format("{}.{}", id, info->name), *info, block, starts, change);
  ImGui::TreePop();
}

void ParamEditor::row(const std::string& key, const ParamInfo& info, const ParamBlock& block, const ParamBlock& starts,
                      const Change& change) {
  ImGui::PushID(key.c_str());
  const double in_force = block.number(info.name);
  double value = dragged_key_ == key ? dragged_ : in_force;
  const double before = value;
  ImGui::SetNextItemWidth(0.42f * ImGui::GetContentRegionAvail().x);
  widget(key, info, value);
  const bool drags = info.update == ParamUpdate::rebuild && (info.type == ParamType::float_ || info.type == ParamType::int_);
  if (drags && ImGui::IsItemActive()) {
    dragged_key_ = key, dragged_ = value;
  } else if (dragged_key_ == key || value != before) {
    dragged_key_.clear();
    const std::string text = text_of(info, value);
    if (value != in_force) change(info.name, &text);
  }
  const auto tooltip = [&] {
    if (!ImGui::IsItemHovered()) return;
    const std::string text =
        fmt::format("{}\n\n{}: {}; default {}{}", info.help, key, info.valid_text(), ParamBlock(block.table()).text(info.name),
                    info.update == ParamUpdate::rebuild ? "; builds the technique again" : "");
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 30.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  };
  tooltip();
  ImGui::SameLine();
  const std::string unit(info.unit()), name(info.name);
  ImGui::TextUnformatted(unit.empty() ? name.c_str() : fmt::format("{} [{}]", name, unit).c_str());
  tooltip();
  if (in_force != starts.number(info.name)) {
    ImGui::SameLine();
    if (ImGui::SmallButton("reset")) change(info.name, nullptr);
    note_widget(key, "reset");
  }
  ImGui::PopID();
}

}  // namespace gnomon::viewer
