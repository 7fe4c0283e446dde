// Writes the indirect draws of a shadow map's layers, in the order of the scene: a first dispatch counts each chunk's draws, a
// second one writes them behind those of the chunks before. Neighbouring ranges of one item that survive together become one
// draw.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/casters/caster_data.glsl"

layout(constant_id = 0) const uint k_write = 0;
layout(push_constant, scalar) uniform Push { CasterCullArguments arguments; };
layout(local_size_x = 256) in;  // k_caster_chunk

shared uint masks[256];  // layers that each range of the chunk touches
shared uint items[256];
shared uint sums[256];

bool outside_plane(CasterRange range, vec4 plane) {
  vec3 farthest = mix(range.bounds_min_ws, range.bounds_max_ws, greaterThan(plane.xyz, vec3(0.0)));
  return dot(plane.xyz, farthest) + plane.w < 0.0;
}

// Wholly behind the cone around -z that lies outside a paraboloid's map.
bool behind_paraboloid(CasterRange range, LightView view) {
  vec3 half_size = 0.5 * (range.bounds_max_ws - range.bounds_min_ws);
  vec3 centre = (view.clip_from_world * vec4(0.5 * (range.bounds_max_ws + range.bounds_min_ws), 1.0)).xyz;
  float farthest = length(centre) + length(half_size);
  vec3 axis = transpose(mat3(view.clip_from_world))[2];
  return centre.z + dot(abs(axis), half_size) < paraboloid_edge(paraboloid_rim(view)) * farthest;
}

// A caster between the light and the view is drawn although it lies before the near plane: its bounds are swept along the
// light. Behind the far plane there is nothing that it could shadow.
bool touches(CasterRange range, LightView view) {
  if (view.in_use == 0u) return false;
  if (arguments.cull == 0u) return true;
  if (view.kind == k_view_paraboloid) return !behind_paraboloid(range, view);
  mat4 rows = transpose(view.clip_from_world);
  if (outside_plane(range, rows[3] + rows[0]) || outside_plane(range, rows[3] - rows[0])) return false;
  if (outside_plane(range, rows[3] + rows[1]) || outside_plane(range, rows[3] - rows[1])) return false;
  return !outside_plane(range, rows[3] - rows[2]);
}

// Whether all that the range can shadow lies where a finer layer serves it. A kernel of layer `l` that reads from outside that
// place must still meet the caster.
bool served_by_finer(CasterRange range, uint l, float kernel_m) {
  vec3 centre = 0.5 * (range.bounds_min_ws + range.bounds_max_ws), half_size = range.bounds_max_ws - centre;
  for (uint finer = 0u; finer < l; ++finer) {
    LightView view = light_view(arguments.views, arguments.stride, finer).v;
    if (view.in_use == 0u || !(view.served > 0.0)) continue;
    mat4 rows = transpose(view.clip_from_world);
    vec2 reach = abs(vec2(dot(rows[0], vec4(centre, 1.0)), dot(rows[1], vec4(centre, 1.0)))) +
                 vec2(dot(abs(rows[0].xyz), half_size), dot(abs(rows[1].xyz), half_size)) +
                 kernel_m * vec2(length(rows[0].xyz), length(rows[1].xyz));
    if (max(reach.x, reach.y) < view.served) return true;
  }
  return false;
}

// Inclusive prefix sum over the work group.
uint scan_group(uint value) {
  uint lane = gl_LocalInvocationIndex;
  sums[lane] = value;
  barrier();
  for (uint reach = 1u; reach < 256u; reach *= 2u) {
    uint sum = sums[lane] + (lane >= reach ? sums[lane - reach] : 0u);
    barrier();
    sums[lane] = sum;
    barrier();
  }
  return sums[lane];
}

void main() {
  uint lane = gl_LocalInvocationIndex;
  uint chunk_index = gl_WorkGroupID.x;
  bool is_union = arguments.layout_kind == k_draws_union;
  uint layer = gl_WorkGroupID.y;  // 0 in a union, which looks at all of them
  CasterChunk chunk = arguments.chunks.v[chunk_index];
  uint index = chunk.begin + lane;
  uint mask = 0u;
  CasterRange range;
  if (index < chunk.end) {
    range = arguments.ranges.v[index];
    uint first = is_union ? 0u : layer, last = is_union ? arguments.layers : layer + 1u;
    for (uint l = first; l < last; ++l) {
      LightView view = light_view(arguments.views, arguments.stride, l).v;
      if (!touches(range, view)) continue;
      if (arguments.cull == 0u || !served_by_finer(range, l, view.kernel_m)) mask |= 1u << l;
    }
  }
  masks[lane] = mask;
  items[lane] = index < chunk.end ? range.item : 0xffffffffu;
  barrier();
  bool head = mask != 0u && (lane == 0u || masks[lane - 1u] != mask || items[lane - 1u] != items[lane]);
  uint rank = scan_group(head ? 1u : 0u);
  uint slot = layer * arguments.chunk_count + chunk_index;
  if (k_write == 0u) {
    if (lane == 255u) arguments.chunk_counts.v[slot] = rank;
    return;
  }

  // Draws of this bucket before this chunk's: of the chunks before, and where layers share a list, of the layers before.
  bool layered = arguments.layout_kind == k_draws_layered;
  uint per_layer = chunk.last_of_bucket + 1u - chunk.first_of_bucket;
  uint before = chunk_index - chunk.first_of_bucket + (layered ? layer * per_layer : 0u);
  uint base = 0u;
  barrier();
  for (uint i = lane; i < before; i += 256u) {
    uint of_layer = layered ? i / per_layer : layer;
    base += arguments.chunk_counts.v[of_layer * arguments.chunk_count + chunk.first_of_bucket + (layered ? i % per_layer : i)];
  }
  uint own_total = sums[255];
  barrier();
  scan_group(base);
  base = sums[255];

  uint bucket_begin = arguments.chunks.v[chunk.first_of_bucket].begin;
  uint list_begin = arguments.layout_kind == k_draws_per_layer ? layer * arguments.range_count + bucket_begin
                  : layered ? bucket_begin * arguments.layers : bucket_begin;
  if (head) {
    uint end = lane;
    while (end < 256u && masks[end] == mask && items[end] == items[lane]) ++end;
    CasterRange last = arguments.ranges.v[chunk.begin + end - 1u];
    uint tag = is_union ? mask : layered ? layer : 0u;
    arguments.draws.v[list_begin + base + rank - 1u] =
        DrawCommand(last.first_index + last.index_count - range.first_index, 1u, range.first_index,
                    int(arguments.items.v[range.item].first_vertex), range.item | (tag << k_instance_item_bits));
  }
  // The chunk that is the last of its list knows how many there are.
  bool last_layer = !layered || layer + 1u == arguments.layers;
  if (lane == 0u && chunk_index == chunk.last_of_bucket && last_layer) {
    uint list = arguments.layout_kind == k_draws_per_layer ? layer * k_bucket_count + chunk.bucket : chunk.bucket;
    arguments.counts.v[list] = base + own_total;
  }
}
