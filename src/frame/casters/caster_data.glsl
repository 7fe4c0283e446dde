// Culling of casters against the layers of a shadow map, for C++ and shaders.
#ifndef GNOMON_CASTER_DATA_GLSL
#define GNOMON_CASTER_DATA_GLSL
#include "frame/glsl/frame_data.glsl"
#include "frame/glsl/light_view.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

// What is culled as one: a run of triangles of a draw item that casts.
struct CasterRange {
  vec3 bounds_min_ws;
  uint first_index;
  vec3 bounds_max_ws;
  uint index_count;
  uint item;
};

// At most k_caster_chunk ranges of one bucket: what one work group handles.
struct CasterChunk {
  uint bucket, begin, end;  // ranges
  uint first_of_bucket, last_of_bucket;  // chunks
};
shared_constant uint k_caster_chunk = 256u;

// How draws are laid out, and so what an instance index says.
shared_constant uint k_draws_per_layer = 0u;  // one list for each layer and bucket; instance = item
shared_constant uint k_draws_layered = 1u;    // one list for each bucket; instance = item, layer in the upper 8 bits
shared_constant uint k_draws_union = 2u;      // the same; the upper 8 bits say which layers the draw touches
shared_constant uint k_instance_item_bits = 24u;

#ifndef __cplusplus
layout(buffer_reference, scalar) readonly buffer CasterRanges { CasterRange v[]; };
layout(buffer_reference, scalar) readonly buffer CasterChunks { CasterChunk v[]; };
#endif

struct CasterCullArguments {
  uint64_t views;  // the first LightView
  ADDRESS(CasterRange) ranges;
  ADDRESS(CasterChunk) chunks;
  ADDRESS(DrawItem) items;
  ADDRESS(DrawCommand) draws;
  ADDRESS(Uint) counts;        // draws of each list
  ADDRESS(Uint) chunk_counts;  // draws of each chunk, layer by layer
  uint stride;                 // bytes from view to view
  uint layers, chunk_count, range_count;
  uint layout_kind;            // k_draws_*
  uint cull;                   // 0: every range is drawn into every active layer
};

#ifdef __cplusplus
static_assert(sizeof(CasterCullArguments) <= 128);
}  // namespace gnomon
#endif

#endif
