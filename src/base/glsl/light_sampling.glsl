// What "the fraction of a light that arrives" means: who receives, where the samples of an emitter lie, and which of them
// count. One text for the ray-tracing pipeline, ray-traced techniques and the CPU reference (after base/glsl/sampling.glsl).
//
//   if (!receives_light(light, position, normal)) visibility = 0, no receiver
//   origin = ray_origin(position, normal, eye distance, extents)
//   for each sample: ray = light_ray(light, origin, light_sample(index, pixel, seed));
//                    skip it unless above_horizon(ray, normal)
//   visibility = unoccluded / counted samples; the ray to the centre alone where none counted
//
// Directions below the receiver's own tangent plane count in neither number. The cosine of the shading already makes their
// contribution zero; were they counted as shadow, every technique that compares a receiver with other surfaces, as all maps
// do, would be wrong by up to a half along each terminator, however well it finds occluders. Other triangles of the same
// curved surface do occlude: the facets of a tessellated terminator are geometry.
#ifndef GNOMON_LIGHT_SAMPLING_GLSL
#define GNOMON_LIGHT_SAMPLING_GLSL
#include "base/glsl/sampling.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

// As scene/scene.h's LightKind.
shared_constant uint k_light_directional = 0u;
shared_constant uint k_light_point = 1u;
shared_constant uint k_light_spot = 2u;
shared_constant uint k_light_projector = 3u;  // parallel rays inside a cylinder

// Surfaces within 0.06 degrees of edge-on to the light receive none of it: whether their normal faces it is a matter of the
// normal's 32 bits, and a wall under an overhead sun would count as lit or shadowed by chance.
shared_constant float k_grazing_cosine = 1.0e-3f;

// Length of a ray that leaves the scene.
shared_constant float k_ray_endless = 1.0e30f;

struct LightShape {
  vec3 position;         // point, spot; projector: centre of the aperture
  uint kind;             // k_light_*
  vec3 direction;        // unit, the way the light travels; all but point
  float emitter_radius;  // metres; parallel lights: tan(angular diameter / 2). 0: a hard shadow, every ray goes to the centre
  float cos_outer_cone;  // spot
  float range;           // metres; 0 = unlimited; point and spot
  float beam_radius;     // metres; projector
};

struct LightRay {
  vec3 direction;  // unit
  float distance;  // at which to stop
};

// Tangent, bitangent, n as columns: right-handed, for unit n (Duff et al. 2017, JCGT 6(1)).
inline_function mat3 basis_around(vec3 n) {
  float s = n.z >= 0.0f ? 1.0f : -1.0f;
  float a = -1.0f / (s + n.z);
  float b = n.x * n.y * a;
  return mat3(vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

// Directional and projector lights: the same direction everywhere.
inline_function bool is_parallel(LightShape light) {
  return light.kind == k_light_directional || light.kind == k_light_projector;
}

// Unit vector from a point toward the light's centre.
inline_function vec3 direction_to_light(LightShape light, vec3 position) {
  return is_parallel(light) ? -light.direction : normalize(light.position - position);
}

// Whether any light could arrive at a point of the scene: its geometric normal faces the light's centre, and it lies within
// range and cone. Shading normals play no part: what shading makes of a terminator is not visibility.
inline_function bool receives_light(LightShape light, vec3 position, vec3 geometric_normal) {
  if (light.kind == k_light_directional) return dot(geometric_normal, light.direction) < -k_grazing_cosine;
  vec3 to_light = light.position - position;
  if (light.kind == k_light_projector) {
    float along = -dot(to_light, light.direction);
    vec3 across = to_light + along * light.direction;
    return dot(geometric_normal, light.direction) < -k_grazing_cosine && along > 0.0f && length(across) <= light.beam_radius;
  }
  float distance_to_light = length(to_light);
  if (!(dot(geometric_normal, to_light) > k_grazing_cosine * distance_to_light)) return false;
  if (light.range > 0.0f && distance_to_light > light.range) return false;
  return light.kind != k_light_spot || dot(-to_light, light.direction) >= light.cos_outer_cone * distance_to_light;
}

// Point `index` of the sequence that belongs to one pixel: in the unit square. `pixel` differs between samples that should
// have independent noise.
inline_function vec2 light_sample(uint index, uint pixel, uint seed) {
  uint scramble = hash_uint(pixel ^ hash_uint(seed));
  return scrambled_02_sequence(index, scramble, hash_uint(scramble ^ 0x9e3779b9u));
}

// From `origin` to the point of the emitter that `square` selects, uniformly by area. Emitters are discs that face the origin:
// the sun's in the plane perpendicular to its direction at distance 1; a sphere's through its centre.
inline_function LightRay light_ray(LightShape light, vec3 origin, vec2 square) {
  vec3 to_centre = is_parallel(light) ? -light.direction : light.position - origin;
  vec3 to_emitter = to_centre;
  if (light.emitter_radius > 0.0f) {
    mat3 basis = basis_around(normalize(to_centre));
    vec2 disc = light.emitter_radius * concentric_disc(square);
    to_emitter = to_centre + basis[0] * disc.x + basis[1] * disc.y;
  }
  float emitter_distance = length(to_emitter);
  LightRay ray;
  ray.direction = to_emitter / emitter_distance;
  // Short of the emitter by four units of rounding: a lamp's own surface through its centre casts no shadow.
  float rounding = 1.0f - 2.384185791015625e-07f * 4.0f;
  ray.distance = light.kind == k_light_directional ? k_ray_endless : emitter_distance * rounding;
  // A beam begins at its aperture's plane: what stands behind the projector shadows nothing.
  if (light.kind == k_light_projector)
    ray.distance = dot(light.position - origin, -light.direction) / max(dot(ray.direction, -light.direction), 1e-3f) * rounding;
  return ray;
}

inline_function bool above_horizon(LightRay ray, vec3 geometric_normal) { return dot(ray.direction, geometric_normal) > 0.0f; }

#ifdef __cplusplus
}  // namespace gnomon
#endif

#endif
