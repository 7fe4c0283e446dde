// Writes the indirect draws of one view: one work group per bucket keeps the items that touch the view, in their order, so that
// equal depths are resolved the same way in every run.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/casters/culling/cull_data.glsl"

layout(push_constant, scalar) uniform Push { CullArguments arguments; };
layout(local_size_x = 256) in;

shared uint scan[2][256];

// Planes of the view: inside where dot(xyz, point) + w >= 0 (Gribb and Hartmann 2001).
bool outside_plane(DrawItem item, vec4 plane) {
  vec3 farthest = mix(item.bounds_min_ws, item.bounds_max_ws, greaterThan(plane.xyz, vec3(0.0)));
  return dot(plane.xyz, farthest) + plane.w < 0.0;
}

bool outside(DrawItem item) {
  if ((arguments.flags & k_cull_casters_only) != 0u && (item.flags & k_item_casts) == 0u) return true;
  mat4 rows = transpose(arguments.clip_from_world.v);
  if (outside_plane(item, rows[3] + rows[0]) || outside_plane(item, rows[3] - rows[0])) return true;
  if (outside_plane(item, rows[3] + rows[1]) || outside_plane(item, rows[3] - rows[1])) return true;
  // A light's view leaves out near and far: a caster between the light and the view is drawn although it lies before the near
  // plane.
  if ((arguments.flags & k_cull_depth) == 0u) return false;
  return outside_plane(item, rows[2]) || outside_plane(item, rows[3] - rows[2]);
}

// Inclusive prefix sum over the work group.
uint scan_group(uint value) {
  uint lane = gl_LocalInvocationIndex;
  uint source = 0u;
  scan[0][lane] = value;
  barrier();
  for (uint reach = 1u; reach < 256u; reach *= 2u) {
    uint sum = scan[source][lane];
    if (lane >= reach) sum += scan[source][lane - reach];
    source = 1u - source;
    scan[source][lane] = sum;
    barrier();
  }
  uint result = scan[source][lane];
  uint last = scan[source][255];
  barrier();
  scan[0][0] = last;
  barrier();
  return result;
}

void main() {
  uint bucket = gl_WorkGroupID.x;
  uint begin = arguments.bucket_begin[bucket], end = arguments.bucket_begin[bucket + 1u];
  uint kept = 0u;
  for (uint chunk = begin; chunk < end; chunk += 256u) {
    uint index = chunk + gl_LocalInvocationIndex;
    DrawItem item;
    bool visible = false;
    if (index < end) {
      item = arguments.items.v[index];
      visible = !outside(item);
    }
    uint rank = scan_group(visible ? 1u : 0u);
    uint total = scan[0][0];
    if (visible) {
      arguments.draws.v[begin + kept + rank - 1u] =
          DrawCommand(item.index_count, 1u, item.first_index, int(item.first_vertex), index);
    }
    kept += total;
    barrier();
  }
  if (gl_LocalInvocationIndex == 0u) arguments.counts.v[bucket] = kept;
}
