// A receiver's place in a layer of the map. Where the views are paraboloids (k_view_paraboloid), the includer has defined the
// macro GNOMON_PROJECTION_PARABOLOID.
#ifndef GNOMON_MAP_SAMPLE_GLSL
#define GNOMON_MAP_SAMPLE_GLSL
#include "shadow/map/glsl/bias.glsl"

// A receiver, as the caller knows it.
struct Receiver {
  vec3 position_ws, normal_ws;  // geometric normal, unit
  vec3 to_light;                // unit
  vec3 pixel_x_ws, pixel_y_ws;  // from the point to where its neighbouring pixels see the receiver's plane; zero: no mips
  uint object, item;            // index of its object, of its draw item, + 1
  uint object_image;            // where the map stores which object is nearest to the light
  vec2 noise;                   // [0, 1), different in neighbouring pixels
};

// Of the rasteriser's interpolation and of the receiver's own projection together.
const float k_depth_rounding = 5.0e-7;

// Known to the compiler, unlike LightView::kind.
#ifdef GNOMON_PROJECTION_PARABOLOID
const bool k_projective = false;
vec4 map_clip(ShadowView view, vec3 position_ws) { return light_clip(view.raster, position_ws); }
#else
const bool k_projective = true;
vec4 map_clip(ShadowView view, vec3 position_ws) { return view.raster.clip_from_world * vec4(position_ws, 1.0); }
#endif

vec2 light_uv(ShadowView view, vec3 position_ws) {
  vec4 clip = map_clip(view, position_ws);
  return clip.xy / clip.w * 0.5 + 0.5;
}

// A paraboloid bends planes: the gradient is a difference of two points of the plane, one pixel of the map apart.
vec2 paraboloid_gradient(ShadowView view, vec3 position_ws, vec3 normal_ws, float texel_m) {
  vec3 along = normalize(cross(normal_ws, abs(normal_ws.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  vec3 a = map_clip(view, position_ws).xyz;
  vec3 b = map_clip(view, position_ws + along * texel_m).xyz - a;
  vec3 c = map_clip(view, position_ws + cross(normal_ws, along) * texel_m).xyz - a;
  float area = b.x * c.y - b.y * c.x;
  if (abs(area) < 1e-14) return vec2(0.0);
  return 2.0 * vec2(b.z * c.y - c.z * b.y, c.z * b.x - b.z * c.x) / area;
}

MapSample sample_of(ShadowViews views, uint layer, BiasParams bias, float radius, Receiver receiver) {
  ShadowView view = views.v[layer];
  MapSample at;
  at.layer = layer;
  at.size = view.size;
  float w = k_projective ? (view.raster.clip_from_world * vec4(receiver.position_ws, 1.0)).w
                         : length(receiver.position_ws - view.origin_ws);
  at.texel_m = max(view.texel_m, view.texel_along_m * w) * max(w, 0.0);
  vec3 moved = biased_position(bias, receiver.position_ws, receiver.normal_ws, receiver.to_light, at.texel_m, radius, layer);
  vec4 clip = map_clip(view, moved);
  vec3 ndc = clip.xyz / clip.w;
  at.uv = ndc.xy * 0.5 + 0.5;
  // Depths of 32 bits are exact to some 1e-7 only, which far from a perspective's near plane is millimetres: more than a small
  // bias. Beyond the far plane compares as the far plane itself: what the map does not reach is lit.
  at.depth = min(ndc.z - k_depth_rounding, 1.0);
  at.linear_numerator = view.linear_numerator;
  at.linear_denominator = view.linear_denominator;
  at.linear = linear_depth(at.linear_numerator, at.linear_denominator, at.uv, at.depth);
  at.depth_gradient = at.linear_gradient = vec2(0.0);
  at.plane_move = 0.0;
  if (bias.receiver_plane != 0u) {
    at.depth_gradient = k_projective ? plane_depth_gradient(view.world_from_clip, moved, receiver.normal_ws)
                                   : paraboloid_gradient(view, moved, receiver.normal_ws, at.texel_m);
    // Of a ratio of two affine functions of (u, v, depth).
    vec4 ndc1 = vec4(ndc.xy, at.depth, 1.0);
    float below = dot(view.linear_denominator, ndc1);
    vec4 change = (view.linear_numerator - at.linear * view.linear_denominator) / below;
    at.linear_gradient = 2.0 * change.xy + change.z * at.depth_gradient;
    // Metres to the map's depth, along the plane.
    float steepness_m = length(at.linear_gradient) * view.depth_range_m;
    at.plane_move = steepness_m > 0.0 ? bias.plane_limit * at.texel_m * length(at.depth_gradient) / steepness_m : 0.0;
  }
  at.footprint_x = at.footprint_y = vec2(0.0);
  if (receiver.pixel_x_ws != vec3(0.0)) {
    at.footprint_x = light_uv(view, moved + receiver.pixel_x_ws) - at.uv;
    at.footprint_y = light_uv(view, moved + receiver.pixel_y_ws) - at.uv;
  }
  at.depth_range_m = view.depth_range_m;
  at.depth_near_m = view.depth_near_m;
  at.emitter_radius = views.map.emitter_radius;
  at.parallel = views.map.parallel != 0u;
  at.noise = receiver.noise;
  at.object = receiver.object;
  at.item = receiver.item;
  at.object_image = receiver.object_image;
  return at;
}

#endif
