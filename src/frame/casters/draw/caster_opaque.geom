// Casters, opaque, by geometry shader.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/casters/draw/caster_geometry.glsl"
