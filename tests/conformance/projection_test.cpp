// Projections against theory: warps hold what is visible and keep its order, paraboloids agree with rays, fits to samples are
// no worse than fits to the view; lights from everywhere lose no caster.
#include <cmath>

#include "measure/visibility_error.h"
#include "shadow/map/warp.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::View;

// --- Warps

struct WarpCase {
  Camera camera;
  Light light;
  const char* name;
};

constexpr float k_degree = k_pi / 180.0f;

vec3 sun_direction(float elevation_deg, float azimuth_deg) {
  const float e = elevation_deg * k_degree, a = azimuth_deg * k_degree;
  return -vec3(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a));
}

template <class Action>
void for_each_warp(const Action& action) {
  Box scene, casters;
  scene.min = vec3(-40, -1, -60), scene.max = vec3(40, 12, 60);
  casters.min = vec3(-38, 0, -55), casters.max = vec3(38, 12, 55);
  const Camera cameras[] = {look_at("level", {0, 1.7f, 30}, {0, 1.5f, 0}, 60.0),
                            look_at("down", {3, 30, 2}, {3, 0, 1.99f}, 60.0), look_at("steep", {-5, 20, 20}, {0, 0, 0}, 90.0),
                            look_at("outside", {0, 40, 200}, {0, 0, 0}, 30.0)};
  for (const Camera& camera : cameras) {
    for (const bool orthographic : {false, true}) {
      Camera lens = camera;
      lens.orthographic = orthographic, lens.half_height = 10.0f;
      const CameraData data = camera_data(lens, {160, 90}, 1);
      for (const float elevation : {0.5f, 5.0f, 20.0f, 50.0f, 85.0f, 89.99f, 90.0f}) {
        for (float azimuth = 0.0f; azimuth < 360.0f; azimuth += 45.0f) {
          SCOPED_TRACE(fmt::format("{}, elevation {}, azimuth {}", camera.name, elevation, azimuth));
          const Light sun = test::make_sun(sun_direction(elevation, azimuth));
          action(warp_fit(data, sun, casters, scene, data.near_m, 300.0f), data);
        }
      }
    }
  }
}

TEST(Warp, EveryVisiblePointIsInsideTheMap) {
  for_each_warp([](const WarpFit& fit, const CameraData&) {
    for (const float distance :
         {light_space_perspective_distance(fit, 0.02f, 1.0f), light_space_perspective_distance(fit, 0.0f, 10.0f),
          trapezoidal_distance(fit, 0.25f, 0.8f), trapezoidal_distance(fit, 0.001f, 0.99f), k_no_warp}) {
      ASSERT_TRUE(distance > 0.0f);
      const ShadowView view = warped_view(fit, distance, 1024, 4.0f);
      for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
          ASSERT_TRUE(std::isfinite(view.raster.clip_from_world[column][row]));
          ASSERT_TRUE(std::isfinite(view.world_from_clip[column][row]));
        }
      }
      ASSERT_TRUE(view.texel_m > 0.0f && std::isfinite(view.texel_m) && std::isfinite(view.texel_along_m));
      for (const vec3& p : fit.body) {
        const vec4 clip = light_clip(view.raster, fit.axes.world_from_light * p);
        ASSERT_GT(clip.w, 0.0f);
        ASSERT_LE(std::abs(clip.x), 1.001f * clip.w);
        ASSERT_LE(std::abs(clip.y), 1.001f * clip.w);
        ASSERT_GE(clip.z, 0.0f);
        ASSERT_LE(clip.z, clip.w);
        // Linear depth is proportional to metres along the light.
        const vec4 ndc = clip / clip.w;
        const float linear = glm::dot(view.linear_numerator, ndc) / glm::dot(view.linear_denominator, ndc);
        EXPECT_NEAR(linear * view.depth_range_m, p.z - (fit.first_caster_z - 1e-3f * view.depth_range_m),
                    2e-3f * view.depth_range_m);
      }
    }
  });
}

