// One visible surface sample, as the reference and the error metrics see it. The GPU writes it, Embree reads it: the layout is
// shared with frame/glsl/surface_point.glsl.
#pragma once

#include <cstdint>

#include "base/maths.h"

namespace gnomon {

struct SurfacePoint {
  vec3 position_ws;
  uint32_t object;           // index into Scene::objects, or k_no_object where the camera sees the sky
  vec3 geometric_normal_ws;  // unit, turned toward the viewer
  uint32_t pixel;            // y * width + x: seeds the per-pixel random shift
};
static_assert(sizeof(SurfacePoint) == 32);

inline constexpr uint32_t k_no_object = 0xffffffffu;

}  // namespace gnomon
