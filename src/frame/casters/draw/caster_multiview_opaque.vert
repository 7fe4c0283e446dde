// Casters, opaque; layers by path multiview.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_multiview : require
#define CASTER_MULTIVIEW
#include "frame/casters/draw/caster_vertex.glsl"