TEST(Warp, PlacesKeepTheirOrderAndLightStaysParallel) {
  for_each_warp([](const WarpFit& fit, const CameraData&) {
    if (fit.body.empty()) return;
    for (const float distance : {light_space_perspective_distance(fit, 0.02f, 1.0f), trapezoidal_distance(fit, 0.25f, 0.8f)}) {
      const ShadowView view = warped_view(fit, distance, 1024, 4.0f);
      float last = -2.0f;
      for (int i = 0; i <= 64; ++i) {
        vec3 p = fit.bounds.centre();
        p.y = glm::mix(fit.bounds.min.y, fit.bounds.max.y, static_cast<float>(i) / 64.0f);
        const vec4 deep = light_clip(view.raster, fit.axes.world_from_light * p);
        p.z -= 3.0f;
        const vec4 shallow = light_clip(view.raster, fit.axes.world_from_light * p);
        EXPECT_GT(deep.y / deep.w, last);
        last = deep.y / deep.w;
        EXPECT_NEAR(shallow.x / shallow.w, deep.x / deep.w, 1e-3f);
        EXPECT_NEAR(shallow.y / shallow.w, deep.y / deep.w, 1e-3f);
        EXPECT_LT(shallow.z / shallow.w, deep.z / deep.w);
      }
    }
  });
}

TEST(Warp, FocusGetsItsShareOfTheMap) {
  const CameraData camera = camera_data(look_at("level", {0, 2, 50}, {0, 2, 0}, 60.0), {160, 90}, 1);
  Box box;
  box.min = vec3(-50, 0, -50), box.max = vec3(50, 10, 49);
  const WarpFit fit = warp_fit(camera, test::make_sun({0, -1, 0}), box, box, 0.1f, 100.0f);
  const ShadowView view = warped_view(fit, trapezoidal_distance(fit, 0.25f, 0.8f), 1024, 0.0f);
  const float depth = glm::mix(fit.nearest_m, fit.farthest_m, 0.25f);
  const vec4 clip = light_clip(view.raster, camera.eye_ws + depth * camera.forward_ws);
  EXPECT_NEAR(0.5f + 0.5f * clip.y / clip.w, 0.8f, 0.01f);
}

TEST(Warp, GoesSmoothlyToUniformWhenTheLightTurnsAlongTheView) {
  Box box;
  box.min = vec3(-50, 0, -50), box.max = vec3(50, 10, 50);
  const Camera camera = look_at("down", {0, 40, 0}, {0, 0, 0.01f}, 60.0);
  const CameraData data = camera_data(camera, {160, 90}, 1);
  float last_perspective = 0.0f, last_trapezoid = 0.0f;
  for (const float angle : {60.0f, 45.0f, 30.0f, 20.0f, 10.0f, 5.0f, 2.0f, 1.0f, 0.5f}) {
    const WarpFit fit =
        warp_fit(data, test::make_sun({std::sin(angle * k_degree), -std::cos(angle * k_degree), 0}), box, box, 0.1f, 50.0f);
    const float perspective = light_space_perspective_distance(fit, 0.02f, 1.0f) / fit.bounds.extent().y;
    const float trapezoid = trapezoidal_distance(fit, 0.25f, 0.8f) / fit.bounds.extent().y;
    EXPECT_GT(perspective, last_perspective) << angle;
    EXPECT_GT(trapezoid, last_trapezoid) << angle;
    last_perspective = perspective, last_trapezoid = trapezoid;
  }
  EXPECT_GT(last_perspective, 50.0f);
  EXPECT_GT(last_trapezoid, 50.0f);
}

