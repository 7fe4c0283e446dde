// Push constants of frame/casters/culling/cull.comp.
#ifndef GNOMON_CULL_DATA_GLSL
#define GNOMON_CULL_DATA_GLSL
#include "frame/glsl/frame_data.glsl"
#ifdef __cplusplus
namespace gnomon {
#else
layout(buffer_reference, scalar) readonly buffer Mat4s { mat4 v; };
#endif

struct CullArguments {
  ADDRESS(Mat4) clip_from_world;  // of the view, on the GPU: a technique may compute it there
  ADDRESS(DrawItem) items;
  ADDRESS(DrawCommand) draws;
  ADDRESS(Uint) counts;
  uint bucket_begin[9];
  uint flags;
};
shared_constant uint k_cull_casters_only = 1u;
shared_constant uint k_cull_depth = 2u;  // near and far planes count too

#ifdef __cplusplus
}  // namespace gnomon
#endif

#endif
