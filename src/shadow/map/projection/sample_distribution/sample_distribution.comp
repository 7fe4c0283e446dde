// Views from the distribution of the visible samples (Lauritzen, Salvi and Lefohn 2011, sections 4 and 5): one shader, four
// dispatches.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/surface.glsl"
#include "shadow/map/projection/sample_distribution/sample_distribution_data.glsl"

layout(constant_id = 0) const uint k_stage = 0;
const uint k_stage_reset = 0u, k_stage_depths = 1u, k_stage_boxes = 2u, k_stage_views = 3u;

layout(buffer_reference, scalar) readonly buffer InputRef { SampleDistributionInput v; };
layout(buffer_reference, scalar) buffer StateRef { SampleDistributionState v; };
layout(buffer_reference, scalar) buffer ViewsRef {
  ShadowMapData map;
  ShadowView v[];
};
layout(push_constant, scalar) uniform Push {
  FrameDataRef frame;
  InputRef fit;
  StateRef state;
  ViewsRef views;
};
const uint k_group = 256u, k_per_thread = 8u;
layout(local_size_x = 256) in;

shared uint group_depths[2];
// One more than is used: as the type of the buffer's array it would carry that one's layout, which shared memory must not.
shared uint group_boxes[k_max_layers * 5u + 1u];

// Entries of a box: two minima, then three maxima.
bool is_minimum(uint entry) { return entry % 5u < 2u; }
uint empty_entry(uint entry) { return is_minimum(entry) ? 0xffffffffu : 0u; }

uint ordered(float x) {
  uint bits = floatBitsToUint(x);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}
float from_ordered(uint x) { return uintBitsToFloat((x & 0x80000000u) != 0u ? x & 0x7fffffffu : ~x); }

void reset() {
  uint i = gl_LocalInvocationIndex;
  if (i == 0u) state.v.nearest = 0xffffffffu, state.v.farthest = 0u;
  if (i < k_max_layers * 5u) state.v.boxes[i] = empty_entry(i);
}

uint sample_count() { return frame.v.camera.size.x * frame.v.camera.size.y * frame.v.camera.samples; }
uint sample_of_thread(uint i) { return (gl_WorkGroupID.x * k_per_thread + i) * k_group + gl_LocalInvocationIndex; }

void reduce_depths() {
  uint lane = gl_LocalInvocationIndex;
  if (lane == 0u) group_depths[0] = 0xffffffffu, group_depths[1] = 0u;
  barrier();
  float nearest = 3.0e38, farthest = 0.0;
  for (uint i = 0u; i < k_per_thread; ++i) {
    uint index = sample_of_thread(i);
    float z = index < sample_count() ? frame.v.surface.view_z.v[index] : 0.0;
    if (z > 0.0) nearest = min(nearest, z), farthest = max(farthest, z);
  }
  if (farthest > 0.0) {
    atomicMin(group_depths[0], ordered(nearest));
    atomicMax(group_depths[1], ordered(farthest));
  }
  barrier();
  if (lane == 0u && group_depths[1] != 0u) {
    atomicMin(state.v.nearest, group_depths[0]);
    atomicMax(state.v.farthest, group_depths[1]);
  }
}

// Splits between the first and the last sample (Zhang et al. 2006, eq. 4).
void find_splits(out float edges[k_max_layers + 1u]) {
  float near = from_ordered(state.v.nearest), far = max(from_ordered(state.v.farthest), near * 1.0001);
  for (uint i = 0u; i <= k_max_layers; ++i) {
    float t = float(min(i, fit.v.count)) / float(fit.v.count);
    edges[i] = mix(near + (far - near) * t, near * pow(far / near, t), fit.v.lambda);
  }
  edges[fit.v.count] = far;
}

struct RunningBox {
  uint split;
  vec2 low, high;
  float deepest;
};