TEST(Warp, ClippingACubeByACornerLeavesItsOtherCorners) {
  std::array<vec3, 8> cube;
  for (int i = 0; i < 8; ++i) cube[static_cast<size_t>(i)] = vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  const vec4 off_corner(-1, -1, -1, 2.5f), nothing(1, 0, 0, -2), half(1, 0, 0, -0.5f);
  Box box;
  size_t corners = 0;
  for (const vec3& p : clipped_corners(cube, std::array{off_corner})) {
    box.add(p);
    ++corners;
    EXPECT_LE(p.x + p.y + p.z, 2.5f + 1e-5f);
  }
  EXPECT_GE(corners, 10u);
  EXPECT_EQ(box.max, vec3(1));
  EXPECT_TRUE(clipped_corners(cube, std::array{nothing}).empty());
  Box cut;
  for (const vec3& p : clipped_corners(cube, std::array{half, off_corner})) cut.add(p);
  EXPECT_NEAR(cut.min.x, 0.5f, 1e-6f);
}

// --- Masks against rays

struct Measured {
  double mae;
  std::vector<float> mask;
};

Measured measure(View& view, const std::string& technique, std::initializer_list<std::string_view> assignments) {
  const auto& spec = find_technique(technique);
  Measured result;
  result.mask = test::run_technique(view, spec, test::settings_of(spec, assignments)).mask;
  for (const float v : result.mask) EXPECT_TRUE(v >= 0.0f && v <= 1.0f) << technique;
  const auto points = view.frame().read_points();
  const auto truth =
      EmbreeReference(view.scene()).trace(points, view.frame().camera().eye_ws, view.scene().lights[0], false, 1, 1);
  result.mae = visibility_error(result.mask, truth.visibility, truth.receiver).mae;
  return result;
}

// Quads of at most `side` metres.
void add_fine_quad(MeshPart& part, const vec3& a, const vec3& b, const vec3& d, float side) {
  const int n = static_cast<int>(std::ceil(glm::length(b - a) / side)),
            m = static_cast<int>(std::ceil(glm::length(d - a) / side));
  const auto at = [&](int i, int j) {
    return a + (b - a) * (static_cast<float>(i) / static_cast<float>(n)) +
           (d - a) * (static_cast<float>(j) / static_cast<float>(m));
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) add_quad(part, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), {0, 0}, {1, 1});
  }
}

void add_fine_box(MeshPart& part, const vec3& low, const vec3& high, float side) {
  for (int axis = 0; axis < 3; ++axis) {
    vec3 u(0.0f), v(0.0f);
    u[(axis + 1) % 3] = high[(axis + 1) % 3] - low[(axis + 1) % 3],
                   v[(axis + 2) % 3] = high[(axis + 2) % 3] - low[(axis + 2) % 3];
    vec3 top = low;
    top[axis] = high[axis];
    add_fine_quad(part, top, top + u, top + v, side);
    add_fine_quad(part, low, low + v, low + u, side);
  }
}

// A lamp between boxes: its shadows go up, down and across both halves.
Scene lamp_among_boxes(float side) {
  MeshPart part = part_of(0);
  add_fine_quad(part, {-5, 0, 5}, {5, 0, 5}, {-5, 0, -5}, side);
  add_fine_quad(part, {-5, 0, -5}, {5, 0, -5}, {-5, 6, -5}, side);
  for (int i = 0; i < 5; ++i) {
    const float angle = 1.2566f * static_cast<float>(i);
    const vec3 at(2.0f * std::cos(angle), 0.8f + 0.9f * static_cast<float>(i), 2.0f * std::sin(angle));
    add_fine_box(part, at - vec3(0.4f), at + vec3(0.4f), side);
  }
  Scene scene = test::scene_with({part});
  scene.cameras.push_back(look_at("beside", {5, 6, 8}, {0, 1.5f, -1}, 60.0));
  Light lamp = test::make_light(LightKind::point, {0, -1, 0}, {0.1f, 0, 0.1f}, 2.3f);
  scene.lights.push_back(lamp);
  return scene;
}

