// What C++ and shaders share of a frame: scene, camera, lights, surface buffer. Scalar layout; addresses are 8 bytes.
#ifndef GNOMON_FRAME_DATA_GLSL
#define GNOMON_FRAME_DATA_GLSL
#include "base/glsl/light_sampling.glsl"
#ifdef __cplusplus
#define ADDRESS(type) uint64_t
namespace gnomon {
#else
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#define ADDRESS(type) type##s
#endif

// One part of one object, as drawn. Items are sorted by bucket (frame/gpu_scene.h).
struct DrawItem {
  vec4 world_from_object_x;  // rows of the 3x4 matrix
  vec4 world_from_object_y;
  vec4 world_from_object_z;
  vec3 bounds_min_ws;
  uint first_index;
  vec3 bounds_max_ws;
  uint index_count;
  uint first_vertex;
  uint material;
  uint object;
  uint flags;  // k_item_*
};
shared_constant uint k_item_casts = 1u;
shared_constant uint k_item_mirrored = 2u;
// Items that are drawn with the same state lie together (frame/gpu_scene.h).
shared_constant uint k_bucket_count = 8u;

struct VertexAttributes {
  vec2 uv;
  uint normal;   // octahedral, 2 x snorm16
  uint tangent;  // octahedral, 2 x snorm16; the lowest bit is the handedness
  uint colour;   // RGBA8, linear
};

struct MaterialData {
  vec4 base_colour;
  vec3 base_uv_u, base_uv_v, normal_uv_u, normal_uv_v;  // rows of the 2x3 uv transforms
  uint base_texture, normal_texture;                    // bindless indices, or k_no_texture_index
  uint caster_texture;                                  // whose alpha decides what casts; sampled as base_texture is
  uint base_sampler, normal_sampler;
  uint base_wrap_u, base_wrap_v;
  float seen_cutoff, caster_cutoff;  // least alpha that the camera sees, and that casts; below 0: whatever the alpha
  float normal_scale;
  float shininess;
  vec3 specular;
  vec3 emissive;
};
shared_constant uint k_no_texture_index = 0xffffffffu;

struct DrawCommand {  // VkDrawIndexedIndirectCommand
  uint index_count, instance_count, first_index;
  int vertex_offset;
  uint first_instance;
};

// A light with its shading; the shape is what visibility is about.
struct LightData {
  LightShape shape;
  vec3 radiance;  // colour * intensity
  float cos_inner_cone;
};

struct CameraData {
  mat4 clip_from_world;  // reversed Z: near plane at depth 1
  vec3 eye_ws;
  uint orthographic;
  vec3 forward_ws;
  float near_m;
  vec3 right_ws;  // scaled to the edge of the picture: at distance 1 (perspective) or in metres (orthographic)
  float far_m;
  vec3 up_ws;
  uint samples;
  uvec2 size;
  vec2 subpixel;  // in pixels: how far from their usual places within a pixel it is sampled (the truth of pixels; else 0)
};

#ifndef __cplusplus
layout(buffer_reference, scalar) readonly buffer DrawItems { DrawItem v[]; };
layout(buffer_reference, scalar) readonly buffer Positions { vec3 v[]; };
layout(buffer_reference, scalar) readonly buffer Attributess { VertexAttributes v[]; };
layout(buffer_reference, scalar) readonly buffer Indexs { uint v[]; };
layout(buffer_reference, scalar) readonly buffer Materials { MaterialData v[]; };
layout(buffer_reference, scalar) readonly buffer Lights { LightData v[]; };
layout(buffer_reference, scalar) buffer Floats { float v[]; };
layout(buffer_reference, scalar) buffer Uints { uint v[]; };
layout(buffer_reference, scalar) buffer Vec4s { vec4 v[]; };
layout(buffer_reference, scalar) writeonly buffer DrawCommands { DrawCommand v[]; };
#endif

// One entry per sample: index (y * width + x) * samples + sample; `share` has one per pixel.
struct SurfaceData {
  ADDRESS(Float) view_z;            // metres along the camera's forward axis; 0 where the camera sees the sky
  ADDRESS(Uint) geometric_normal;   // octahedral, 2 x snorm16, turned toward the viewer
  ADDRESS(Uint) item;               // k_no_item where the camera sees the sky
  ADDRESS(Uint) primitive;          // triangle within the item
  ADDRESS(Uint) share;              // 4 bits per sample: the first sample of the pixel that lies on the same surface
};

#ifdef __cplusplus
struct SceneData {
  uint64_t items, positions, attributes, indices, materials;
};
#else
struct SceneData {
  DrawItems items;
  Positions positions;
  Attributess attributes;
  Indexs indices;
  Materials materials;
};
#endif

struct FrameData {
  CameraData camera;
  SceneData scene;
  SurfaceData surface;
  uint light_count;
  float ambient, exposure;
  uint normal_maps, specular;
  uint albedo_image, normal_image, id_image, depth_image;  // bindless indices of the raster's attachments
  ADDRESS(Light) lights;
};

#ifdef __cplusplus
}  // namespace gnomon
#else
layout(buffer_reference, scalar) readonly buffer FrameDataRef { FrameData v; };
#endif

#endif
