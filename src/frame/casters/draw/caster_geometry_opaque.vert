// Casters, opaque; layers by path geometry.
#version 460
#extension GL_GOOGLE_include_directive : require
#define CASTER_GEOMETRY
#include "frame/casters/draw/caster_vertex.glsl"
