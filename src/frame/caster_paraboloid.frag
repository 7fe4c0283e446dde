// Casters in paraboloid views.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/caster_paraboloid.glsl"
