// Overlays and picks that need no map: of direct techniques, and those that are the same for all.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/bindless.glsl"
#include "frame/surface/pixel_tile.glsl"
#include "frame/glsl/surface.glsl"
#include "shadow/map/glsl/explain_main.glsl"
