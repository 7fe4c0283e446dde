// What the charts have in common: a floor at y = 0, one sun, and when a point counts as floor.
#pragma once

#include <optional>
#include <utility>

#include "scene/builtin/builtin.h"
#include "scene/builtin/parts/closed_form.h"

namespace gnomon {

// Materials 0 (floor) and 1 (caster), the floor's object, and the sun of the options `elevation`, `azimuth` and `sun_deg`.
Scene chart_with_floor(const std::string& name, float half_side_m, const BuiltinOptions& options);

// The options of a chart: its own, and those of the sun.
std::vector<BuiltinOption> with_sun(double elevation, double azimuth, std::vector<BuiltinOption> options);

// Where the sun's centre throws the shadow of a point onto the floor, at most ten metres away: what the camera looks at.
vec3 shadow_on_floor(const Scene& scene, const vec3& point);

// Closed forms answer for floor points only: |y| up to a tenth of a millimetre and outside the caster.
bool is_floor_point(const glm::dvec3& point);

template <class Occluder>
ClosedFormVisibility floor_visibility(Occluder occluder) {
  return [occluder = std::move(occluder)](const glm::dvec3& point, const Light& light) -> std::optional<double> {
    if (!is_floor_point(point)) return std::nullopt;
    return closed_form_visibility(point, light, occluder);
  };
}

}  // namespace gnomon