TEST(Paraboloid, AgreesWithRaysAndBendsOnlyWhereTrianglesAreCoarse) {
  double bent_coarse = 0.0, exact_worst = 0.0;
  for (const float side : {20.0f, 0.1f}) {
    View view(lamp_among_boxes(side), {160, 120});
    for (const std::string_view axis :
         {"dual_paraboloid.axis=scene", "dual_paraboloid.axis=down", "dual_paraboloid.axis=view"}) {
      const double exact = measure(view, "dual_paraboloid/hard", {"dual_paraboloid.size=2048", axis}).mae;
      const double bent =
          measure(view, "dual_paraboloid/hard", {"dual_paraboloid.size=2048", "dual_paraboloid.triangles=bent", axis}).mae;
      fmt::print("triangles of {} m, {}: mae exact {:.5f}, bent {:.5f}\n", side, axis, exact, bent);
      EXPECT_LT(exact, 0.01);
      exact_worst = std::max(exact_worst, exact);
      if (side < 1.0f)
        EXPECT_LT(bent, 0.02);
      else
        bent_coarse = std::max(bent_coarse, bent);
    }
  }
  EXPECT_GT(bent_coarse, 3.0 * exact_worst) << "coarse triangles are expected to bend";
}

View& courtyard() {
  return test::kept_view("courtyard", [] { return load_scene("courtyard"); }, {160, 120});
}

TEST(SampleDistribution, OneSplitIsNoWorseThanOneMapOfTheView) {
  const double single = measure(courtyard(), "single/hard", {"single.size=512", "single.fit=view"}).mae;
  const double one =
      measure(courtyard(), "sample_distribution/hard", {"sample_distribution.size=512", "sample_distribution.count=1"}).mae;
  const double loose =
      measure(courtyard(), "sample_distribution/hard",
              {"sample_distribution.size=512", "sample_distribution.count=1", "sample_distribution.tight=false"})
          .mae;
  const double four = measure(courtyard(), "sample_distribution/hard", {"sample_distribution.size=512"}).mae;
  fmt::print("courtyard, 512: single {:.5f}, one split {:.5f} (of the view: {:.5f}), four splits {:.5f}\n", single, one, loose,
             four);
  EXPECT_LT(single, 0.08) << "what the camera sees is in the map";
  EXPECT_LE(one, single);
  EXPECT_LE(loose, 1.1 * single);
  EXPECT_LT(four, 0.7 * one);
}

TEST(SampleDistribution, SkyAloneIsLit) {
  View view(load_scene("courtyard"), {64, 48});
  const vec3 eye(0, 400, 0);
  view.frame().set_camera(look_at("up", eye, eye + vec3(0.1f, 1, 0), 50.0));
  const auto& spec = find_technique("sample_distribution/hard");
  for (const float v : test::run_technique(view, spec, spec.default_settings()).mask) ASSERT_EQ(v, 1.0f);
}

// The light from every elevation, from behind the viewer, toward the viewer and along the view: nothing is lost, and one map
// that is fitted better is not worse than one that is fitted worse.
TEST(Projection, LightsFromEverywhere) {
  const std::pair<std::string, std::string> techniques[] = {
      {"light_space_perspective/hard", "light_space_perspective.size=1024"},
      {"trapezoidal/hard", "trapezoidal.size=1024"},
      {"sample_distribution/hard", "sample_distribution.size=1024"}};
  const std::pair<float, float> angles[] = {{5, 0}, {5, 180}, {20, 0}, {20, 90}, {50, 30}, {85, 0}};
  for (const auto& [elevation, azimuth] : angles) {
    Scene scene = load_scene("courtyard");
    const vec3 forward = -vec3(scene.cameras.at(0).world_from_view[2]);
    const float heading = std::atan2(forward.x, forward.z) / k_degree;
    // azimuth 0: the viewer looks toward the sun.
    scene.lights[0].direction = sun_direction(elevation, heading + azimuth);
    scene.lights[0].angular_diameter = 0.0f;
    View view(std::move(scene), {160, 120});
    const double single = measure(view, "single/hard", {"single.size=1024"}).mae;
    for (const auto& [technique, size] : techniques) {
      const double mae = measure(view, technique, {size}).mae;
      fmt::print("elevation {}, azimuth {}: single {:.5f}, {} {:.5f}\n", elevation, azimuth, single, technique, mae);
      // The trapezoid gives the foreground its share whether or not the shadows are there.
      EXPECT_LT(mae, (technique == "trapezoidal/hard" ? 1.6 : 1.2) * single + 0.002)
          << technique << ", elevation " << elevation << ", azimuth " << azimuth;
    }
  }
}

