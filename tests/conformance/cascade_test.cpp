// Cascades: identities with a single map, and stillness of edges while the viewer moves.
#include <cmath>

#include "frame/casters/caster_draws.h"
#include "measure/visibility_error.h"
#include "shadow/map/splits.h"
#include "shadow/registry.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::device;
using test::View;

const ProjectionInfo& projection_named(std::string_view id) {
  for (const auto& info : projections()) {
    if (info.id == id) return info;
  }
  fail("no projection {}", id);
}

ParamBlock params_of(const ProjectionInfo& info, std::initializer_list<std::pair<std::string_view, double>> values) {
  ParamBlock block(info.params);
  for (const auto& [name, value] : values) block.set_number(name, value, name);
  return block;
}

TEST(Cascades, SplitsEndWhereTheFormulaSays) {
  // C_i = lambda n (f/n)^(i/m) + (1 - lambda) (n + (f - n) i/m)
  EXPECT_FLOAT_EQ(mixed_split(1.0f, 16.0f, 1, 4, 1.0f), 2.0f);
  EXPECT_FLOAT_EQ(mixed_split(1.0f, 16.0f, 3, 4, 1.0f), 8.0f);
  EXPECT_FLOAT_EQ(mixed_split(1.0f, 17.0f, 2, 4, 0.0f), 9.0f);
  EXPECT_FLOAT_EQ(mixed_split(1.0f, 16.0f, 2, 4, 0.5f), 0.5f * 4.0f + 0.5f * 8.5f);
  EXPECT_FLOAT_EQ(mixed_split(0.5f, 80.0f, 4, 4, 0.3f), 80.0f);
  EXPECT_FLOAT_EQ(mixed_split(0.5f, 80.0f, 0, 4, 0.3f), 0.5f);
}

// One cascade around the whole view, cropped to it, is the single map of the view.
TEST(Cascades, OneTightCascadeIsTheSingleMap) {
  View& view = test::kept_view("busy directional", [] { return test::busy(LightKind::directional); }, {160, 120});
  for (const std::string_view filter : {"hard", "pcf"}) {
    const auto& one = find_technique(fmt::format("cascaded/{}", filter));
    const auto& single = find_technique(fmt::format("single/{}", filter));
    const std::string distance = fmt::format("cascaded.distance={}", view.frame().visible_range().second);
    const auto a = test::run_technique(
                       view, one,
                       test::settings_of(one, {"cascaded.count=1", "cascaded.fit=box", "cascaded.stabilise=false",
                                               "cascaded.border=0", "cascaded.adapt=false", "cascaded.size=1024", distance}))
                       .mask;
    const auto b = test::run_technique(view, single, test::settings_of(single, {"single.size=1024", "single.fit=view"})).mask;
    double difference = 0.0;
    for (size_t i = 0; i < a.size(); ++i) difference += std::abs(double(a[i]) - double(b[i]));
    // The same box but for rounding, which turns a few texels at edges over.
    EXPECT_LT(difference / double(a.size()), 5e-4) << filter;
  }
}

struct Map {
  std::vector<ShadowView> views;
  std::vector<float> depths;
};

Map draw_map(View& view, const Projection& projection) {
  Map map;
  map.views = projection.views(view.frame(), view.scene().lights[0]);
  const uint32_t layers = projection.layers(), size = projection.map_size();
  map.views.resize(layers);
  ImageInfo info;
  info.name = "map";
  info.width = info.height = size, info.layers = layers, info.array = true;
  info.format = VK_FORMAT_D32_SFLOAT;
  info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  const Image image(device(), info);
  const size_t texels = size_t{layers} * size * size;
  const Buffer light(device(), "views", layers * sizeof(ShadowView), BufferMemory::upload),
      result(device(), "depths", texels * 4);
  std::memcpy(light.mapped(), map.views.data(), layers * sizeof(ShadowView));
  light.flush();
  CasterDraws draws(device(), view.gpu_scene(), "test", {.layers = layers});
  test::run_passes([&](Recorder& recorder) {
    draws.record(recorder, "test", {&light, 0, sizeof(ShadowView), layers}, CasterCulling::clusters, false, image);
    recorder.pass("copy", PassStage::other, {{image, Use::copy_read}, {result, Use::copy_write}}, [&](Commands& commands) {
      VkBufferImageCopy region = {};
      region.imageSubresource = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 0, layers};
      region.imageExtent = {size, size, 1};
      vkCmdCopyImageToBuffer(commands.handle(), image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, result.handle(), 1,
                             &region);
    });
  });
  map.depths = read_back_as<float>(device(), result, texels);
  return map;
}

