// What shading makes of the masks.
#include <cmath>

#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using glm::dvec3;
using test::device;
using test::View;

// A sphere seen from the side: half of what the camera sees faces away from the sun.
Scene half_lit_sphere() {
  MeshPart sphere = part_of(0);
  add_sphere(sphere, {0, 0, 0}, 1.0f, 64, 32, {1, 1});
  Scene scene = test::scene_with({std::move(sphere)});
  scene.cameras.push_back(look_at("side", {0, 0.5f, 4}, {0, 0, 0}, 40.0));
  scene.lights.push_back(test::make_sun({1, -0.2f, 0}));
  return scene;
}

ImageF shaded(View& view, float visibility) {
  view.draw();
  view.frame().write_mask(0, std::vector<float>(view.frame().sample_count(), visibility));
  view.shade();
  return view.frame().read_linear();
}

dvec3 rgb(const ImageF& image, size_t pixel) {
  const float* p = &image.values[pixel * 4];
  return {p[0], p[1], p[2]};
}

TEST(Shading, SurfaceThatFacesAwayIsAmbientWhateverTheMask) {
  View view(half_lit_sphere());
  const ImageF lit = shaded(view, 1.0f), dark = shaded(view, 0.0f);
  const auto points = view.frame().read_points();
  const vec3 direction = view.scene().lights[0].direction;
  size_t away = 0, facing = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    if (points[i].object == k_no_object) continue;
    const float cosine = -glm::dot(points[i].geometric_normal_ws, direction);
    if (cosine < -1e-3f) {
      ++away;
      EXPECT_EQ(rgb(lit, i), rgb(dark, i)) << "pixel " << i;
    } else if (cosine > 0.1f) {
      ++facing;
      EXPECT_GT(rgb(lit, i).x, rgb(dark, i).x);
    }
  }
  EXPECT_GT(away, 200u);
  EXPECT_GT(facing, 200u);
}

TEST(Shading, IsAmbientPlusVisibilityTimesLambert) {
  // A floor that faces a sun of irradiance 3: exposure and ambient are then as the parameters say (frame.params).
  Scene scene = test::scene_with({test::floor_part(50.0f)});
  scene.cameras.push_back(look_at("down", {0, 3, 2}, {0, 0, 0}, 40.0));
  scene.lights.push_back(test::make_sun({0.6f, -0.8f, 0}));
  scene.materials[0].base_colour = vec4(1.0f);  // what the 8-bit attachment holds exactly
  View view(scene);
  frame_params::Params params;
  const dvec3 albedo(1.0);
  const dvec3 ambient = albedo * double(params.ambient) * dvec3(0.80, 0.95, 1.15);
  for (const float visibility : {0.0f, 0.25f, 1.0f}) {
    const ImageF image = shaded(view, visibility);
    const dvec3 expected = ambient + albedo / double(k_pi) * 3.0 * 0.8 * double(visibility);
    const dvec3 found = rgb(image, 32 * 64 + 32);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(found[c], expected[c], 1e-3 * expected[c]) << "visibility " << visibility << ", channel " << c;
    EXPECT_EQ(image.values[(32 * 64 + 32) * 4 + 3], 1.0f) << "coverage";
  }
}

// KHR_lights_punctual: within its range the light of a lamp falls by max(min(1 - (d / range)^4, 1), 0) / d^2.
TEST(Shading, LightFallsWithTheDistanceAsGltfSays) {
  constexpr double k_range = 6.0, k_candela = 50.0;
  Scene scene = test::scene_with({test::floor_part(50.0f)});
  scene.materials[0].base_colour = vec4(1.0f);
  scene.cameras.push_back(look_at("down", {0, 9, 0.01f}, {0, 0, 0}, 60.0));
  Light lamp;
  lamp.kind = LightKind::point;
  lamp.position = vec3(0, 2, 0);
  lamp.intensity = static_cast<float>(k_candela);
  lamp.range = static_cast<float>(k_range);
  scene.lights.push_back(lamp);
  View view(scene);
  const ImageF lit = shaded(view, 1.0f), dark = shaded(view, 0.0f);
  const auto points = view.frame().read_points();
  size_t within = 0, beyond = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const dvec3 to_light = dvec3(lamp.position) - dvec3(points[i].position_ws);
    const double distance = glm::length(to_light), share = distance / k_range;
    const double expected =
        k_candela * std::max(1.0 - std::pow(share, 4.0), 0.0) / (distance * distance) * (to_light.y / distance) / double(k_pi);
    EXPECT_NEAR(rgb(lit, i).x - rgb(dark, i).x, expected, 2e-3 * expected + 1e-5) << "at " << distance << " m";
    ++(share < 1.0 ? within : beyond);
  }
  EXPECT_GT(within, 500u);
  EXPECT_GT(beyond, 100u);
}

