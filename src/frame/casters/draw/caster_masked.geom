// Casters, masked, by geometry shader.
#version 460
#extension GL_GOOGLE_include_directive : require
#define CASTER_ATTRIBUTES
#include "frame/casters/draw/caster_geometry.glsl"
