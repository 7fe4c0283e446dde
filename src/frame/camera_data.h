// From a scene's camera to what shaders read.
#pragma once

#include <array>

#include "frame/glsl/frame_data.glsl"
#include "scene/scene.h"

namespace gnomon {

// Reversed Z, infinite far plane for perspective: depth = near / z keeps its relative precision at every distance.
// subpixel: CameraData::subpixel.
CameraData camera_data(const Camera& camera, uvec2 size, uint32_t samples, vec2 subpixel = vec2(0.0f));

// World-space corners of the part of the view between two distances along the viewing axis (metres): four at `from`, four at
// `to`.
std::array<vec3, 8> slice_corners(const CameraData& camera, float from_m, float to_m);

}  // namespace gnomon
