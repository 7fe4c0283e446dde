// The vertex shader of casters. The including file says how layers are reached (CASTER_PER_LAYER, CASTER_VERTEX_LAYER,
// CASTER_GEOMETRY, CASTER_MULTIVIEW), and with CASTER_ATTRIBUTES that a fragment shader wants them.
#include "frame/casters/draw/caster_pass.glsl"

#ifdef CASTER_ATTRIBUTES
#include "frame/casters/draw/caster_alpha.glsl"
layout(location = 0) out vec2 texel;
layout(location = 1) flat out uint item_index;
layout(location = 3) flat out AlphaLookup lookup;
#endif
#ifdef CASTER_GEOMETRY
layout(location = 2) flat out uint layer_mask;
#endif

void main() {
  uint item = item_of(gl_InstanceIndex);
  vec3 position_ws = to_world(pass.scene.items.v[item], pass.scene.positions.v[gl_VertexIndex]);
#ifdef CASTER_ATTRIBUTES
  lookup = alpha_lookup(pass.scene.materials.v[pass.scene.items.v[item].material], pass.scene.attributes.v[gl_VertexIndex].uv,
                        texel);
  item_index = item;
#endif
#if defined(CASTER_PER_LAYER)
  gl_Position = clip_in_layer(0u, position_ws);
#elif defined(CASTER_VERTEX_LAYER)
  gl_Layer = int(tag_of(gl_InstanceIndex));
  gl_Position = clip_in_layer(tag_of(gl_InstanceIndex), position_ws);
#elif defined(CASTER_MULTIVIEW)
  // Draws go into every layer, also one that this frame does not need: triangles without area leave it empty.
  LightView view = light_view(pass.views, pass.stride, gl_ViewIndex).v;
  gl_Position = view.in_use != 0u ? light_clip(view, position_ws) : vec4(2.0, 2.0, 2.0, 1.0);
#else
  layer_mask = tag_of(gl_InstanceIndex);
  gl_Position = vec4(position_ws, 1.0);
#endif
}
