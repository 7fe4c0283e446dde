// The lights of a state as a list to edit. An untouched state leaves them to the scene and the light settings; the first edit
// writes each out as text, as --light reads it, and what the light settings said is from then on in those texts.
#pragma once

#include <span>

#include "app/viewer/state/view_state.h"

namespace gnomon::viewer {

struct ListedLight {
  Light light;
  float reach_m = 1.0f;  // how far away the target of a spot or a projector is

  vec3 target() const { return light.position + reach_m * light.direction; }
  void aim_at(const vec3& target_ws);  // nothing changes where that is the light's own place
};

// `in_force` everywhere: the lights that the session shows for the state (Session::chosen_lights).
std::vector<ListedLight> lights_of(const ViewState& state, std::span<const Light> in_force);
// Renames where the name differs: settings of the light go along. Throws Error (usage) for a name that another light has.
void set_light(ViewState& state, std::span<const Light> in_force, size_t index, const ListedLight& light);
// With a name of its own, and a technique for its kind where the state has none.
void add_light(ViewState& state, std::span<const Light> in_force, ListedLight light);
// With the settings of its own. One light stays.
void remove_light(ViewState& state, std::span<const Light> in_force, size_t index);

// A new light of that kind in a scene of that size, which shines toward `target_ws` from above and beside it.
ListedLight usual_light(LightKind kind, const vec3& target_ws, float scale_m);

}  // namespace gnomon::viewer