void flush(RunningBox box) {
  if (box.deepest <= -3.0e38) return;
  atomicMin(group_boxes[box.split * 5u + 0u], ordered(box.low.x));
  atomicMin(group_boxes[box.split * 5u + 1u], ordered(box.low.y));
  atomicMax(group_boxes[box.split * 5u + 2u], ordered(box.high.x));
  atomicMax(group_boxes[box.split * 5u + 3u], ordered(box.high.y));
  atomicMax(group_boxes[box.split * 5u + 4u], ordered(box.deepest));
}

void add_to(inout RunningBox box, uint split, vec3 p) {
  if (split != box.split) {
    flush(box);
    box = RunningBox(split, p.xy, p.xy, p.z);
  }
  box.low = min(box.low, p.xy), box.high = max(box.high, p.xy);
  box.deepest = max(box.deepest, p.z);
}

// Neighbours in memory mostly lie in one split: a thread keeps its box in registers until the split changes.
void reduce_boxes() {
  uint lane = gl_LocalInvocationIndex;
  if (lane < k_max_layers * 5u) group_boxes[lane] = empty_entry(lane);
  barrier();
  CameraData camera = frame.v.camera;
  float edges[k_max_layers + 1u];
  find_splits(edges);
  RunningBox box = RunningBox(0u, vec2(3.0e38), vec2(-3.0e38), -3.0e38);
  for (uint i = 0u; i < k_per_thread; ++i) {
    uint index = sample_of_thread(i);
    if (index >= sample_count()) break;
    uint pixel = index / camera.samples;
    Surface surface;
    if (!load_surface(frame, uvec2(pixel % camera.size.x, pixel / camera.size.x), index % camera.samples, surface)) continue;
    // What turns away from the light never reads the map.
    if (!receives_light(fit.v.shape, surface.position_ws, surface.geometric_normal_ws)) continue;
    vec3 p = vec3(dot(fit.v.light_x_ws, surface.position_ws), dot(fit.v.light_y_ws, surface.position_ws),
                  dot(fit.v.light_z_ws, surface.position_ws));
    float z = frame.v.surface.view_z.v[index];
    // A point on a boundary belongs to both splits: the resolve computes its distance anew and may round to the other side.
    uint split = 0u;
    while (split + 1u < fit.v.count && z >= edges[split + 1u] * 1.0001) ++split;
    add_to(box, split, p);
    if (split + 1u < fit.v.count && z >= edges[split + 1u] * 0.9999) add_to(box, split + 1u, p);
  }
  flush(box);
  barrier();
  if (lane >= k_max_layers * 5u || group_boxes[lane] == empty_entry(lane)) return;
  if (is_minimum(lane)) atomicMin(state.v.boxes[lane], group_boxes[lane]);
  else atomicMax(state.v.boxes[lane], group_boxes[lane]);
}

// Corners of the part of the view between two distances, in light space.
void slice_box(float from, float to, out vec3 low, out vec3 high) {
  CameraData camera = frame.v.camera;
  mat3 light_from_world = transpose(mat3(fit.v.light_x_ws, fit.v.light_y_ws, fit.v.light_z_ws));
  low = vec3(3.0e38), high = vec3(-3.0e38);
  for (uint i = 0u; i < 8u; ++i) {
    float at = (i & 4u) != 0u ? to : from;
    vec3 sideways = ((i & 1u) != 0u ? camera.right_ws : -camera.right_ws) + ((i & 2u) != 0u ? camera.up_ws : -camera.up_ws);
    vec3 p = light_from_world * (camera.eye_ws + camera.forward_ws * at + sideways * (camera.orthographic != 0u ? 1.0 : at));
    low = min(low, p), high = max(high, p);
  }
  low = max(low, fit.v.scene_min), high = min(high, fit.v.scene_max);
}

