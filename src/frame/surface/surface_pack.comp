// Turns the raster's attachments into the surface buffer: exact positions and geometric normals from the triangle itself, and
// which samples of a pixel lie on one surface.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "base/glsl/same_surface.glsl"
#include "frame/glsl/bindless.glsl"
#include "frame/glsl/draw_vertex.glsl"
#include "frame/surface/pixel_tile.glsl"
#include "frame/glsl/surface.glsl"

layout(constant_id = 0) const uint k_samples = 1;
layout(push_constant, scalar) uniform Push { FrameDataRef frame; };
layout(local_size_x = 8, local_size_y = 8) in;

// Read once: the same for all pixels.
FrameData data;
CameraData camera;

vec4 fetch(uint image, ivec2 at, int s) {
  if (k_samples == 1) return texelFetch(images_2d[image], at, 0);
  return texelFetch(images_2d_ms[image], at, s);
}

float view_z_of_depth(float depth) {
  if (camera.orthographic != 0u) return mix(camera.far_m, camera.near_m, depth);
  return camera.near_m / depth;
}

SurfaceSample pack_sample(uvec2 pixel, int s) {
  SurfaceSample result = SurfaceSample(0.0, vec3(0.0), k_no_item, 0u);
  float depth = fetch(data.depth_image, ivec2(pixel), s).x;
  if (depth <= 0.0) return result;
  vec2 id = fetch(data.id_image, ivec2(pixel), s).xy;
  result.item = uint(id.x);
  result.primitive = uint(id.y);
  DrawItem item = data.scene.items.v[result.item];
  vec3 corners[3];
  for (int i = 0; i < 3; ++i) {
    uint vertex = data.scene.indices.v[item.first_index + 3u * result.primitive + i] + item.first_vertex;
    corners[i] = to_world(item, data.scene.positions.v[vertex]);
  }
  vec3 origin, direction;
  view_ray(camera, pixel, uint(s), origin, direction);
  vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  normal = normalize(normal);
  if (dot(normal, direction) > 0.0) normal = -normal;
  result.normal = normal;

  // The rasteriser moves vertices to a sub-pixel grid, which tilts the depth of surfaces seen at a grazing angle: the plane of
  // the triangle itself has no such error. Where the two differ by more than that can explain (a triangle seen edge-on), the
  // raster's depth is the better guess.
  float raster_z = view_z_of_depth(depth);
  float plane_z = dot(normal, corners[0] - origin) / dot(normal, direction);
  result.z = abs(plane_z - raster_z) <= 0.01 * raster_z ? plane_z : raster_z;
  return result;
}

void pack_pixel(uvec2 pixel) {
  SurfaceSample samples[8];
  vec3 positions[8];
  uint share = 0u;
  for (uint s = 0u; s < k_samples; ++s) {
    samples[s] = pack_sample(pixel, int(s));
    vec3 origin, direction;
    view_ray(camera, pixel, s, origin, direction);
    positions[s] = origin + samples[s].z * direction;
    uint leader = s;
    for (uint other = 0u; other < s; ++other) {
      if (same_surface(samples[other], samples[s], positions[s] - positions[other])) {
        leader = other;
        break;
      }
    }
    // Leaders lead themselves: a chain of near-equal neighbours must not drift away from its first sample's answer.
    share |= leader << (4u * s);
    uint index = sample_index(camera, pixel, s);
    data.surface.view_z.v[index] = samples[s].z;
    data.surface.geometric_normal.v[index] =
        pack_normal(samples[s].item == k_no_item ? vec3(0.0, 1.0, 0.0) : samples[s].normal);
    data.surface.item.v[index] = samples[s].item;
    data.surface.primitive.v[index] = samples[s].primitive;
  }
  data.surface.share.v[pixel.y * camera.size.x + pixel.x] = share;
}

void main() {
  data = frame.v;
  camera = data.camera;
  for (uint i = 0u; i < 4u; ++i) {
    uvec2 pixel = pixel_of_tile(i);
    if (all(lessThan(pixel, camera.size))) pack_pixel(pixel);
  }
}
