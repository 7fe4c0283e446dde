#include "app/viewer/lights/light_list.h"

#include <algorithm>
#include <functional>
#include <set>

#include "base/error.h"
#include "lab/view/light_text.h"

namespace gnomon::viewer {
namespace {

// Keys of base and edits become what `change` makes of them; nullopt: they go.
void change_keys(ViewState& state, const std::function<std::optional<std::string>(const std::string&)>& change) {
  Settings base;
  for (const std::string& assignment : state.base.assignments()) {
    const size_t equals = assignment.find('=');
    if (const auto key = change(assignment.substr(0, equals))) base.assign(*key + assignment.substr(equals));
  }
  state.base = std::move(base);
  std::map<std::string, std::string> edits;
  for (const auto& [old_key, value] : state.edits) {
    if (const auto key = change(old_key)) edits[*key] = value;
  }
  state.edits = std::move(edits);
}

bool any_key(const ViewState& state, std::string_view prefix) {
  const auto& assignments = state.base.assignments();
  return std::any_of(assignments.begin(), assignments.end(), [&](const auto& text) { return text.starts_with(prefix); }) ||
         std::any_of(state.edits.begin(), state.edits.end(), [&](const auto& edit) { return edit.first.starts_with(prefix); });
}

void rename_settings(ViewState& state, const std::string& from, const std::string& to) {
  const std::string prefix = from + "@";
  if (from == to || !any_key(state, prefix)) return;
  change_keys(state, [&](const std::string& key) { return key.starts_with(prefix) ? to + key.substr(from.size()) : key; });
}

// Whether each text is one light, with a name of its own, and nothing else has a say.
bool is_written_out(const ViewState& state) {
  std::set<std::string> names;
  for (const std::string& text : state.view.lights) {
    const auto light = parse_light(text);
    if (!light || !names.insert(light->name).second) return false;
  }
  return !names.empty() && !any_key(state, "light.");
}

std::string allowed_name(std::string name, const std::string& otherwise) {
  for (char& letter : name) {
    if (k_not_in_light_names.find(letter) != k_not_in_light_names.npos) letter = '_';
  }
  return name.empty() ? otherwise : name;
}

std::string free_name(std::string name, const std::set<std::string>& taken) {
  if (!taken.contains(name)) return name;
  for (int number = 2;; ++number) {
    if (const std::string numbered = fmt::format("{} {}", name, number); !taken.contains(numbered)) return numbered;
  }
}

void write_out(ViewState& state, std::span<const Light> in_force) {
  if (is_written_out(state)) return;
  std::vector<std::string> texts;
  std::set<std::string> taken;
  for (const ListedLight& listed : lights_of(state, in_force)) {
    Light light = listed.light;
    const std::string old_name = light.name;
    light.name = free_name(allowed_name(light.name, std::string(light_kind_name(light.kind))), taken);
    taken.insert(light.name);
    rename_settings(state, old_name, light.name);
    texts.push_back(light_text(light, listed.reach_m));
  }
  state.view.lights = std::move(texts);
  if (any_key(state, "light.")) {
    change_keys(state, [](const std::string& key) { return key.starts_with("light.") ? std::nullopt : std::optional(key); });
  }
}

std::set<std::string> names_of(const ViewState& state) {
  std::set<std::string> names;
  for (const std::string& text : state.view.lights) names.insert(parse_light(text)->name);
  return names;
}

}  // namespace

void ListedLight::aim_at(const vec3& target_ws) {
  const float distance = glm::length(target_ws - light.position);
  if (distance < 1e-6f) return;
  reach_m = distance;
  light.direction = (target_ws - light.position) / distance;
}

std::vector<ListedLight> lights_of(const ViewState& state, std::span<const Light> in_force) {
  std::vector<ListedLight> list;
  if (is_written_out(state)) {
    for (const std::string& text : state.view.lights) list.push_back({*parse_light(text), light_reach(text)});
    return list;
  }
  for (size_t i = 0; i < in_force.size(); ++i) {
    // Texts in other company: "all", or with a sun that the settings move.
    const bool text = state.view.lights.size() == in_force.size() && parse_light(state.view.lights[i]);
    list.push_back({in_force[i], text ? light_reach(state.view.lights[i]) : 1.0f});
  }
  return list;
}

void set_light(ViewState& state, std::span<const Light> in_force, size_t index, const ListedLight& light) {
  write_out(state, in_force);
  GNOMON_ASSERT(index < state.view.lights.size());
  const std::string old_name = parse_light(state.view.lights[index])->name;
  Light written = light.light;
  written.name = allowed_name(written.name, old_name);
  if (written.name != old_name && names_of(state).contains(written.name))
    fail_usage("light name '{}': another light has it", written.name);
  rename_settings(state, old_name, written.name);
  state.view.lights[index] = light_text(written, light.reach_m);
}

void add_light(ViewState& state, std::span<const Light> in_force, ListedLight light) {
  write_out(state, in_force);
  light.light.name = free_name(allowed_name(light.light.name, std::string(light_kind_name(light.light.kind))), names_of(state));
  state.view.lights.push_back(light_text(light.light, light.reach_m));
  state.complete_techniques(std::span(&light.light, 1));
}

void remove_light(ViewState& state, std::span<const Light> in_force, size_t index) {
  write_out(state, in_force);
  if (state.view.lights.size() < 2) fail_usage("the only light stays: a picture needs one");
  const std::string prefix = parse_light(state.view.lights[index])->name + "@";
  state.view.lights.erase(state.view.lights.begin() + static_cast<std::ptrdiff_t>(index));
  if (any_key(state, prefix)) {
    change_keys(state, [&](const std::string& key) { return key.starts_with(prefix) ? std::nullopt : std::optional(key); });
  }
}

ListedLight usual_light(LightKind kind, const vec3& target_ws, float scale_m) {
  ListedLight listed;
  Light& light = listed.light;
  light.kind = kind;
  light.name = kind == LightKind::directional ? std::string_view("sun") : light_kind_name(kind);
  light.position = target_ws + scale_m * vec3(0.05f, 0.3f, 0.05f);
  light.angular_diameter = kind == LightKind::directional ? 0.533f * k_pi / 180.0f : 0.0f;
  light.beam_radius = std::max(0.2f * scale_m, 1e-2f);
  listed.aim_at(target_ws);
  if (light.parallel()) {
    light.intensity = 3.0f;
  } else {
    light.intensity = 3.0f * std::max(listed.reach_m * listed.reach_m, 1e-4f);  // as bright at its target as a sun
    light.radius = 0.005f * scale_m;
  }
  if (kind == LightKind::directional) light.direction = sun_direction(225.0f, 50.0f);
  return listed;
}

}  // namespace gnomon::viewer