// What stands between the inner and the outer angle of a cone casts as what stands before the light does.
TEST(Projection, ShadowsReachTheRimOfACone) {
  std::vector<MeshPart> parts = {test::floor_part(8.0f)};
  for (const vec3& at : {vec3(3.4f, 0.8f, 0), vec3(-3.4f, 0.8f, 0), vec3(0, 0.8f, 3.4f), vec3(0, 0.8f, -3.4f)})
    parts.push_back(test::box_part(at - vec3(0.3f), at + vec3(0.3f)));
  Scene scene = test::scene_with(std::move(parts));
  scene.cameras.push_back(look_at("above", {0, 14, 0.01f}, {0, 0, 0}, 50.0));
  Light spot = test::make_light(LightKind::spot, {0, -1, 0}, {0, 0, 0}, 4.0f);
  spot.inner_cone = 0.2f, spot.outer_cone = 0.95f;
  scene.lights.push_back(spot);
  View view(std::move(scene), {120, 120});
  const ReferenceResult& truth = test::hard_reference(view);
  size_t shadowed = 0;
  for (size_t i = 0; i < truth.visibility.size(); ++i) shadowed += truth.receiver[i] && truth.visibility[i] == 0.0f;
  ASSERT_GT(shadowed, 100u);
  for (const auto& spec : all_techniques()) {
    if (!spec.name.ends_with("/hard") || !spec.supports(LightKind::spot)) continue;
    const auto mask = test::run_technique(view, spec, spec.default_settings()).mask;
    size_t lost = 0;
    for (size_t i = 0; i < mask.size(); ++i) lost += truth.receiver[i] && truth.visibility[i] == 0.0f && mask[i] > 0.5f;
    EXPECT_LT(lost, shadowed / 20) << spec.name;
  }
}

// Sheets, one turned to the light and one away from it: culling of the faces that the light sees leaves the other one.
TEST(Projection, FacesTowardTheLightAreLeftOutWhereThatIsAskedFor) {
  for (const LightKind kind : {LightKind::directional, LightKind::point, LightKind::spot}) {
    MeshPart toward = part_of(0), away = part_of(0);
    add_quad(toward, {-2, 1, 0.5f}, {-1, 1, 0.5f}, {-1, 1, -0.5f}, {-2, 1, -0.5f}, {0, 0}, {1, 1});
    add_quad(away, {1, 1, -0.5f}, {2, 1, -0.5f}, {2, 1, 0.5f}, {1, 1, 0.5f}, {0, 0}, {1, 1});
    Scene scene = test::scene_with({test::floor_part(4.0f), toward, away});
    scene.cameras.push_back(look_at("beside", {0, 2.5f, 7}, {0, 0, 0}, 45.0));
    scene.lights.push_back(test::make_light(kind, {0, -1, 0}, {0, 0, 0}, 5.0f));
    View view(std::move(scene), {96, 64});
    view.draw();
    const auto points = view.frame().read_points();
    for (const auto& spec : all_techniques()) {
      if (!spec.name.ends_with("/hard") || !spec.supports(kind)) continue;
      for (const bool culls : {false, true}) {
        const auto mask =
            test::run_technique(
                view, spec, test::settings_of(spec, {culls ? "bias.front_face_culling=true" : "bias.front_face_culling=false"}))
                .mask;
        size_t seen[2] = {}, dark[2] = {};  // under the sheet that is turned to the light, and under the other
        for (size_t i = 0; i < mask.size(); ++i) {
          const vec3 at = points[i].position_ws;
          const float x = std::abs(at.x);
          if (points[i].object != 0 || x < 1.25f || x > 1.75f || std::abs(at.z) > 0.3f) continue;
          ++seen[at.x > 0.0f], dark[at.x > 0.0f] += mask[i] < 0.5f;
        }
        ASSERT_TRUE(seen[0] > 3 && seen[1] > 3);
        EXPECT_EQ(dark[0], culls ? 0 : seen[0]) << spec.name << ", turned to the light, culled: " << culls;
        EXPECT_EQ(dark[1], seen[1]) << spec.name << ", turned away, culled: " << culls;
      }
    }
  }
}

