// Views of the light as projections lay them out: what each slice of the view asks of its map, and the borders that kernels
// need. No pictures are drawn, but for the samples that sample_distribution is fitted to.
#include <cmath>
#include <set>

#include "shadow/explainer.h"
#include "shadow/map/light_views.h"
#include "shadow/map/splits.h"
#include "shadow/map/warp.h"
#include "shadow/registry.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::View;

std::unique_ptr<Projection> projection(std::string_view id, std::initializer_list<std::pair<std::string_view, double>> values) {
  for (const ProjectionInfo& info : projections()) {
    if (info.id != id) continue;
    ParamBlock block(info.params);
    for (const auto& [name, value] : values) block.set_number(name, value, name);
    return info.make(block);
  }
  fail("no projection {}", id);
}

View& stage(LightKind kind) {
  return test::kept_view(fmt::format("busy {}", light_kind_name(kind)), [=] { return test::busy(kind); }, {64, 48});
}

// Texels from the nearest edge of the map; negative outside.
float texels_to_edge(const ShadowView& view, const vec3& p) {
  const vec4 clip = light_clip(view.raster, p);
  return 0.5f * view.size * (1.0f - std::max(std::abs(clip.x), std::abs(clip.y)) / clip.w);
}

TEST(Slices, CascadesHoldTheirsAndABorderAroundIt) {
  View& view = stage(LightKind::directional);
  const Frame& frame = view.frame();
  constexpr double k_border = 20.0;
  for (const double stabilise : {0.0, 1.0}) {
    const auto cascaded = projection("cascaded", {{"size", 256}, {"adapt", 0}, {"border", k_border}, {"stabilise", stabilise}});
    const auto views = cascaded->views(frame, view.scene().lights[0]);
    ASSERT_EQ(views.size(), cascaded->layers());
    for (size_t i = 0; i < views.size(); ++i) {
      const vec2 interval = views[i].interval_m;
      EXPECT_EQ(interval.x, i == 0 ? 0.0f : views[i - 1].interval_m.y) << "slice " << i << " begins where the last one ends";
      EXPECT_LT(interval.x, interval.y);
      const float from = i == 0 ? frame.camera().near_m : interval.x;
      for (const vec3& corner : slice_corners(frame.camera(), from, interval.y)) {
        // Snapping to whole texels may take one of the border.
        EXPECT_GE(texels_to_edge(views[i], corner), k_border - 1.01) << "slice " << i << ", stabilise " << stabilise;
      }
    }
  }
}

// From the nearest to the farthest sample, by the rule of cascades.
TEST(Slices, SamplesAreSplitByTheSameRule) {
  View& view = stage(LightKind::directional);
  const auto& spec = find_technique("sample_distribution/hard");
  for (const float lambda : {0.0f, 0.6f, 1.0f}) {
    const std::string mixed = fmt::format("sample_distribution.lambda={}", lambda);
    const auto technique = spec.make(view.context(), test::settings_of(spec, {"sample_distribution.size=64", mixed}));
    Explainer explainer(test::device());
    test::run_passes([&](Recorder& recorder) {
      view.frame().record_surface(recorder);
      technique->record(recorder, view.frame(), 0);
      explainer.record_views(recorder, *technique);
    });
    float near = 1e30f, far = 0.0f;
    for (const float z : test::read_surface<float>(view, "surface view_z")) {
      if (z > 0.0f) near = std::min(near, z), far = std::max(far, z);
    }
    ASSERT_GT(far, 2.0f * near);
    const auto views = explainer.views();
    ASSERT_EQ(views.size(), 4u);
    for (uint32_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(views[i].interval_m.x, mixed_split(near, far, i, 4, lambda), 1e-4f * far) << mixed << ", split " << i;
      EXPECT_NEAR(views[i].interval_m.y, mixed_split(near, far, i + 1, 4, lambda), 1e-4f * far) << mixed << ", split " << i;
    }
  }
}

TEST(LightViews, FacesOfACubeOverlapByTheBorder) {
  View& view = stage(LightKind::point);
  const Light& lamp = view.scene().lights[0];
  const auto views = projection("cube", {{"size", 256}, {"border", 10}})->views(view.frame(), lamp);
  ASSERT_EQ(views.size(), 6u);
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    for (int side = 0; side < 4; ++side) {
      vec3 along(0.0f);
      along[axis] = face % 2 ? -1.0f : 1.0f;
      along[(axis + 1 + side / 2) % 3] = side % 2 ? -1.0f : 1.0f;  // the line where two faces meet
      EXPECT_NEAR(texels_to_edge(views[static_cast<size_t>(face)], lamp.position + 2.0f * along), 10.0f, 0.01f) << face;
    }
  }
}

TEST(LightViews, HalvesOfAParaboloidOverlapByTheBorder) {
  View& view = stage(LightKind::point);
  const Light& lamp = view.scene().lights[0];
  for (const double border : {0.0, 10.0}) {
    const auto views = projection("dual_paraboloid", {{"size", 256}, {"border", border}})->views(view.frame(), lamp);
    ASSERT_EQ(views.size(), 2u);
    const mat4 rows = glm::transpose(views[0].raster.clip_from_world);
    for (const ShadowView& half : views) {
      for (const vec3& across : {vec3(rows[0]), -vec3(rows[0]), vec3(rows[1]), -vec3(rows[1])}) {
        EXPECT_NEAR(texels_to_edge(half, lamp.position + 3.0f * across), border, 0.01);
      }
    }
  }
}

