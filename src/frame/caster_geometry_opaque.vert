// Casters, opaque; layers by path geometry.
#version 460
#extension GL_GOOGLE_include_directive : require
#define CASTER_GEOMETRY
#include "frame/glsl/caster_vertex.glsl"
