// How wide percentage-closer soft shadows are, in closed form: the edge of a plate under a disc-shaped sun and under spherical
// lamps.
#include <cmath>

#include "shadow/registry.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::View;

constexpr float k_height = 5.0f, k_lamp_radius = 0.25f, k_sun = 0.12f;  // metres, metres, angular radius

// A plate over a floor that ends above x = 0, seen from below the plate.
Scene plate_over_floor(LightKind kind, float height) {
  MeshPart plate = part_of(0);
  add_quad(plate, {-4, height, 4}, {0, height, 4}, {0, height, -4}, {-4, height, -4}, {0, 0}, {1, 1});
  Scene scene = test::scene_with({test::floor_part(4.5f), plate});
  scene.materials[0].double_sided = true;
  scene.cameras.push_back(look_at("below", {1.3f, 1.0f, 0}, {0, 0, 0}, 60.0));
  Light light = test::make_light(kind, {0, -1, 0}, {0, 0, 0}, k_height);
  light.radius = k_lamp_radius, light.angular_diameter = 2.0f * k_sun;
  scene.lights.push_back(light);
  return scene;
}

// Of a disc of radius 1, the share on one side of a line at t from its middle.
float disc_share(float t) { return 0.5f + (t * std::sqrt(1.0f - t * t) + std::asin(t)) / k_pi; }

// Its inverse: places that a mask tells.
float place_of(float share) {
  float low = -1.0f, high = 1.0f;
  for (int i = 0; i < 24; ++i) {
    const float middle = 0.5f * (low + high);
    (disc_share(middle) < share ? low : high) = middle;
  }
  return 0.5f * (low + high);
}

struct Edge {
  double half_width = 0.0, middle = 0.0;  // metres
  int samples = 0;
};

// The line through where samples lie against what they are told.
Edge edge_of(View& view, const std::vector<float>& mask) {
  const auto points = view.frame().read_points();
  double n = 0.0, x = 0.0, t = 0.0, xt = 0.0, tt = 0.0;
  for (size_t i = 0; i < mask.size(); ++i) {
    const vec3& p = points[i].position_ws;
    if (points[i].object == k_no_object || p.y > 0.01f || std::abs(p.x) > 1.0f || std::abs(p.z) > 1.0f || mask[i] < 0.03f ||
        mask[i] > 0.97f)
      continue;
    const double place = place_of(mask[i]);
    n += 1.0, x += p.x, t += place, xt += p.x * place, tt += place * place;
  }
  Edge edge;
  edge.samples = static_cast<int>(n);
  edge.half_width = (xt - x * t / n) / (tt - t * t / n);
  edge.middle = (x - edge.half_width * t) / n;
  return edge;
}

TEST(PenumbraWidth, IsThatOfTheLightsSizeAndTheGap) {
  // Texels as long as wide: the kernel is round in texels.
  struct Case {
    std::string projection, settings;
    LightKind kind;
  };
  for (const Case& c : {Case{"single", "single.fit=scene", LightKind::directional},
                        Case{"single", "single.fit=scene", LightKind::spot}, Case{"cube", "cube.border=4", LightKind::point},
                        Case{"dual_paraboloid", "dual_paraboloid.axis=scene", LightKind::point}}) {
    for (const float height : {1.5f, 3.0f}) {
      View& view = test::kept_view(fmt::format("plate {} {}", light_kind_name(c.kind), height),
                                   [&] { return plate_over_floor(c.kind, height); }, {64, 48});
      const auto& spec = find_technique(c.projection + "/pcss");
      const std::string size = c.projection + ".size=512";
      const auto mask =
          test::run_technique(
              view, spec,
              test::settings_of(spec, {size, c.settings, "pcss.taps=64", "pcss.search_taps=64", "pcss.rotate=false"}))
              .mask;
      const Edge edge = edge_of(view, mask);
      // Similar triangles: light / distance of the plate = penumbra / gap.
      const double expected =
          c.kind == LightKind::directional ? std::tan(k_sun) * height : k_lamp_radius * height / (k_height - height);
      fmt::print("{} {}, plate at {} m: half width {:.4f} m of {:.4f}, middle {:+.4f}, {} samples\n", c.projection,
                 light_kind_name(c.kind), height, edge.half_width, expected, edge.middle, edge.samples);
      ASSERT_GT(edge.samples, 60);
      EXPECT_NEAR(edge.half_width, expected, 0.12 * expected) << c.projection << ", " << height;
      EXPECT_NEAR(edge.middle, 0.0, 0.15 * expected) << c.projection << ", " << height;
    }
  }
}

}  // namespace
}  // namespace gnomon