// A room around a lamp, seen in six directions: what each point of the walls is looked up in holds the point, and looks at it.
TEST(LightViews, EveryWallAroundALampHasItsLayer) {
  const vec3 lamp(0.3f, 1.4f, -0.2f);
  Scene room = test::scene_with({test::box_part({-2, 0, -2}, {2, 3, 2})});
  room.materials[0].double_sided = true;
  room.cameras.push_back(look_at("any", {0, 1.5f, 0}, {1, 1.5f, 0}, 90.0));
  room.lights.push_back(test::make_light(LightKind::point, {0, -1, 0}, lamp, 0.0f));
  View view(std::move(room), {16, 16});
  for (const std::string id : {"cube", "dual_paraboloid"}) {
    const auto& spec = find_technique(id + "/hard");
    const auto technique = spec.make(view.context(), test::settings_of(spec, {id + ".size=64"}));
    Explainer explainer(test::device());
    std::set<uint32_t> layers;
    for (int side = 0; side < 6; ++side) {
      vec3 toward(0.01f, 0.02f, 0.03f);
      toward[side / 2] = side % 2 ? -1.0f : 1.0f;
      view.frame().set_camera(look_at("side", lamp, lamp + toward, 80.0));
      for (const uvec2 pixel : {uvec2(3, 4), uvec2(9, 7), uvec2(12, 13)}) {
        test::run_passes([&](Recorder& recorder) {
          view.frame().record_surface(recorder);
          technique->record(recorder, view.frame(), 0);
          explainer.record_pick(recorder, view.frame(), 0, *technique, pixel);
          explainer.record_views(recorder, *technique);
        });
        const PickRecord record = explainer.picked();
        ASSERT_TRUE(record.seen && record.count == 1);
        const uint32_t layer = record.layers[0].layer;
        const ShadowView shadow = explainer.views().at(layer);
        const vec3 along = glm::transpose(mat3(shadow.raster.clip_from_world))[2];
        EXPECT_GE(texels_to_edge(shadow, record.position_ws), 0.0f) << id << ", side " << side << ", layer " << layer;
        EXPECT_GT(glm::dot(along, record.position_ws - lamp), 0.0f) << id << ", side " << side << ", layer " << layer;
        layers.insert(layer);
      }
    }
    EXPECT_EQ(layers.size(), explainer.views().size()) << id;
  }
}

// Wimmer et al. 2004: the size of a texel over that of a pixel is the same at both ends of the view.
TEST(Warp, PerspectiveErrorIsTheSameAtBothEnds) {
  const CameraData camera = camera_data(look_at("level", {0, 2, 50}, {0, 2, 0}, 60.0), {160, 90}, 1);
  Box box;
  box.min = vec3(-50, 0, -50), box.max = vec3(50, 10, 45);
  const WarpFit fit = warp_fit(camera, test::make_sun({0, -1, 0}), box, box, 0.1f, 100.0f);
  const ShadowView view = warped_view(fit, light_space_perspective_distance(fit, 0.0f, 1.0f), 1024, 0.0f);
  // Metres along the view.
  const auto texel_at = [&](float depth) {
    const auto place = [&](float z) {
      const vec4 clip = light_clip(view.raster, camera.eye_ws + z * camera.forward_ws);
      return clip.y / clip.w;
    };
    const float step = 1e-3f * depth;
    return 2.0f * step / (place(depth + step) - place(depth - step)) * 2.0f / view.size;
  };
  ASSERT_GT(fit.farthest_m, 10.0f * fit.nearest_m);
  EXPECT_NEAR(texel_at(fit.farthest_m) / fit.farthest_m * fit.nearest_m / texel_at(fit.nearest_m), 1.0f, 0.02f);
  EXPECT_NEAR(view.texel_along_m, texel_at(fit.nearest_m), 0.01f * view.texel_along_m) << "w is 1 at the near side";
}

// A box of casters anywhere around a lamp: on the axis of the view that looks at it none lies before the near plane.
TEST(LightViews, NoCasterLiesBeforeTheNearPlaneOfALamp) {
  const vec3 lamp(1, 2, 3);
  for (int i = 0; i < 200; ++i) {
    const float angle = 0.7f * static_cast<float>(i), height = std::sin(1.3f * static_cast<float>(i));
    const vec3 direction = glm::normalize(vec3(std::cos(angle), height, std::sin(angle)));
    const float distance = 1.0f + 0.05f * static_cast<float>(i), half = 0.02f * distance;
    Box casters, scene;
    casters.min = lamp + distance * direction - half, casters.max = lamp + distance * direction + half;
    scene.min = lamp - 30.0f, scene.max = lamp + 30.0f;
    const auto [near, far] = distance_range(lamp, 0.0f, casters, scene);
    for (int corner = 0; corner < 8; ++corner) {
      const vec3 offset = casters.corner(corner) - lamp;
      const float along_axis = std::max({std::abs(offset.x), std::abs(offset.y), std::abs(offset.z)});
      EXPECT_LE(near, along_axis) << i;
    }
    EXPECT_GT(near, 0.3f * distance) << "depth is lost for nothing";
    EXPECT_GE(far, std::sqrt(3.0f) * 30.0f);
  }
}

// One ray toward the middle of a lamp sees it as a point, whatever its size.
TEST(DirectRays, TheSizeOfALampIsNotSeen) {
  if (!test::device().info().ray_tracing) GTEST_SKIP() << "the device traces no rays";
  const auto& spec = find_technique("ray_traced");
  const auto mask_of = [&](float radius) {
    Scene scene = test::box_on_floor(LightKind::point);
    scene.lights[0].radius = radius;
    View view(std::move(scene), {64, 48});
    return test::run_technique(view, spec, spec.default_settings()).mask;
  };
  const auto point = mask_of(0.0f);
  EXPECT_LT(*std::min_element(point.begin(), point.end()), 0.5f);
  EXPECT_EQ(mask_of(1.5f), point);
}

}  // namespace
}  // namespace gnomon
