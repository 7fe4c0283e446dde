// Casters in paraboloid views.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/casters/draw/caster_paraboloid.glsl"