// The hard answer of one layer for a point of the world: 0, 1, or -1 where the layer does not hold it.
int hard_answer(const Map& map, uint32_t layer, const vec3& p) {
  const ShadowView& view = map.views[layer];
  const vec4 clip = view.raster.clip_from_world * vec4(p, 1.0f);
  const int size = static_cast<int>(view.size);
  const vec2 texel = (vec2(clip) * 0.5f + 0.5f) * view.size;
  const int x = static_cast<int>(std::floor(texel.x)), y = static_cast<int>(std::floor(texel.y));
  // On the line between two texels rounding decides: such a point says nothing.
  if (std::abs(texel.x - std::round(texel.x)) < 1e-3f || std::abs(texel.y - std::round(texel.y)) < 1e-3f) return -1;
  if (x < 0 || y < 0 || x >= size || y >= size) return -1;
  const float bias = 0.5f * view.texel_m / view.depth_range_m;
  return map.depths[(size_t{layer} * size_t(size) + size_t(y)) * size_t(size) + static_cast<size_t>(x)] >= clip.z - bias ? 1
                                                                                                                         : 0;
}

struct Flips {
  size_t flips = 0, answers = 0;
};

// Points of the world, looked up in the maps of a viewer who walks and turns: how often an answer changes from frame to frame
// while the layer that gives it stays as large.
Flips flips_along_a_walk(bool stabilise) {
  View& view = test::kept_view("busy directional", [] { return test::busy(LightKind::directional); }, {160, 120});
  view.draw();
  std::vector<vec3> points;
  for (const SurfacePoint& point : view.frame().read_points()) {
    if (point.object != k_no_object && points.size() < 20000) points.push_back(point.position_ws);
  }
  const auto& info = projection_named("cascaded");
  const auto projection = info.make(params_of(info, {{"size", 512}, {"stabilise", stabilise}, {"adapt", 0}, {"nested", 0}}));
  const Camera start = view.scene().cameras[0];
  Flips result;
  Map last;
  for (int frame = 0; frame < 6; ++frame) {
    Camera camera = start;
    const float t = static_cast<float>(frame);
    camera.world_from_view = glm::translate(mat4(1.0f), vec3(0.137f * t, 0.011f * t, -0.093f * t)) * start.world_from_view *
                             glm::rotate(mat4(1.0f), 0.013f * t, vec3(0, 1, 0));
    view.frame().set_camera(camera);
    Map map = draw_map(view, *projection);
    for (uint32_t layer = 0; frame > 0 && layer < projection->layers(); ++layer) {
      if (stabilise) {
        EXPECT_EQ(map.views[layer].texel_m, last.views[layer].texel_m)
            << "layer " << layer << ": the size of a texel depends on where the viewer stands";
      }
      for (const vec3& p : points) {
        const int before = hard_answer(last, layer, p), after = hard_answer(map, layer, p);
        if (before < 0 || after < 0) continue;
        ++result.answers;
        result.flips += before != after;
      }
    }
    last = std::move(map);
  }
  view.frame().set_camera(start);
  return result;
}

TEST(Cascades, TexelSnappingKeepsAnswersWhileTheViewerMoves) {
  const Flips still = flips_along_a_walk(true), crawling = flips_along_a_walk(false);
  fmt::print("answers that change from frame to frame: {} of {} with stabilise, {} of {} without\n", still.flips, still.answers,
             crawling.flips, crawling.answers);
  ASSERT_GT(still.answers, 100000u);
  // Vertices of casters are rounded to a 256th of a texel: where that falls on the line, a texel turns over once in many
  // frames.
  EXPECT_LE(still.flips * 20000, still.answers);
  EXPECT_GT(crawling.flips, still.answers / 1000);
}

struct Reach {
  uint32_t cascades;
  float distance;
};

Reach reach_of(View& view, double adapt) {
  const auto& info = projection_named("cascaded");
  const auto views = info.make(params_of(info, {{"adapt", adapt}}))->views(view.frame(), view.scene().lights[0]);
  return {static_cast<uint32_t>(views.size()), views.back().interval_m.y};
}

