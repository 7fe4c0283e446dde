// What the colours of an overlay mean.
#pragma once

#include <span>

#include "shadow/map/glsl/explain_data.glsl"

namespace gnomon::viewer {

// For Dear ImGui's draw lists.
uint32_t to_colour(const vec3& colour, float alpha = 1.0f);

void remark(const char* text);  // grey, wrapped

// `views`: of the map, for overlays that show its layers; `second`: of the second side's.
void show_legend(uint32_t overlay, std::span<const ShadowView> views, std::span<const ShadowView> second);

}  // namespace gnomon::viewer
