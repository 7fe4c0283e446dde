// chart/fence: one quad with an alpha-tested texture of upright bars over a floor. The texture is fully opaque or fully clear
// in blocks of texels, so a bilinear lookup of its full-size level crosses alpha = 0.5 exactly on the border of a block.
#include "scene/builtin/parts/chart.h"
#include "scene/builtin/parts/shapes.h"

namespace gnomon {
namespace {

constexpr int k_block = 16;      // texels
constexpr float k_width = 4.0f;  // metres, of the quad
constexpr float k_height = 1.5f;

// Clear, opaque, clear, ..., clear: 2 * bars + 1 blocks.
Image8 bars_texture(int bars) {
  Image8 image((2 * bars + 1) * k_block, 4);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      uint8_t* texel = image.at(x, y);
      texel[0] = 140, texel[1] = 60, texel[2] = 40, texel[3] = (x / k_block) % 2 == 1 ? 255 : 0;
    }
  }
  return image;
}

}  // namespace

static Scene make_chart_fence(const BuiltinOptions& options) {
  const int bars = static_cast<int>(options.at("bars"));
  const auto gap = static_cast<float>(options.at("gap"));
  Scene scene = chart_with_floor("chart/fence", 20.0f, options);
  Material material = scene.materials[1];
  material.name = "bars", material.base_colour = vec4(1.0f), material.masked = true, material.double_sided = true;
  material.base_colour_texture = add_texture(scene, "bars", bars_texture(bars), true, Wrap::clamp);
  MeshPart quad = part_of(add_material(scene, material));
  const float z = 0.5f * k_width, top = gap + k_height;
  add_quad(quad, {0, gap, z}, {0, gap, -z}, {0, top, -z}, {0, top, z}, {0, 0}, {1, 1});
  add_object(scene, "fence", add_mesh(scene, "fence", {quad}));
  const vec3 shadow = shadow_on_floor(scene, {0, gap + 0.5f * k_height, 0});
  scene.cameras.push_back(look_at("default", shadow + vec3(2.6f, 3.2f + 0.5f * gap, 1.2f), shadow, 45.0));

  StripsOccluder strips{{}, gap, top};
  for (int bar = 0; bar < bars; ++bar) {  // u runs along -Z
    const double u0 = (2 * bar + 1.0) / (2 * bars + 1), u1 = (2 * bar + 2.0) / (2 * bars + 1);
    strips.z_intervals.push_back({z - u1 * k_width, z - u0 * k_width});
  }
  scene.closed_form = floor_visibility(std::move(strips));
  return scene;
}

BuiltinScene builtin_scene_chart_fence() {
  return {"chart/fence", "Alpha-tested bars over a floor, with the exact visibility of every floor point.",
          with_sun(50, 12,
                   {{"bars", 12, 1, 64, "Number of bars on four metres"},
                    {"gap", 0.2, 0.0, 5.0, "Height of the bars' lower end above the floor [m]"}}),
          make_chart_fence};
}

}  // namespace gnomon