double display_value(double c) {
  c = std::clamp((c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);  // Narkowicz 2015
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

TEST(Shading, DisplayIsTheCurveOfTheLinearPicture) {
  for (const float exposure : {0.5f, 1.0f, 4.0f}) {
    View view(half_lit_sphere());
    frame_params::Params params;
    params.exposure = exposure;
    view.frame().set_params(params);
    view.frame().set_camera(view.scene().cameras[0]);
    const ImageF linear = shaded(view, 1.0f);
    const Image8 display = view.frame().read_display();
    for (size_t i = 0; i < size_t{64} * 64; ++i) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(display.rgba[i * 4 + c], 255.0 * display_value(rgb(linear, i)[c] * double(exposure)), 1.0) << "pixel " << i;
      }
      ASSERT_EQ(display.rgba[i * 4 + 3], 255);
    }
  }
}

TEST(Shading, LinearPictureDoesNotDependOnExposureWhereThereIsASurface) {
  View view(half_lit_sphere());
  const ImageF before = shaded(view, 1.0f);
  frame_params::Params params;
  params.exposure = 7.0f;
  view.frame().set_params(params);
  view.frame().set_camera(view.scene().cameras[0]);
  const ImageF after = shaded(view, 1.0f);
  const auto points = view.frame().read_points();
  for (size_t i = 0; i < points.size(); ++i) {
    if (points[i].object != k_no_object) {
      ASSERT_EQ(rgb(before, i), rgb(after, i));
    }
  }
}

TEST(Shading, NormalMapsCanBeSwitchedOff) {
  // One texel that leans the normal 45 degrees toward the sun.
  Scene scene = test::scene_with({});
  Image8 image(1, 1);
  const uint8_t texel[4] = {218, 128, 218, 255};
  std::copy(texel, texel + 4, image.rgba.data());
  Material material = scene.materials[0];
  material.normal_texture = add_texture(scene, "lean", std::move(image), false);
  MeshPart part = part_of(add_material(scene, material));
  add_quad(part, {-5, 0, 5}, {5, 0, 5}, {5, 0, -5}, {-5, 0, -5}, {0, 0}, {1, 1});
  add_object(scene, "floor", add_mesh(scene, "floor", {part}));
  scene.cameras.push_back(look_at("down", {0, 3, 2}, {0, 0, 0}, 40.0));
  const vec3 tangent(scene.meshes[0].parts[0].tangents[0]);
  scene.lights.push_back(test::make_sun(-tangent - vec3(0, 1, 0)));  // from where the mapped normal points
  View view(scene);
  const double on = rgb(shaded(view, 1.0f), 32 * 64 + 32).x - rgb(shaded(view, 0.0f), 32 * 64 + 32).x;
  frame_params::Params params;
  params.normal_maps = 0;
  view.frame().set_params(params);
  view.frame().set_camera(view.scene().cameras[0]);
  const double off = rgb(shaded(view, 1.0f), 32 * 64 + 32).x - rgb(shaded(view, 0.0f), 32 * 64 + 32).x;
  EXPECT_NEAR(off / on, std::sqrt(0.5), 0.01);
}

TEST(Shading, SkyHasNoCoverageAndSamplesAverage) {
  const auto& counts = device().info().sample_counts;
  if (std::find(counts.begin(), counts.end(), 4) == counts.end()) GTEST_SKIP() << "the device has no 4 samples";
  View view(half_lit_sphere(), {64, 64}, 4);
  const ImageF image = shaded(view, 1.0f);
  const auto points = view.frame().read_points();
  size_t edges = 0;
  for (size_t i = 0; i < size_t{64} * 64; ++i) {
    int covered = 0;
    for (size_t s = 0; s < 4; ++s) covered += points[i * 4 + s].object != k_no_object;
    ASSERT_EQ(image.values[i * 4 + 3], 0.25f * static_cast<float>(covered));
    edges += covered > 0 && covered < 4;
  }
  EXPECT_GT(edges, 20u);
  EXPECT_EQ(image.values[3], 0.0f) << "a corner of the picture is sky";
}

TEST(Shading, EveryLightHasItsOwnMask) {
  Scene scene = half_lit_sphere();
  scene.lights.push_back(test::make_sun({-1, -0.2f, 0}));
  View view(std::move(scene));
  view.draw();
  const std::vector<float> ones(view.frame().sample_count(), 1.0f), zeros(view.frame().sample_count(), 0.0f);
  const auto picture = [&](const std::vector<float>& first, const std::vector<float>& second) {
    view.frame().write_mask(0, first);
    view.frame().write_mask(1, second);
    view.shade();
    EXPECT_EQ(view.frame().read_mask(0), first);
    EXPECT_EQ(view.frame().read_mask(1), second);
    return view.frame().read_linear();
  };
  const ImageF none = picture(zeros, zeros), a = picture(ones, zeros), b = picture(zeros, ones), both = picture(ones, ones);
  double worst = 0.0;
  for (size_t i = 0; i < none.values.size(); ++i) {
    if (i % 4 != 3)
      worst = std::max(worst, std::abs(double(both.values[i] - none.values[i]) - double(a.values[i] - none.values[i]) -
                                       double(b.values[i] - none.values[i])));
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_NE(a.values, b.values);
}

}  // namespace
}  // namespace gnomon
