// The light's views as lines in the picture: the volume of each layer, and where the viewer's frustum is cut into them.
#pragma once

#include <span>

#include "frame/camera_data.h"
#include "shadow/map/glsl/map_data.glsl"

struct ImDrawList;

namespace gnomon::viewer {

// `camera` looks at the lines, in a picture of that size at the window's corner. `split_camera`: whose frustum was cut; null:
// splits are not drawn (seen by the camera that was cut they are the picture's edge).
void draw_light_lines(ImDrawList& list, const CameraData& camera, vec2 size, std::span<const ShadowView> views,
                      const CameraData* split_camera, float scene_radius_m);

}  // namespace gnomon::viewer
