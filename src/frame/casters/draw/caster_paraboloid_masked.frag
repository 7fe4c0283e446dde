// Casters in paraboloid views, alpha-tested.
#version 460
#extension GL_GOOGLE_include_directive : require
#define CASTER_MASKED
#include "frame/casters/draw/caster_paraboloid.glsl"
