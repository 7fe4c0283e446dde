// visibility(): the whole map technique as one function, for gnomon's kernel and for any other renderer's forward pass.
// The includer has defined ProjectionParams, FilterParams, BiasParams, and the functions
//   uint project(ShadowViews views, ProjectionParams params, vec3 position_ws, out uint layers[2], out float weights[2])
//        which layers hold the point (0: outside every layer, which is lit) and how much each counts
//   float lit(uint map_image, MapSample at, FilterParams params)
//   float filter_radius(FilterParams params)      texels that the kernel reaches from its middle
// and, where its views are paraboloids (k_view_paraboloid), the macro GNOMON_PROJECTION_PARABOLOID.
// It needs of the outside world: the bindless set, and the addresses below.
#ifndef GNOMON_VISIBILITY_GLSL
#define GNOMON_VISIBILITY_GLSL
#include "shadow/map/glsl/map_sample.glsl"

// 1 lit, 0 shadowed.
float visibility(ShadowViews views, uint map_image, ProjectionParams projection, FilterParams map_filter, BiasParams bias,
                 Receiver receiver) {
  uint layers[2];
  float weights[2];
  uint count = project(views, projection, receiver.position_ws, layers, weights);
  if (count == 0u) return 1.0;
  float radius = filter_radius(map_filter);
  float sum = 0.0;
  for (uint i = 0u; i < count; ++i) {
    sum += weights[i] * lit(map_image, sample_of(views, layers[i], bias, radius, receiver), map_filter);
  }
  return sum;
}

#endif
