// scene/surface_point.h for shaders.
#ifndef GNOMON_SURFACE_POINT_GLSL
#define GNOMON_SURFACE_POINT_GLSL
#include "frame/glsl/frame_data.glsl"

struct SurfacePoint {
  vec3 position_ws;
  uint object;
  vec3 geometric_normal_ws;
  uint pixel;
};
layout(buffer_reference, scalar) buffer SurfacePoints { SurfacePoint v[]; };

#endif
