// Casters in paraboloid views, with object ids.
#version 460
#extension GL_GOOGLE_include_directive : require
#define CASTER_ID
#include "frame/casters/draw/caster_paraboloid.glsl"
