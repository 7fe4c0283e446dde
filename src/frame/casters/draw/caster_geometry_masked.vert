// Casters, masked; layers by path geometry.
#version 460
#extension GL_GOOGLE_include_directive : require
#define CASTER_GEOMETRY
#define CASTER_ATTRIBUTES
#include "frame/casters/draw/caster_vertex.glsl"
