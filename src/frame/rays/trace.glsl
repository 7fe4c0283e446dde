// Visibility rays for ray-generation shaders. The includer declares push constants whose first member is the frame.
#ifndef GNOMON_TRACE_GLSL
#define GNOMON_TRACE_GLSL
#extension GL_EXT_ray_tracing : require
#include "base/glsl/light_sampling.glsl"

layout(location = 0) rayPayloadEXT uint visible;

bool unoccluded(uint64_t scene, vec3 origin, LightRay ray) {
  visible = 0u;
  const uint flags = gl_RayFlagsTerminateOnFirstHitEXT | gl_RayFlagsSkipClosestHitShaderEXT;
  traceRayEXT(accelerationStructureEXT(scene), flags, 0xffu, 0u, 0u, 0u, origin, 0.0, ray.direction, ray.distance, 0);
  return visible != 0u;
}

// As EmbreeReference::trace: the fraction of the light's samples above the receiver's horizon that arrive.
float trace_visibility(uint64_t scene, LightShape light, vec3 position, vec3 normal, float eye_distance, vec2 extents,
                       uint pixel, uint samples, uint seed) {
  if (!receives_light(light, position, normal)) return 0.0;
  vec3 origin = ray_origin(position, normal, eye_distance, extents);
  uint counted = 0u, arrived = 0u;
  if (light.emitter_radius > 0.0) {
    for (uint i = 0u; i < samples; ++i) {
      LightRay ray = light_ray(light, origin, light_sample(i, pixel, seed));
      if (!above_horizon(ray, normal)) continue;
      ++counted;
      if (unoccluded(scene, origin, ray)) ++arrived;
    }
  }
  if (counted == 0u) {
    light.emitter_radius = 0.0;
    return unoccluded(scene, origin, light_ray(light, origin, vec2(0.5))) ? 1.0 : 0.0;
  }
  return float(arrived) / float(counted);
}

#endif