// As orthographic_view() does it, inverted in closed form.
void write_view(uint layer, vec3 low, vec3 high, vec2 interval) {
  SampleDistributionInput data = fit.v;
  // As some_extent() has it: a map needs an extent along each axis.
  vec3 whole = high - low;
  float least = max(1e-3 * max(whole.x, max(whole.y, whole.z)), 1e-9);
  vec2 extent = max(whole.xy, vec2(least)), middle = 0.5 * (low.xy + high.xy);
  float depth = max(whole.z, least);
  ShadowView view;
  view.raster.clip_from_world = mat4(0.0);
  for (int i = 0; i < 3; ++i) {
    view.raster.clip_from_world[i] =
        vec4(2.0 / extent.x * data.light_x_ws[i], 2.0 / extent.y * data.light_y_ws[i], data.light_z_ws[i] / depth, 0.0);
  }
  view.raster.clip_from_world[3] = vec4(-2.0 * middle / extent, -low.z / depth, 1.0);
  view.raster.kind = k_view_projective;
  view.raster.near_m = view.raster.far_m = view.raster.served = view.raster.kernel_m = 0.0;
  view.raster.in_use = 1u;
  view.world_from_clip = mat4(vec4(0.5 * extent.x * data.light_x_ws, 0.0), vec4(0.5 * extent.y * data.light_y_ws, 0.0),
                              vec4(depth * data.light_z_ws, 0.0),
                              vec4(data.light_x_ws * middle.x + data.light_y_ws * middle.y + data.light_z_ws * low.z, 1.0));
  view.linear_numerator = vec4(0.0, 0.0, 1.0, 0.0);
  view.linear_denominator = vec4(0.0, 0.0, 0.0, 1.0);
  view.origin_ws = vec3(0.0);
  view.depth_range_m = depth;
  view.depth_near_m = 0.0;
  view.texel_m = max(extent.x, extent.y) / float(data.size);
  view.size = float(data.size);
  view.border = data.border;
  view.texel_along_m = 0.0;
  view.unused = 0.0;
  view.interval_m = interval;
  views.v[layer] = view;
}

void make_views() {
  uint layer = gl_LocalInvocationIndex;
  if (layer >= fit.v.count) return;
  SampleDistributionInput data = fit.v;
  float edges[k_max_layers + 1u];
  find_splits(edges);
  vec2 interval = vec2(edges[layer], edges[layer + 1u]);
  bool any_sample = state.v.farthest != 0u && state.v.boxes[layer * 5u + 4u] != 0u;
  vec3 low, high;
  if (data.tight != 0u) {
    uint first = layer * 5u;
    low = vec3(from_ordered(state.v.boxes[first]), from_ordered(state.v.boxes[first + 1u]), 0.0);
    high = vec3(from_ordered(state.v.boxes[first + 2u]), from_ordered(state.v.boxes[first + 3u]),
                from_ordered(state.v.boxes[first + 4u]));
  } else if (any_sample) {
    slice_box(interval.x, interval.y, low, high);
  }
  // Nothing beyond the casters' own outline can be shadowed; the near plane lies before all of them.
  low.xy = max(low.xy, data.caster_min.xy), high.xy = min(high.xy, data.caster_max.xy);
  low.z = data.caster_min.z;
  if (!any_sample || any(greaterThan(low, high))) {
    views.v[layer].raster.in_use = 0u;
    views.v[layer].interval_m = any_sample || state.v.farthest != 0u ? interval : vec2(0.0);
    return;
  }
  // Samples lie at the very edge, and mips are read as wide as pixels are: two of those more.
  float size = float(data.size);
  float border = min(data.border + 2.0 * size / float(min(frame.v.camera.size.x, frame.v.camera.size.y)), 0.25 * size);
  vec2 grow = border / (size - 2.0 * border) * (high.xy - low.xy);
  low.xy -= grow, high.xy += grow;
  // Kernels read beyond the samples, where the same surfaces lie deeper.
  high.z = data.scene_max.z;
  float margin = 1e-3 * max(high.z - low.z, 1e-3 * max(high.x - low.x, high.y - low.y));
  low.z = max(low.z - margin, data.start), high.z += margin;
  write_view(layer, low, high, interval);
}

void main() {
  if (k_stage == k_stage_reset) reset();
  else if (k_stage == k_stage_depths) reduce_depths();
  else if (k_stage == k_stage_boxes) reduce_boxes();
  else make_views();
}
