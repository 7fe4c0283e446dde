// What a projection and a filter exchange, for C++ and shaders. A projection never asks who reads the sample; a filter never
// asks which projection made it.
#ifndef GNOMON_MAP_DATA_GLSL
#define GNOMON_MAP_DATA_GLSL
#include "frame/glsl/light_view.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

shared_constant uint k_max_layers = 8u;

// One layer of the map as seen from the light. Depth in the map runs from 0 (near the light) to 1. Linear depth runs from 0 to
// 1 in proportion to metres: dot(linear_numerator, (ndc, 1)) / dot(linear_denominator, (ndc, 1)) turns the map's depth into it,
// at any place of the map, so that filters may store something that blurs correctly under perspective and warps.
struct ShadowView {
  LightView raster;
  mat4 world_from_clip;     // projective views
  vec4 linear_numerator;
  vec4 linear_denominator;
  vec3 origin_ws;           // of the light; perspective and paraboloid views
  float depth_range_m;      // metres from linear depth 0 to 1
  float depth_near_m;       // metres from the light (perspective) or the light's first plane to linear depth 0
  float texel_m;            // side of a texel where clip w is 1, metres (the larger side); paraboloid: at 1 m on the axis
  float size;               // texels along a side
  float border;             // texels at each edge that only wide kernels may read
  float texel_along_m;      // warped views: side of a texel along the warp where clip w is 1; it grows with the square of w.
                            // Others: 0
  vec2 interval_m;          // distances along the viewer's axis that the layer is fitted to
  float unused;
};

// What all layers share.
struct ShadowMapData {
  vec4 eye_depth;        // dot with (position, 1): metres along the viewer's axis
  float emitter_radius;  // as in LightShape
  uint parallel;         // 1: directional and projector lights
  uint layers;           // in use, of those that the map has
  float unused;
};

#ifdef __cplusplus
static_assert(sizeof(ShadowView) % 16 == 0 && sizeof(ShadowMapData) % 16 == 0, "shaders address them in units of 16 bytes");
}  // namespace gnomon
#else
layout(buffer_reference, scalar) readonly buffer ShadowViews {
  ShadowMapData map;
  ShadowView v[];
};

// Where a surface point falls into the map. Footprint, noise, objects and their image are zero unless the filter's GLSL defines
// GNOMON_FILTER_FOOTPRINT, GNOMON_FILTER_NOISE, GNOMON_FILTER_OBJECT.
struct MapSample {
  uint layer;
  vec2 uv;
  float depth;           // of the receiver, in the map's units, biased
  float linear;          // the same as linear depth, [0, 1] between the first caster and the last receiver
  float size;            // texels along a side
  vec2 depth_gradient;   // d depth / d uv along the receiver's plane; zero when the bias does not follow the plane
  vec2 linear_gradient;  // the same of `linear`
  float plane_move;      // most that following the plane may change `depth` (bias.plane_limit)
  vec2 footprint_x;      // uv from this pixel to the one beside it, on the receiver's plane: for mips and anisotropy
  vec2 footprint_y;
  vec4 linear_numerator, linear_denominator;
  float depth_range_m;   // metres from linear depth 0 to 1
  float depth_near_m;
  float texel_m;         // side of a texel at the receiver
  float emitter_radius;  // of the light: metres, or for parallel lights metres of penumbra radius per metre of gap
  bool parallel;
  uint object, item;     // of the receiver: index of its object, of its draw item, + 1
  uint object_image;     // what the map stores of them (Filter::object_ids)
  vec2 noise;            // two numbers in [0, 1) that differ between neighbouring pixels, fixed for each pixel
};

float linear_depth(vec4 numerator, vec4 denominator, vec2 uv, float depth) {
  vec4 ndc = vec4(uv * 2.0 - 1.0, depth, 1.0);
  return dot(numerator, ndc) / dot(denominator, ndc);
}

#endif
#endif
