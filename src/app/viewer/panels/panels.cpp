#include "app/viewer/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string_view>

#include "app/viewer/panels/section.h"
#include "app/viewer/panels/technique_list.h"
#include "app/viewer/status_file.h"

namespace gnomon::viewer {
namespace {

using namespace std::string_view_literals;

void wrapped(const std::string& text, float width) {
  ImGui::PushTextWrapPos(width);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace

bool begin_main_panel() {
  const WindowPlaces places = places_on_screen();
  appear_at("panel", places.panel, places.panel_folded);
  const bool open = ImGui::Begin("gnomon");
  if (open) note_window("panel");
  return open;
}

void Panels::show(ViewState& state, Wishes& wishes, Session& session, const TechniqueSet& techniques) {
  if (begin_main_panel()) {
    window(wishes, session);
    if (ImGui::CollapsingHeader("Technique", ImGuiTreeNodeFlags_DefaultOpen)) technique(state, session, techniques);
    if (ImGui::CollapsingHeader("Parameters", ImGuiTreeNodeFlags_DefaultOpen)) {
      editor_.search_field();
      technique_params(state, session, techniques.spec(light_));
      scene_params(state, session);
      editor_.end_search();
      samples(state, session);
    }
  }
  ImGui::End();
}

void Panels::window(Wishes& wishes, const Session& session) const {
  wishes.screenshot = ImGui::Button("Picture (F12)") || wishes.screenshot;
  note_widget("screenshot");
  ImGui::SameLine();
  wishes.copy_command = ImGui::Button("Copy command") || wishes.copy_command;
  note_widget("copy_command");
  ImGui::SameLine();
  ImGui::Checkbox("vsync", &wishes.vsync);
  note_widget("vsync");
  ImGui::Checkbox("adapt the picture's size", &wishes.adapt_size);
  note_widget("adapt_size");
  ImGui::SetNextItemWidth(0.42f * ImGui::GetContentRegionAvail().x);
  if (wishes.adapt_size) {
    ImGui::SliderFloat("##target_ms", &wishes.target_ms, 5.0f, 200.0f, "%.0f", ImGuiSliderFlags_AlwaysClamp);
    note_widget("target_ms");  // the slider alone: its middle takes numbers
    ImGui::SameLine();
    ImGui::TextUnformatted("ms a frame");
  } else {
    ImGui::SliderFloat("##scale", &wishes.scale, 0.1f, 2.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    note_widget("scale");  // the slider alone: its middle takes numbers
    ImGui::SameLine();
    ImGui::TextUnformatted("picture / window size");
  }
  const uvec2 size = session.options().size;
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  // One line in either case: what is below must not move.
  if (map_divisor_ > 1) {
    ImGui::Text("%u x %u; maps of 1/%u while it moves", size.x, size.y, map_divisor_);
    note_text("small_maps", fmt::format("1/{}", map_divisor_));
  } else {
    ImGui::Text("%u x %u", size.x, size.y);
  }
  ImGui::Text("W A S D Q E, right mouse button; %.3g m/s", static_cast<double>(speed_m_s_));
  ImGui::PopStyleColor();
}

void Panels::technique(ViewState& state, Session& session, const TechniqueSet& techniques) {
  const auto lights = session.frame().lights();
  light_ = std::min(light_, lights.size() - 1);  // some may have been removed
  const auto label = [&](size_t i) { return fmt::format("{} ({})##{}", lights[i].name, light_kind_name(lights[i].kind), i); };
  if (lights.size() > 1) {
    if (ImGui::BeginCombo("light", label(light_).c_str())) {
      for (size_t i = 0; i < lights.size(); ++i) {
        if (ImGui::Selectable(label(i).c_str(), i == light_)) light_ = i;
        note_widget("light", lights[i].name);
      }
      ImGui::EndCombo();
    } else {
      note_widget("light");
    }
  }
  const TechniqueSpec& shown = techniques.spec(light_);
  ImGui::SetNextItemWidth(-1.0f);
  const LightKind kind = lights[light_].kind;
  if (const TechniqueSpec* chosen = show_technique_list("##technique", "technique", &shown, kind))
    state.choose_technique(*chosen, kind, lights);
  if (ImGui::TreeNode("manual page")) {
    wrapped(shown.manual, 0.0f);
    ImGui::TreePop();
  }
}

void Panels::technique_params(ViewState& state, Session& session, const TechniqueSpec& spec) {
  // With several lights each has values of its own.
  const Light& light = session.frame().lights()[light_];
  const bool of_light = session.frame().lights().size() > 1 || !state.base.lights_named().empty();
  const SettingsMap settings = session.settings_of(spec, light_);
  for (const auto& [id, table] : spec.tables) {
    editor_.show(id, settings.at(id), ParamBlock(table), [&](std::string_view name, const std::string* value) {
      const std::string key = fmt::format("{}{}.{}", of_light ? light.name + "@" : "", id, name);
      state.edits[key] = value ? *value : ParamBlock(table).text(name);
    });
  }
}

void Panels::samples(ViewState& state, const Session& session) {
  ImGui::SetNextItemWidth(0.42f * ImGui::GetContentRegionAvail().x);
  if (ImGui::BeginCombo("##samples", fmt::format("{}", session.options().samples).c_str())) {
    for (const int count : session.device().info().sample_counts) {
      const auto samples = static_cast<uint32_t>(count);
      if (ImGui::Selectable(fmt::format("{}", count).c_str(), samples == session.options().samples))
        state.view.samples = samples;
      note_widget("samples", fmt::format("{}", count));
    }
    ImGui::EndCombo();
  } else {
    note_widget("samples");
  }
  ImGui::SameLine();
  ImGui::TextUnformatted("samples a pixel");
}

void Panels::scene_params(ViewState& state, Session& session) {
  const auto& lights = session.chosen_lights();
  const bool any_sun =
      std::any_of(lights.begin(), lights.end(), [](const Light& light) { return light.kind == LightKind::directional; });
  for (const char* id : {"light", "frame", "camera", "reference"}) {
    const ParamBlock& block = session.settings().block(id);
    // What the scene decides about its light and camera is where those started.
    const auto change = [&](std::string_view name, const std::string* value) {
      const std::string key = fmt::format("{}.{}", id, name);
      if (value) {
        state.edits[key] = *value;
      } else {
        state.edits.erase(key);
      }
    };
    // Without a sun the rest of what places one is an error (choose_lights).
    const auto offers = [&](std::string_view name) { return any_sun || id != "light"sv || name == "intensity"; };
    editor_.show(id, block, start_.block(id), change, offers);
  }
}

bool Panels::show_message(const std::string& text, MessageKind kind) {
  if (text.empty()) return false;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * screen.x, screen.y - 8.0f}, ImGuiCond_Always, {0.5f, 1.0f});
  ImGui::SetNextWindowSize({0.9f * screen.x, 0.0f});
  const bool failed = kind == MessageKind::failure;
  bool open = true;
  // The part behind ### is the window's identity.
  const char* title = failed ? "not possible; what was shown before is still shown###failure" : "notice###notice";
  // A notice takes nothing from the user: no list closes, and no field loses the keyboard.
  const ImGuiWindowFlags focus = failed ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin(title, &open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | focus)) {
    note_window(failed ? "message" : "notice");
    note_text(failed ? "failure" : "notice", text);
    if (failed) ImGui::PushStyleColor(ImGuiCol_Text, {1.0f, 0.6f, 0.5f, 1.0f});
    wrapped(text, 0.0f);
    if (failed) ImGui::PopStyleColor();
  }
  ImGui::End();
  return !open;
}

}  // namespace gnomon::viewer
