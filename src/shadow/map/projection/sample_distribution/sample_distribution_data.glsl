// What the reduction reads and what it keeps, for C++ and shaders.
#ifndef GNOMON_SAMPLE_DISTRIBUTION_DATA_GLSL
#define GNOMON_SAMPLE_DISTRIBUTION_DATA_GLSL
#include "frame/glsl/frame_data.glsl"
#include "shadow/map/glsl/map_data.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

struct SampleDistributionInput {
  vec3 light_x_ws, light_y_ws, light_z_ws;  // LightFrame
  vec3 scene_min, scene_max;                // light space; x and y clipped to a projector's beam
  vec3 caster_min, caster_max;
  LightShape shape;
  uint count, size, tight;
  float lambda, border;
  float start;  // light_start()
};

// Floats as uints in the same order, so that atomic minima and maxima compare them. Independent of the order of threads.
struct SampleDistributionState {
  uint nearest, farthest;        // view depths of all samples, metres
  uint boxes[k_max_layers * 5u];  // of each split, light space: min x, min y, max x, max y, max z
};

#ifdef __cplusplus
}  // namespace gnomon
#endif
#endif
