#include "app/viewer/explain/surface_pick.h"

#include <algorithm>

namespace gnomon::viewer {

std::optional<vec3> surface_at(Session& session, vec2 part) {
  session.complete_surface();
  const Frame& frame = session.frame();
  const uvec2 size = frame.size(), pixel = glm::min(uvec2(glm::max(part, vec2(0.0f)) * vec2(size)), size - 1u);
  const auto points = frame.read_points();
  const auto found = std::find_if(points.begin(), points.end(), [&](const SurfacePoint& point) {
    return point.pixel == pixel.y * size.x + pixel.x && point.object != k_no_object;
  });
  return found == points.end() ? std::nullopt : std::optional(found->position_ws);
}

}  // namespace gnomon::viewer
