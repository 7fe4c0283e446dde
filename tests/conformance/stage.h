// Scenes on which every technique is tried, and the loop over techniques.
#pragma once

#include "reference/cpu/embree_reference.h"
#include "support/scenes.h"
#include "support/view.h"

namespace gnomon::test {

// A kind of light that the technique supports; directional where it can choose.
LightKind preferred_light(const TechniqueSpec& spec);

// A light of that kind that shines along `direction` onto `target`, from `distance` metres away where it has a place.
Light make_light(LightKind kind, const vec3& direction, const vec3& target, float distance);

// The scenes. Each has one camera and one light, of size `sun_deg` where it is a sun.
Scene open_floor(LightKind kind);              // a floor and a caster beside it whose shadow the camera does not see
Scene closed_room(LightKind kind, bool thin);  // seen from within; walls of half a metre, or without thickness
Scene box_on_floor(LightKind kind);            // a box that hovers over a floor, its shadow in the picture
Scene busy(LightKind kind);                    // the courtyard; under a lamp, boxes on a floor

// Views are kept for all tests of a run: a scene is uploaded once. `name` stands for what `make` makes.
View& kept_view(const std::string& name, const std::function<Scene()>& make, uvec2 size, uint32_t samples = 1);

// 1 for samples that show a surface which faces the light.
std::vector<uint8_t> receivers(View& view);
size_t count(const std::vector<uint8_t>& flags);

// Hard shadows of the surface that was drawn last, by Embree. Kept per view.
const ReferenceResult& hard_reference(View& view);

// A name that GoogleTest accepts.
std::string test_name(std::string_view text);

}  // namespace gnomon::test
