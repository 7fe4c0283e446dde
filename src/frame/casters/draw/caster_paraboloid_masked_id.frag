// Casters in paraboloid views, alpha-tested, with object ids.
#version 460
#extension GL_GOOGLE_include_directive : require
#define CASTER_MASKED
#define CASTER_ID
#include "frame/casters/draw/caster_paraboloid.glsl"
