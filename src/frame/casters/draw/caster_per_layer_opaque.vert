// Casters, opaque; layers by path per_layer.
#version 460
#extension GL_GOOGLE_include_directive : require
#define CASTER_PER_LAYER
#include "frame/casters/draw/caster_vertex.glsl"
