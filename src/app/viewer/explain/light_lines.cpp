#include "app/viewer/explain/light_lines.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/viewer/explain/legend.h"

namespace gnomon::viewer {
namespace {

constexpr int k_circle = 48;  // lines of a full circle

class Lines {
 public:
  Lines(ImDrawList& list, const CameraData& camera, vec2 size) : list_(list), camera_(camera), size_(size) {}

  void draw(const vec3& a_ws, const vec3& b_ws, ImU32 colour, float width) const {
    vec4 a = camera_.clip_from_world * vec4(a_ws, 1.0f), b = camera_.clip_from_world * vec4(b_ws, 1.0f);
    // Reversed Z: what lies before the near plane has z > w.
    const float before_a = a.w - a.z, before_b = b.w - b.z;
    if (before_a <= 0.0f && before_b <= 0.0f) return;
    if (before_a <= 0.0f) a = glm::mix(b, a, 0.999f * before_b / (before_b - before_a));
    if (before_b <= 0.0f) b = glm::mix(a, b, 0.999f * before_a / (before_a - before_b));
    const ImVec2 from = place(a), to = place(b);
    list_.AddLine(from, to, IM_COL32(0, 0, 0, 110), width + 2.0f);  // a dark edge: seen on every ground
    list_.AddLine(from, to, colour, width);
  }

  // The twelve edges of a hexahedron, corners as slice_corners gives them.
  void box(const std::array<vec3, 8>& corners, ImU32 colour, float width) const {
    for (size_t i = 0; i < 8; ++i) {
      for (size_t bit = 1; bit < 8; bit *= 2) {
        if (!(i & bit)) draw(corners[i], corners[i | bit], colour, width);
      }
    }
  }

 private:
  ImVec2 place(const vec4& clip) const {
    const float x = clip.x / clip.w * 0.5f + 0.5f, y = clip.y / clip.w * 0.5f + 0.5f;
    // Far outside, floats of the rasteriser end.
    return {std::clamp(x, -50.0f, 50.0f) * size_.x, std::clamp(y, -50.0f, 50.0f) * size_.y};
  }

  ImDrawList& list_;
  const CameraData& camera_;
  vec2 size_;
};

vec3 from_clip(const ShadowView& view, const vec3& ndc) {
  const vec4 p = view.world_from_clip * vec4(ndc, 1.0f);
  return vec3(p) / p.w;
}

// A half of all directions: its rim, and two arcs over it.
void draw_paraboloid(const Lines& lines, const ShadowView& view, float radius_m, ImU32 colour) {
  const mat3 light_from_world(view.raster.clip_from_world);
  const auto place = [&](const vec3& direction) {
    return view.origin_ws + glm::transpose(light_from_world) * direction * radius_m;
  };
  for (int i = 0; i < k_circle; ++i) {
    const auto angle = [](int step) { return 2.0f * k_pi * static_cast<float>(step) / k_circle; };
    const float a = angle(i), b = angle(i + 1);
    lines.draw(place({std::cos(a), std::sin(a), 0}), place({std::cos(b), std::sin(b), 0}), colour, 1.5f);
    if (2 * i >= k_circle) continue;
    lines.draw(place({std::cos(a), 0, std::sin(a)}), place({std::cos(b), 0, std::sin(b)}), colour, 1.0f);
    lines.draw(place({0, std::cos(a), std::sin(a)}), place({0, std::cos(b), std::sin(b)}), colour, 1.0f);
  }
}

}  // namespace

void draw_light_lines(ImDrawList& list, const CameraData& camera, vec2 size, std::span<const ShadowView> views,
                      const CameraData* split_camera, float scene_radius_m) {
  const Lines lines(list, camera, size);
  for (size_t i = 0; i < views.size(); ++i) {
    const ShadowView& view = views[i];
    if (view.raster.in_use == 0) continue;
    const ImU32 colour = to_colour(layer_colour(static_cast<uint32_t>(i)));
    if (view.raster.kind == k_view_paraboloid) {
      draw_paraboloid(lines, view, std::min(view.raster.far_m, 0.5f * scene_radius_m), colour);
      continue;
    }
    std::array<vec3, 8> corners;
    for (size_t corner = 0; corner < 8; ++corner) {
      corners[corner] = from_clip(view, {corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f, corner & 4 ? 1.0f : 0.0f});
    }
    lines.box(corners, colour, 1.5f);
    // Layers that are no slices of the view end at no distance.
    if (!split_camera || view.interval_m.y > 1e30f) continue;
    lines.box(slice_corners(*split_camera, view.interval_m.x, view.interval_m.y),
              to_colour(0.6f * layer_colour(static_cast<uint32_t>(i)) + 0.4f), 1.0f);
  }
}

}  // namespace gnomon::viewer
