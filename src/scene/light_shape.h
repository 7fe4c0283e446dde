// A scene's light in the terms of base/glsl/light_sampling.glsl.
#pragma once

#include <cmath>

#include "base/glsl/light_sampling.glsl"
#include "scene/scene.h"

namespace gnomon {

// area = false: the light shrunk to its centre.
inline LightShape light_shape(const Light& light, bool area) {
  LightShape shape;
  shape.position = light.position;
  shape.kind = static_cast<uint32_t>(light.kind);
  shape.direction = light.direction;
  shape.emitter_radius = 0.0f;
  if (area) shape.emitter_radius = light.parallel() ? std::tan(0.5f * light.angular_diameter) : light.radius;
  shape.cos_outer_cone = std::cos(light.outer_cone);
  shape.range = light.parallel() ? 0.0f : light.range;
  shape.beam_radius = light.beam_radius;
  return shape;
}

}  // namespace gnomon
