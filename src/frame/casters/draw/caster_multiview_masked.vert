// Casters, masked; layers by path multiview.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_multiview : require
#define CASTER_MULTIVIEW
#define CASTER_ATTRIBUTES
#include "frame/casters/draw/caster_vertex.glsl"
