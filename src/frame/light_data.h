// From a scene's light to what shaders read.
#pragma once

#include "frame/glsl/frame_data.glsl"
#include "scene/light_shape.h"

namespace gnomon {

inline LightData light_data(const Light& light) {
  return {light_shape(light, true), light.colour * light.intensity, std::cos(light.inner_cone)};
}

}  // namespace gnomon
