// Where the surface that a texel holds lay in the last frame's map. A surface has a place in both maps, whatever moved: the
// viewer, whom cascades follow, or the light itself. So what is blended are two looks at one surface; what smears are surfaces
// that only one of them saw.
#ifndef GNOMON_HISTORY_GLSL
#define GNOMON_HISTORY_GLSL
#include "shadow/map/glsl/map_data.glsl"

// The last map does not know this layer, or it is a paraboloid that moved: lines are arcs there.
const uint k_history_none = 0u;
const uint k_history_same = 1u;   // the same view: texel for texel
const uint k_history_moved = 2u;

// Of a whole layer.
uint history_of(ShadowView now, ShadowView last) {
  if (now.raster.in_use == 0u || last.raster.in_use == 0u || now.raster.kind != last.raster.kind) return k_history_none;
  if (now.raster.clip_from_world == last.raster.clip_from_world && now.raster.near_m == last.raster.near_m &&
      now.raster.far_m == last.raster.far_m) {
    return k_history_same;
  }
  return now.raster.kind == k_view_projective ? k_history_moved : k_history_none;
}

// uv and depth in the map `to` of what the map `from` has at (uv, depth). False where `to` cannot see it.
bool seen_from(ShadowView from, ShadowView to, vec3 place, out vec3 result) {
  vec4 world = from.world_from_clip * vec4(place.xy * 2.0 - 1.0, place.z, 1.0);
  vec4 clip = to.raster.clip_from_world * vec4(world.xyz / world.w, 1.0);
  result = vec3(clip.xy / clip.w * 0.5 + 0.5, clip.z / clip.w);
  return clip.w > 0.0 && all(greaterThanEqual(result.xy, vec2(0.0))) && all(lessThanEqual(result.xy, vec2(1.0)));
}

#endif
