// Casters in paraboloid views, exactly: each triangle becomes the box of its true outline on the disc, and the fragment shader
// intersects each texel's ray with it. (Bending at the vertices, as Brabec et al. 2002 draw, misplaces edges and depths of triangles
// that are large as seen from the light; the box around the curved outline follows Gascuel et al. 2008.)
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/caster_alpha.glsl"
#include "frame/glsl/caster_pass.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 8) out;  // four for each of two halves

layout(location = 0) in vec2 texel_in[];
layout(location = 1) flat in uint item_in[];
layout(location = 2) flat in uint layer_mask[];
layout(location = 3) flat in AlphaLookup lookup_in[];

layout(location = 0) out vec2 disc;           // tan(angle / 2) along x and y
layout(location = 1) flat out uint item_index;
layout(location = 2) flat out vec3 corner_a;  // in the light's axes
layout(location = 3) flat out vec3 corner_b;
layout(location = 4) flat out vec3 corner_c;
layout(location = 5) flat out vec2 texel_a;
layout(location = 6) flat out vec2 texel_b;
layout(location = 7) flat out vec2 texel_c;
layout(location = 8) flat out vec2 depths;    // near_m, far_m
layout(location = 9) flat out AlphaLookup lookup;

// tan(angle / 2) beyond which a corner counts as behind: the box is then the whole map.
const float k_behind = 3.0;

vec2 on_disc(vec3 p) { return p.xy / max(length(p) + p.z, 1e-20); }
bool is_behind(vec3 p) { return length(p.xy) > k_behind * (length(p) + p.z); }
vec3 on_sphere(vec2 d) { return vec3(2.0 * d, 1.0 - dot(d, d)); }  // not unit

// The edge from a to b is an arc of the circle around n.xy / n.z with radius 1 / |n.z|: great circles stay circles.
void add_edge(vec3 a, vec3 b, inout vec2 low, inout vec2 high, inout bool everything) {
  vec3 middle = normalize(a) + normalize(b);
  vec3 n = cross(a, b);
  float size = length(n);
  if (is_behind(a) || is_behind(b) || is_behind(middle)) everything = true;
  if (everything || size == 0.0) return;
  n /= size;
  vec2 from = on_disc(a), to = on_disc(b);
  if (abs(n.z) < 0.05) {
    // Almost straight: how far the arc leaves its chord, at most.
    vec2 bulge = vec2(0.25 * dot(to - from, to - from) * abs(n.z));
    low = min(low, min(from, to) - bulge), high = max(high, max(from, to) + bulge);
    return;
  }
  for (int i = 0; i < 4; ++i) {
    vec2 extreme = n.xy / n.z;
    extreme[i & 1] += (i < 2 ? 1.0 : -1.0) / n.z;
    vec3 direction = on_sphere(extreme);
    if (dot(cross(a, direction), n) < 0.0 || dot(cross(direction, b), n) < 0.0) continue;  // of the circle, not of the arc
    low = min(low, extreme), high = max(high, extreme);
  }
}

void main() {
  for (uint layer = 0u; layer < min(pass.layers, 2u); ++layer) {
    if ((layer_mask[0] & (1u << layer)) == 0u) continue;
    LightView view = light_view(pass.views, pass.stride, layer).v;
    vec3 a = (view.clip_from_world * vec4(gl_in[0].gl_Position.xyz, 1.0)).xyz;
    vec3 b = (view.clip_from_world * vec4(gl_in[1].gl_Position.xyz, 1.0)).xyz;
    vec3 c = (view.clip_from_world * vec4(gl_in[2].gl_Position.xyz, 1.0)).xyz;
    float rim = paraboloid_rim(view), edge = paraboloid_edge(rim);
    if (a.z < edge * length(a) && b.z < edge * length(b) && c.z < edge * length(c)) continue;
    vec2 low = min(min(on_disc(a), on_disc(b)), on_disc(c)), high = max(max(on_disc(a), on_disc(b)), on_disc(c));
    bool everything = false;
    add_edge(a, b, low, high, everything);
    add_edge(b, c, low, high, everything);
    add_edge(c, a, low, high, everything);
    // A margin for rounding, small against a texel.
    low = everything ? vec2(-1.0) : low * rim - 2e-5, high = everything ? vec2(1.0) : high * rim + 2e-5;
    if (any(greaterThan(low, vec2(1.0))) || any(lessThan(high, vec2(-1.0)))) continue;
    low = max(low, vec2(-1.0)), high = min(high, vec2(1.0));
    // Wound as the triangle is seen from the light, for the culling of faces.
    bool turned = dot(cross(a, b), c) < 0.0;
    for (int i = 0; i < 4; ++i) {
      bool right = (i & 1) == 1, bottom = (i & 2) == 2;
      vec2 at = turned ? vec2(bottom ? high.x : low.x, right ? high.y : low.y) : vec2(right ? high.x : low.x, bottom ? high.y : low.y);
      gl_Layer = int(layer);
      gl_Position = vec4(at, 0.5, 1.0);
      disc = at / rim;
      item_index = item_in[0];
      corner_a = a, corner_b = b, corner_c = c;
      texel_a = texel_in[0], texel_b = texel_in[1], texel_c = texel_in[2];
      lookup = lookup_in[0];
      depths = vec2(view.near_m, view.far_m);
      EmitVertex();
    }
    EndPrimitive();
  }
}
