// Exact visibility of a directional light behind simple occluders, for the charts. Directions toward a disc-shaped sun are
// w + r (x, y), w the unit direction toward its centre, r = tan(angular_diameter / 2), (x, y) uniform in the unit disc of
// the plane perpendicular to w (as in reference/ and the ray-traced techniques). Straight edges are then straight lines in
// that plane, and the covered fraction is the area of a polygon within a circle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace gnomon {

// Area of the part of a polygon (either orientation, simple) that lies in the disc of that radius around the origin.
double disc_polygon_overlap(std::span<const glm::dvec2> polygon, double radius);

struct BoxOccluder {
  glm::dvec3 min, max;
};
struct SphereOccluder {
  glm::dvec3 centre;
  double radius;
};
// Opaque strips in the plane x = 0, lower <= y <= upper; each is an interval of z. Disjoint.
struct StripsOccluder {
  std::vector<glm::dvec2> z_intervals;
  double lower, upper;
};

// Visibility in [0, 1] of a directional light from a point outside the occluder. nullopt where part of the sun lies at or
// below the horizon (y <= 0 of its direction) and for other kinds of light.
// Box and strips: exact (rounding only). Sphere: the rim of its shadow cone enters as a polygon of 2048 corners and equal
// area; the error of a partial visibility is below 1e-6. Hard light (angular_diameter == 0): 0 or 1, all exact.
std::optional<double> closed_form_visibility(const glm::dvec3& point, const Light& light, const BoxOccluder& occluder);
std::optional<double> closed_form_visibility(const glm::dvec3& point, const Light& light, const SphereOccluder& occluder);
std::optional<double> closed_form_visibility(const glm::dvec3& point, const Light& light, const StripsOccluder& occluder);

}  // namespace gnomon