// Plates a hand's width and three metres behind the aperture; along the light the floor reaches so deep that a thousandth of it
// is more than that hand.
TEST(Projection, NothingBehindAProjectorCasts) {
  Light projector = test::make_light(LightKind::projector, {0.5f, -1, 0.2f}, {0, 0, 0}, 8.0f);
  projector.beam_radius = 3.0f;
  std::vector<MeshPart> parts = {test::floor_part(300.0f), test::box_part({-1, 0.5f, -1}, {1, 1.5f, 1})};
  vec3 x, y;
  orthonormal_basis(projector.direction, x, y);
  for (const float behind : {0.05f, 3.0f}) {
    const vec3 centre = projector.position - behind * projector.direction;
    MeshPart plate = part_of(0);
    add_quad(plate, centre - 4.0f * (x + y), centre + 4.0f * (x - y), centre + 4.0f * (x + y), centre - 4.0f * (x - y), {0, 0},
             {1, 1});
    parts.push_back(std::move(plate));
  }
  Scene scene = test::scene_with(std::move(parts));
  scene.cameras.push_back(look_at("beside", {6, 5, 6}, {0, 0.5f, 0}, 50.0));
  scene.lights.push_back(projector);
  View view(std::move(scene), {160, 120});
  for (const auto& spec : all_techniques()) {
    if (!spec.name.ends_with("/hard") || !spec.supports(LightKind::projector)) continue;
    EXPECT_LT(measure(view, spec.name, {}).mae, 0.02) << spec.name;
  }
  for (const std::string_view near : {"cascaded.near=clamp", "cascaded.near=slice"}) {
    EXPECT_LT(measure(view, "cascaded/hard", {near}).mae, 0.02) << near;
    EXPECT_LT(measure(view, "cascaded/hard", {near, "cascaded.warp=trapezoidal"}).mae, 0.02) << near << ", warped";
  }
}

TEST(Projection, LookingAlongTheLight) {
  Scene scene = load_scene("courtyard");
  const Box bounds = scene.bounds();
  const vec3 above = bounds.centre() + vec3(0, bounds.extent().y + 20.0f, 0);
  scene.cameras = {look_at("above", above, bounds.centre() + vec3(0, 0, 0.001f), 50.0)};
  for (const vec3& direction : {vec3(0, -1, 0), vec3(0.02f, -1, 0.01f)}) {
    Scene lit = scene;
    lit.lights[0].direction = glm::normalize(direction);
    View view(std::move(lit), {160, 120});
    const double single = measure(view, "single/hard", {"single.size=1024"}).mae;
    for (const char* technique : {"light_space_perspective/hard", "trapezoidal/hard", "sample_distribution/hard"}) {
      EXPECT_LT(measure(view, technique, {}).mae, 1.2 * single + 0.002) << technique;
    }
  }
}

}  // namespace
}  // namespace gnomon
