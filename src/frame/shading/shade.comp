// Lights the surface buffer through the visibility masks: ambient + Lambert (+ Blinn-Phong), tone curve, resolve of the
// samples.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/bindless.glsl"
#include "frame/surface/pixel_tile.glsl"
#include "frame/glsl/surface.glsl"

layout(constant_id = 0) const uint k_samples = 1;
layout(push_constant, scalar) uniform Push {
  FrameDataRef frame;
  Floats mask;       // light by light, then as the surface buffer
  Uints display;     // RGBA8, sRGB
  Vec4s linear_out;  // scene-linear colour and coverage
};
layout(local_size_x = 8, local_size_y = 8) in;

// Read once: the same for all pixels.
FrameData data;
CameraData camera;

vec4 fetch(uint image, ivec2 at, int s) {
  if (k_samples == 1) return texelFetch(images_2d[image], at, 0);
  return texelFetch(images_2d_ms[image], at, s);
}

// How much of a light's radiance a point receives, before visibility: the glTF rules for range and cone.
float attenuation(LightData light, vec3 to_light, float distance_m) {
  if (is_parallel(light.shape)) return 1.0;  // outside a beam the mask is 0
  float result = 1.0 / max(distance_m * distance_m, 1e-4);
  if (light.shape.range > 0.0) {
    float x = distance_m / light.shape.range;
    result *= clamp(1.0 - x * x * x * x, 0.0, 1.0);
  }
  if (light.shape.kind == k_light_spot) {
    float cosine = dot(-to_light, light.shape.direction);
    float t =
        clamp((cosine - light.shape.cos_outer_cone) / max(light.cos_inner_cone - light.shape.cos_outer_cone, 1e-4), 0.0, 1.0);
    result *= t * t;
  }
  return result;
}

vec3 shade_light(LightData light, Surface surface, vec3 normal, vec3 to_eye, vec3 albedo, MaterialData material,
                 float visibility) {
  vec3 offset = is_parallel(light.shape) ? -light.shape.direction : light.shape.position - surface.position_ws;
  float distance_m = length(offset);
  vec3 to_light = offset / distance_m;
  // A surface that faces away is dark by N.L alone: the mask is not applied to it a second time, and a normal map cannot light
  // what the geometry turns away.
  float cosine = max(dot(normal, to_light), 0.0) * (dot(surface.geometric_normal_ws, to_light) > 0.0 ? 1.0 : 0.0);
  vec3 result = albedo * cosine / 3.14159265;
  if (data.specular != 0u && cosine > 0.0) {
    float highlight = pow(max(dot(normal, normalize(to_light + to_eye)), 0.0), material.shininess);
    result += material.specular * highlight * cosine * (material.shininess + 8.0) / (8.0 * 3.14159265);
  }
  return result * light.radiance * attenuation(light, to_light, distance_m) * visibility;
}

vec3 sky(vec3 direction) {
  float height = clamp(normalize(direction).y * 0.5 + 0.5, 0.0, 1.0);
  return mix(vec3(0.75, 0.72, 0.66), mix(vec3(0.78, 0.83, 0.88), vec3(0.26, 0.44, 0.72), smoothstep(0.5, 0.95, height)),
             smoothstep(0.44, 0.52, height));
}

// Filmic curve (Narkowicz 2015), then the sRGB transfer function.
vec3 display_colour(vec3 c) {
  c *= data.exposure;
  c = clamp((c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

void shade_pixel(uvec2 pixel) {
  vec3 shown = vec3(0.0), radiance = vec3(0.0);
  float coverage = 0.0;
  for (uint s = 0u; s < k_samples; ++s) {
    Surface surface;
    vec3 origin, direction, colour;
    view_ray(camera, pixel, s, origin, direction);
    if (load_surface(camera, data.surface, pixel, s, surface)) {
      uint index = sample_index(camera, pixel, s);
      vec3 albedo = fetch(data.albedo_image, ivec2(pixel), int(s)).rgb;
      vec3 normal = normalize(fetch(data.normal_image, ivec2(pixel), int(s)).xyz);
      MaterialData material = data.scene.materials.v[data.scene.items.v[data.surface.item.v[index]].material];
      // Sky above, warm bounce below.
      colour =
          material.emissive + albedo * data.ambient * mix(vec3(0.52, 0.46, 0.40), vec3(0.80, 0.95, 1.15), normal.y * 0.5 + 0.5);
      for (uint light = 0u; light < data.light_count; ++light) {
        float visibility = max(mask.v[light * camera.size.x * camera.size.y * k_samples + index], 0.0);
        colour += shade_light(data.lights.v[light], surface, normal, -normalize(direction), albedo, material, visibility);
      }
      coverage += 1.0;
    } else {
      colour = sky(direction) / data.exposure;
    }
    radiance += colour;
    shown += display_colour(colour);
  }
  uint index = pixel.y * camera.size.x + pixel.x;
  display.v[index] = packUnorm4x8(vec4(shown / float(k_samples), 1.0));
  linear_out.v[index] = vec4(radiance, coverage) / float(k_samples);
}

void main() {
  data = frame.v;
  camera = data.camera;
  for (uint i = 0u; i < 4u; ++i) {
    uvec2 pixel = pixel_of_tile(i);
    if (all(lessThan(pixel, camera.size))) shade_pixel(pixel);
  }
}
