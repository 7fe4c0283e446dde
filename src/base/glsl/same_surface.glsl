// Which points within a pixel lie on one surface: they may share an answer, and what the pixel should show of that surface is
// the mean over them. One text for the surface pass and the truth of pixels.
#ifndef GNOMON_SAME_SURFACE_GLSL
#define GNOMON_SAME_SURFACE_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon {
#endif

shared_constant uint k_no_item = 0xffffffffu;  // the camera sees the sky

struct SurfaceSample {
  float z;         // metres along the camera's forward axis
  vec3 normal;     // geometric, unit, turned toward the viewer
  uint item;       // k_no_item where the camera sees the sky
  uint primitive;  // triangle within the item
};

// between: from a's place to b's, metres.
inline_function bool same_surface(SurfaceSample a, SurfaceSample b, vec3 between) {
  if (a.item != b.item) return false;
  if (a.item == k_no_item || a.primitive == b.primitive) return true;
  // Neighbouring triangles of one item, nearly in one plane (8 degrees) and not torn apart in depth.
  float slack = 0.05f * length(between) + 1e-6f * a.z;
  return dot(a.normal, b.normal) > 0.99f && abs(dot(a.normal, between)) <= slack;
}

#ifdef __cplusplus
}  // namespace gnomon
#endif
#endif
