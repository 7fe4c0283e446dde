// Casters, masked; layers by path vertex_layer.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_ARB_shader_viewport_layer_array : require
#define CASTER_VERTEX_LAYER
#define CASTER_ATTRIBUTES
#include "frame/casters/draw/caster_vertex.glsl"
