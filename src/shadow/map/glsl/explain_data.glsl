// What the kernels that explain a technique read and write, for C++ and shaders.
#ifndef GNOMON_EXPLAIN_DATA_GLSL
#define GNOMON_EXPLAIN_DATA_GLSL
#include "shadow/map/glsl/map_data.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

// What an overlay shows of each visible surface.
shared_constant uint k_overlay_none = 0u;
shared_constant uint k_overlay_layers = 1u;     // which layers (cascades, faces) hold it
shared_constant uint k_overlay_texels = 2u;     // the borders of the map's texels
shared_constant uint k_overlay_footprint = 3u;  // how many pixels a texel spans
shared_constant uint k_overlay_flags = 4u;      // k_flag_*
shared_constant uint k_overlay_overdraw = 5u;   // how often the surface pass wrote the pixel
shared_constant uint k_overlay_count = 6u;

// The first that applies.
shared_constant uint k_flag_beyond = 0u;     // outside the light's range, cone or beam
shared_constant uint k_flag_away = 1u;       // its geometric normal faces away from the light
shared_constant uint k_flag_outside = 2u;    // no layer of the map holds it: lit
shared_constant uint k_flag_receiver = 3u;   // receives, and does not cast
shared_constant uint k_flag_caster = 4u;     // receives and casts
shared_constant uint k_flag_count = 5u;

// Hue from 0 to 1: red, yellow, green, cyan, blue, magenta, red.
inline_function vec3 hue_colour(float hue) {
  vec3 ramp = abs(fract(vec3(hue) + vec3(1.0f, 2.0f / 3.0f, 1.0f / 3.0f)) * 6.0f - 3.0f) - 1.0f;
  return clamp(ramp, 0.0f, 1.0f);
}
// Neighbours differ by the golden angle.
inline_function vec3 layer_colour(uint layer) { return 0.15f + 0.85f * hue_colour(0.381966f * float(layer)); }
inline_function vec3 flag_colour(uint flag) {
  if (flag == k_flag_beyond) return vec3(0.45f, 0.25f, 0.65f);
  if (flag == k_flag_away) return vec3(0.15f, 0.25f, 0.70f);
  if (flag == k_flag_outside) return vec3(1.0f, 0.35f, 0.05f);
  if (flag == k_flag_receiver) return vec3(0.10f, 0.85f, 0.85f);
  return vec3(0.35f, 0.85f, 0.25f);
}
// From blue over green to red.
inline_function vec3 ramp_colour(float t) { return hue_colour((1.0f - clamp(t, 0.0f, 1.0f)) * 2.0f / 3.0f); }
// Side of a texel in pixels: 1/8 and less is blue, 1 green, 8 and more red.
inline_function float footprint_place(float log2_pixels) { return (log2_pixels + 3.0f) / 6.0f; }
// 1 is blue, 8 and more red.
inline_function float overdraw_place(float count) { return (count - 1.0f) / 7.0f; }

struct ExplainArguments {
  // Addresses.
  uint64_t frame, views, projection, bias, radius, mask, output_words;  // output_words: the display, or the record of a pick
  uvec2 pixel;        // of a pick
  uint light;
  uint overlay;       // k_overlay_*; k_overlay_none: a pick
  float opacity;
  uint depth_image, filtered_image, object_image, overdraw_image;  // bindless indices
  uint flags;         // k_explain_*
};
shared_constant uint k_explain_multisampled = 1u;  // the depth map; its first sample is read
shared_constant uint k_explain_integers = 2u;      // what the filter stores
shared_constant uint k_explain_objects = 4u;       // object_image is there

// Texels along a side of the square around the point that a pick reads.
shared_constant uint k_pick_side = 15u;
shared_constant uint k_pick_texels = 225u;
shared_constant float k_pick_outside = 2.0f;  // stands for the depth of a texel beyond the map's edge

// One layer's part in a point's answer.
struct PickedLayer {
  uint layer;
  float weight;
  vec2 uv;                      // biased, as the filter sees it
  float depth, linear;          // of the receiver: biased; map units, and [0, 1]
  float unbiased_depth, unbiased_linear;
  uint follows_plane;           // bias.receiver_plane
  vec2 depth_gradient;          // as the filter sees it: zero where the bias does not follow the plane
  vec2 plane_gradient;          // of the receiver's own plane, d depth / d uv
  vec2 plane_linear_gradient;   // the same of linear depth
  float plane_move;             // limit of following the plane, map units
  float bias_linear;            // how far toward the light the biases moved the receiver's plane, as linear depth
  float texel_m, size;
  float depth_range_m, depth_near_m;
  float pixels_per_texel;       // side of a texel in the picture; 0 where the pixel's own reach is not known
  int texel_x, texel_y;         // that holds the point
  uint object;                  // that the map stores there, + 1; 0 where it stores none
  vec4 stored;                  // what the filter stores there
  vec4 linear_numerator, linear_denominator;
  float depths[k_pick_texels];  // of the map around the texel, rows from low v to high; 1: no caster
};

struct PickRecord {
  uint seen;               // 0: sky
  uint receives;           // 0: faces away from the light, or is beyond its reach
  uint count;              // of layers
  uint item;               // draw item
  uint object;
  uint casts;
  float facing;            // cosine of the angle between normal and light
  float answer;            // the mask
  float view_depth;        // metres along the viewer's axis
  float last_split;        // where the last layer ends there; 0 without a map
  float radius;            // texels that the filter's kernel reaches from its middle
  float eye_distance;
  vec3 position_ws;
  vec3 normal_ws;
  PickedLayer layers[2];
};

#ifdef __cplusplus
}  // namespace gnomon
#endif

#endif
