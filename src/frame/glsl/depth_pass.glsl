// Push constants of a depth pass from a light.
#ifndef GNOMON_DEPTH_PASS_GLSL
#define GNOMON_DEPTH_PASS_GLSL
#include "frame/glsl/draw_vertex.glsl"

layout(buffer_reference, scalar) readonly buffer ViewMatrix { mat4 clip_from_world; };

layout(push_constant, scalar) uniform Push {
  ViewMatrix view;
  SceneData scene;
} pass;

#endif