// Boxes on a wide floor that casts nothing: the maps end with the shadows that can be seen, and lose none.
TEST(Cascades, MapsReachAsFarAsShadowsDo) {
  Scene scene = test::scene_with(
      {test::floor_part(500.0f), test::box_part({-2, 0, -20}, {2, 6, -16}), test::box_part({30, 0, 40}, {34, 40, 44})});
  scene.objects[0].casts = false;
  const std::pair<const char*, Camera> cameras[] = {{"level", look_at("level", {0, 3, 10}, {0, 2, -10}, 60.0)},
                                                    {"down", look_at("down", {0, 30, 30}, {0, 0, 0}, 60.0)},
                                                    {"away", look_at("away", {0, 3, -60}, {0, 2, -90}, 60.0)},
                                                    {"sky", look_at("sky", {0, 3, 10}, {0, 60, 0}, 40.0)}};
  scene.cameras = {cameras[0].second};
  // The second box stands behind the viewer and casts into the view under the first sun. The third sun is low before the
  // viewer.
  const vec3 suns[] = {{-0.4f, -0.5f, -1}, {0.3f, -1, 0.2f}, {0.1f, -0.2f, 1}};
  for (const vec3& sun : suns) {
    scene.lights = {test::make_sun(sun)};
    View view(scene, {128, 96});
    for (const auto& [name, camera] : cameras) {
      view.frame().set_camera(camera);
      view.draw();
      const auto points = view.frame().read_points();
      const vec3 eye = view.frame().camera().eye_ws, forward = view.frame().camera().forward_ws;
      const auto truth = EmbreeReference(view.scene()).trace(points, eye, view.scene().lights[0], false, 1, 1);
      float farthest = 0.0f;
      for (size_t i = 0; i < points.size(); ++i) {
        if (!truth.receiver[i] || truth.visibility[i] > 0.0f) continue;
        farthest = std::max(farthest, glm::dot(points[i].position_ws - eye, forward));
      }
      const Reach adapted = reach_of(view, 1), whole = reach_of(view, 0);
      fmt::print("{}, sun {} {} {}: shadows to {:.1f} m; {} cascades to {:.1f} m, without adapt {} to {:.1f} m\n", name, sun.x,
                 sun.y, sun.z, farthest, adapted.cascades, adapted.distance, whole.cascades, whole.distance);
      EXPECT_GE(adapted.distance, farthest);
      EXPECT_LT(adapted.distance, 0.5f * whole.distance);
      if (test::count(truth.receiver) == 0) continue;  // the sky
      const auto& spec = find_technique("cascaded/hard");
      const double mae =
          visibility_error(test::run_technique(view, spec, spec.default_settings()).mask, truth.visibility, truth.receiver).mae;
      const auto all = test::run_technique(view, spec, test::settings_of(spec, {"cascaded.adapt=false"})).mask;
      EXPECT_LE(mae, visibility_error(all, truth.visibility, truth.receiver).mae + 1e-3) << name;
    }
  }
}

// Each face of the cube is what a spot light looking that way would see.
TEST(Cube, FacesAreSpotMaps) {
  View& view = test::kept_view("busy point", [] { return test::busy(LightKind::point); }, {160, 120});
  const auto& cube = find_technique("cube/hard");
  const auto mask = test::run_technique(view, cube, test::settings_of(cube, {"cube.size=2048"})).mask;
  const ReferenceResult& truth = test::hard_reference(view);
  const double error = visibility_error(mask, truth.visibility, truth.receiver).mae;
  EXPECT_LT(error, 0.01) << "against rays";
  Scene spot_scene = test::busy(LightKind::point);
  spot_scene.lights[0].kind = LightKind::spot;
  spot_scene.lights[0].direction = vec3(0, -1, 0);
  spot_scene.lights[0].inner_cone = spot_scene.lights[0].outer_cone = k_pi / 4.0f;
  View spot(std::move(spot_scene), {160, 120});
  const auto& single = find_technique("single/hard");
  const auto spot_mask = test::run_technique(spot, single, test::settings_of(single, {"single.size=2048"})).mask;
  const auto lit_by_spot = test::receivers(spot);
  size_t compared = 0, different = 0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (!lit_by_spot[i] || !truth.receiver[i]) continue;
    ++compared;
    different += mask[i] != spot_mask[i];
  }
  ASSERT_GT(compared, 5000u);
  EXPECT_LT(different, compared / 200) << "of " << compared;
}

}  // namespace
}  // namespace gnomon
