// visibility(): the whole map technique as one function, for gnomon's kernel and for any other renderer's forward pass.
// The includer has defined ProjectionParams, FilterParams, BiasParams, and the two functions
//   uint project(ShadowViews views, ProjectionParams params, vec3 position_ws, out uint layers[2], out float weights[2])
//        which layers hold the point (0: outside every layer, which is lit) and how much each counts
//   float lit(uint map_image, MapSample at, FilterParams params)
// It needs of the outside world: the bindless set, and the addresses below.
#ifndef GNOMON_VISIBILITY_GLSL
#define GNOMON_VISIBILITY_GLSL
#include "shadow/map/glsl/bias.glsl"

// 1 lit, 0 shadowed. `to_light`: unit.
float visibility(ShadowViews views, uint map_image, ProjectionParams projection, FilterParams map_filter, BiasParams bias, vec3 position_ws,
                 vec3 normal_ws, vec3 to_light) {
  uint layers[2];
  float weights[2];
  uint count = project(views, projection, position_ws, layers, weights);
  if (count == 0u) return 1.0;
  vec2 slope = receiver_slope(bias, normal_ws, to_light);
  float sum = 0.0;
  for (uint i = 0u; i < count; ++i) {
    ShadowView view = views.v[layers[i]];
    vec3 moved = offset_position(bias, position_ws, normal_ws, slope.x, view.texel_m);
    vec4 clip = view.clip_from_world * vec4(moved, 1.0);
    vec3 ndc = clip.xyz / clip.w;
    MapSample at;
    at.layer = layers[i];
    at.uv = ndc.xy * 0.5 + 0.5;
    // Beyond the far plane compares as the far plane itself: what the map does not reach is lit.
    at.depth = min(ndc.z, 1.0) - depth_bias_m(bias, slope.y, view.texel_m) / view.depth_range_m;
    at.depth_m = at.depth * view.depth_range_m;
    at.texel_m = view.texel_m;
    at.size = view.size;
    at.depth_gradient = bias.receiver_plane != 0u ? plane_depth_gradient(view.clip_from_world, normal_ws) : vec2(0.0);
    at.weight = weights[i];
    sum += weights[i] * lit(map_image, at, map_filter);
  }
  return sum;
}

#endif
