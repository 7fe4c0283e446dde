// Casters in paraboloid views, exactly: each triangle becomes the box of its true outline on the disc, and the fragment shader
// intersects each texel's ray with it. (Bending at the vertices, as Brabec et al. 2002 draw, misplaces edges and depths of
// triangles that are large as seen from the light; the box around the curved outline follows Gascuel et al. 2008.)
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/casters/draw/caster_alpha.glsl"
#include "frame/casters/draw/caster_pass.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 8) out;  // four for each of two halves

layout(location = 0) in vec2 texel_in[];
layout(location = 1) flat in uint item_in[];
layout(location = 2) flat in uint layer_mask[];
layout(location = 3) flat in AlphaLookup lookup_in[];

layout(location = 0) flat out vec2 disc_of_texel;  // scale, offset
layout(location = 1) flat out uint item_index;
layout(location = 2) flat out vec3 corner_a;  // in the light's axes
layout(location = 3) flat out vec3 corner_b;
layout(location = 4) flat out vec3 corner_c;
layout(location = 5) flat out vec2 texel_a;
layout(location = 6) flat out vec2 texel_b;
layout(location = 7) flat out vec2 texel_c;
layout(location = 8) flat out vec2 depths;    // near_m, far_m
layout(location = 9) flat out AlphaLookup lookup;

vec2 on_disc(vec3 p) { return p.xy / max(length(p) + p.z, 1e-20); }
vec3 on_sphere(vec2 d) { return vec3(2.0 * d, 1.0 - dot(d, d)); }  // not unit

// Of places on the disc; empty where low is above high.
struct Box {
  vec2 low, high;
};
// Of the disc: below half a texel of a map of 2048.
const float k_small = 5e-4;
const Box k_nothing = Box(vec2(1e30), vec2(-1e30));
void add(inout Box box, vec2 at) { box.low = min(box.low, at), box.high = max(box.high, at); }

// Whether a direction on the great circle with normal n lies between a and b.
bool on_arc(vec3 a, vec3 b, vec3 n, vec3 direction) {
  return dot(cross(a, direction), n) >= 0.0 && dot(cross(direction, b), n) >= 0.0;
}

// How far an arc over that chord leaves it at most. An arc's radius is 1 / |n.z|, and more than its chord.
float bulge(vec2 chord, float n_z) { return 0.25 * dot(chord, chord) * abs(n_z); }

// Adds the part of the edge from a to b that lies on the disc of radius `reach`: an arc of the circle around n.xy / n.z with
// radius 1 / |n.z|, since great circles stay circles. `edge`: cosine of the disc's rim. False where the edge passes the light:
// its arc is any.
bool add_edge(vec3 a, vec3 b, float reach, float edge, inout Box box) {
  Box arc = k_nothing;
  if (a.z >= edge * length(a)) add(arc, on_disc(a));
  if (b.z >= edge * length(b)) add(arc, on_disc(b));
  vec3 n = cross(a, b);
  float size = length(n);
  bool is_point = size <= 1e-6 * length(a) * length(b);
  if (!is_point) {
    n /= size;
    // Where the great circle crosses the rim.
    float tilt = max(dot(n.xy, n.xy), 1e-12), along = -n.z * edge / tilt, across = (1.0 - edge * edge) / tilt - along * along;
    for (int i = 0; i < 2 && across > 0.0; ++i) {
      vec3 direction = vec3(along * n.xy + (i == 0 ? 1.0 : -1.0) * sqrt(across) * vec2(-n.y, n.x), edge);
      if (on_arc(a, b, n, direction)) add(arc, on_disc(direction));
    }
    if (abs(n.z) < 0.05) {  // almost straight
      float margin = arc.low.x <= arc.high.x ? bulge(arc.high - arc.low, n.z) : 0.0;
      arc.low -= margin, arc.high += margin;
    } else {
      for (int i = 0; i < 4; ++i) {
        vec2 extreme = n.xy / n.z;
        extreme[i & 1] += (i < 2 ? 1.0 : -1.0) / n.z;
        if (dot(extreme, extreme) <= reach * reach && on_arc(a, b, n, on_sphere(extreme))) add(arc, extreme);
      }
    }
  }
  box.low = min(box.low, arc.low), box.high = max(box.high, arc.high);
  return !is_point || dot(a, b) > 0.0;
}

// The part of the triangle's outline that lies on the disc of radius `reach`, in a box.
Box outline(vec3 a, vec3 b, vec3 c, float reach) {
  float edge = (1.0 - reach * reach) / (1.0 + reach * reach);
  Box box = k_nothing;
  if (a.z >= edge * length(a) && b.z >= edge * length(b) && c.z >= edge * length(c)) {
    add(box, on_disc(a)), add(box, on_disc(b)), add(box, on_disc(c));
    // Most triangles: so small that their arcs need not be looked at.
    float margin = bulge(box.high - box.low, 1.0);
    if (margin < k_small) return Box(box.low - margin, box.high + margin);
  }
  if (!(add_edge(a, b, reach, edge, box) && add_edge(b, c, reach, edge, box) && add_edge(c, a, reach, edge, box))) {
    return Box(vec2(-reach), vec2(reach));
  }
  // What lies inside reaches as far as the rim.
  float side = dot(cross(a, b), c) < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 4; ++i) {
    vec2 at = vec2(0.0);
    at[i & 1] = i < 2 ? reach : -reach;
    vec3 direction = on_sphere(at);
    if (side * dot(cross(a, b), direction) >= 0.0 && side * dot(cross(b, c), direction) >= 0.0 &&
        side * dot(cross(c, a), direction) >= 0.0)
      add(box, at);
  }
  return box;
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
    // The square's corners lie farther out than its edges.
    Box box = outline(a, b, c, sqrt(2.0) / rim);
    // A margin for rounding, the rasteriser's to a 256th of a texel, too.
    float margin = max(2e-5, view.texel_clip / 256.0);
    vec2 low = box.low * rim - margin, high = box.high * rim + margin;
    if (any(greaterThan(low, vec2(1.0))) || any(lessThan(high, vec2(-1.0)))) continue;
    low = max(low, vec2(-1.0)), high = min(high, vec2(1.0));
    // Wound as the triangle is seen from the light, for the culling of faces.
    bool turned = dot(cross(a, b), c) < 0.0;
    for (int i = 0; i < 4; ++i) {
      bool right = (i & 1) == 1, bottom = (i & 2) == 2;
      vec2 at = turned ? vec2(bottom ? high.x : low.x, right ? high.y : low.y)
                       : vec2(right ? high.x : low.x, bottom ? high.y : low.y);
      gl_Layer = int(layer);
      gl_Position = vec4(at, 0.5, 1.0);
      disc_of_texel = vec2(view.texel_clip, -1.0) / rim;
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
