// How a layer of a shadow map is drawn: what the raster and the culling of casters know of a projection.
#ifndef GNOMON_LIGHT_VIEW_GLSL
#define GNOMON_LIGHT_VIEW_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

shared_constant uint k_view_projective = 0u;  // clip_from_world says all
// One half of all directions around a point onto a disc of radius `rim` (Brabec, Annen and Seidel 2002): clip_from_world is a
// rigid transform to the light's axes (the half space looks along +z) whose last row is (0, 0, 0, rim); depth is the distance.
// Beyond the rim lies the beginning of the other half, for kernels.
shared_constant uint k_view_paraboloid = 1u;

struct LightView {
  mat4 clip_from_world;
  uint kind;     // k_view_*
  float near_m;  // paraboloid: distances at depth 0 and 1
  float far_m;
  uint in_use;   // 0: this frame does not need the layer; nothing is drawn into it
  // Where |x| and |y| of clip space stay below this, every point of the column is served by this layer or a finer one (a lower
  // number): what casts only there need not be drawn into coarser layers. 0: nowhere.
  float served;
  float kernel_m;  // how far from a point's own place its kernel reads in this layer, metres
  float texel_clip;  // paraboloid: a texel's side in clip space
  uint unused;
};

// Clip-space radius of the directions across the axis.
inline_function float paraboloid_rim(LightView view) { return view.clip_from_world[3][3]; }

// Cosine of the angle from the axis to the middle of the map's edge: tan(angle / 2) = 1 / rim.
inline_function float paraboloid_edge(float rim) { return (rim * rim - 1.0f) / (rim * rim + 1.0f); }

// Position in the view's clip space; depth runs from 0 (near the light) to 1.
inline_function vec4 light_clip(LightView view, vec3 position_ws) {
  vec4 p = view.clip_from_world * vec4(position_ws, 1.0f);
  if (view.kind == k_view_projective) return p;
  float distance_m = length(vec3(p.x, p.y, p.z));
  // (x, y) / (distance + z) = tan(angle / 2). w = 1: lines become arcs only between vertices.
  float scale = p.w / max(distance_m + p.z, 1e-4f * distance_m + 1e-20f);
  // What lies behind leaves through the far plane: a triangle around the back of the axis would cover the whole disc.
  float behind = 4.0f * max(-p.z / (distance_m + 1e-20f) - 0.25f, 0.0f);
  return vec4(p.x * scale, p.y * scale, (distance_m - view.near_m) / (view.far_m - view.near_m) + behind, 1.0f);
}

#ifdef __cplusplus
}  // namespace gnomon
#else
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
// One view; a map's views lie a stride apart, a multiple of 16 bytes: drivers read vectors at once where they may.
layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer LightViewRef { LightView v; };
LightViewRef light_view(uint64_t first, uint stride, uint layer) { return LightViewRef(first + uint64_t(stride) * layer); }
#endif

#endif
