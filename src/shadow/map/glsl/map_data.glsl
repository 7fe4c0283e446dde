// What a projection and a filter exchange, for C++ and shaders. A projection never asks who reads the sample; a filter never asks
// which projection made it.
#ifndef GNOMON_MAP_DATA_GLSL
#define GNOMON_MAP_DATA_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

// One layer of the map as seen from the light. Depth in the map runs from 0 (near the light) to 1.
struct ShadowView {
  mat4 clip_from_world;
  float texel_m;        // side of a texel at the receiver, metres (the larger side)
  float depth_range_m;  // metres from depth 0 to depth 1
  float size;           // texels along a side
  float unused;
};

#ifdef __cplusplus
}  // namespace gnomon
#else
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
layout(buffer_reference, scalar) readonly buffer ShadowViews { ShadowView v[]; };

// Where a surface point falls into the map.
struct MapSample {
  uint layer;
  vec2 uv;
  float depth;           // of the receiver, in the map's units, biased
  float depth_m;         // the same in metres from the map's near plane
  float texel_m;
  float size;            // texels along a side
  vec2 depth_gradient;   // d depth / d uv along the receiver's plane; zero when the bias does not follow the plane
  float weight;          // of this sample where two blend
};

#endif
#endif
