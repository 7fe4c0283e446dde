// Rays against closed forms: Embree, the ray-tracing pipeline and the technique `ray_traced` on charts whose shadow is known
// exactly.
#include <cmath>
#include <set>

#include "reference/pipeline_reference.h"
#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using glm::dvec2;
using glm::dvec3;
using test::device;
using test::View;

constexpr uvec2 k_size = {128, 96};

struct Chart {
  std::string scene;
  std::map<std::string, double> options;
  std::string text() const {
    std::string result = scene;
    for (const auto& [name, value] : options) result += fmt::format(" {}={}", name, value);
    return result;
  }
};

std::vector<Chart> charts(double sun_deg) {
  std::vector<Chart> list;
  for (const char* scene : {"chart/sphere", "chart/slab", "chart/fence"}) {
    for (const double elevation : {20.0, 50.0, 85.0}) list.push_back({scene, {{"elevation", elevation}, {"sun_deg", sun_deg}}});
  }
  return list;
}

// The floor point under a place in the picture (pixels), from the scene's camera; false above the horizon.
bool floor_under(const Camera& camera, const dvec2& pixel, dvec3& point) {
  const glm::dmat4 pose(camera.world_from_view);
  const double slope = std::tan(0.5 * double(camera.vertical_fov)), aspect = double(k_size.x) / k_size.y;
  const dvec2 ndc(pixel.x / k_size.x * 2.0 - 1.0, 1.0 - pixel.y / k_size.y * 2.0);
  const dvec3 direction = dvec3(pose[0]) * (ndc.x * aspect * slope) + dvec3(pose[1]) * (ndc.y * slope) - dvec3(pose[2]);
  const dvec3 eye(pose[3]);
  if (direction.y >= 0.0) return false;
  point = eye - direction * (eye.y / direction.y);
  point.y = 0.0;
  return true;
}

// Whether the closed form changes within a pixel of this one: the pixel's footprint and one more on every side.
bool near_edge(const Scene& scene, uint32_t pixel) {
  const dvec2 corner(pixel % k_size.x, pixel / k_size.x);
  std::set<double> values;
  constexpr int k_steps = 12;
  for (int y = 0; y <= k_steps; ++y) {
    for (int x = 0; x <= k_steps; ++x) {
      dvec3 point;
      if (!floor_under(scene.cameras[0], corner + dvec2(-1.0) + 3.0 * dvec2(x, y) / double(k_steps), point)) return true;
      const auto value = scene.closed_form(point, scene.lights[0]);
      values.insert(value ? *value : -1.0);
    }
  }
  return values.size() > 1;
}

struct Disagreement {
  size_t compared = 0, lit = 0, near = 0, elsewhere = 0;
  bool operator==(const Disagreement&) const = default;
};

Disagreement compare_hard(View& view, const std::vector<SurfacePoint>& points, const std::vector<float>& visibility) {
  Disagreement result;
  for (size_t i = 0; i < points.size(); ++i) {
    if (points[i].object != 0) continue;  // the floor
    const auto exact = view.scene().closed_form(dvec3(points[i].position_ws), view.scene().lights[0]);
    if (!exact) continue;
    ++result.compared;
    result.lit += *exact == 1.0;
    if (double(visibility[i]) == *exact) continue;
    ++(near_edge(view.scene(), points[i].pixel) ? result.near : result.elsewhere);
  }
  return result;
}

void expect_exact(const Disagreement& d, const std::string& what) {
  EXPECT_GT(d.compared, size_t{k_size.x} * k_size.y / 4) << what;
  EXPECT_GT(d.lit, d.compared / 20) << what << ": a chart without light proves nothing";
  EXPECT_LT(d.lit, d.compared) << what << ": a chart without shadow proves nothing";
  EXPECT_EQ(d.elsewhere, 0u) << what << ": samples away from the shadow's edge";
  EXPECT_LE(static_cast<double>(d.near), 2e-4 * static_cast<double>(d.compared)) << what << ": samples on the shadow's edge";
}

TEST(Reference, HardShadowsEqualTheClosedForm) {
  for (const Chart& chart : charts(0.0)) {
    View view(load_scene(chart.scene, chart.options), k_size);
    view.draw();
    const auto points = view.frame().read_points();
    const EmbreeReference embree(view.scene());
    const PipelineReference pipeline(device(), view.context().acceleration_structure());
    const Light& sun = view.scene().lights[0];
    const auto on_cpu = embree.trace(points, view.frame().camera().eye_ws, sun, false, 1, 1);
    const auto on_gpu = pipeline.trace(view.frame(), sun, false, 1, 1);
    const auto& spec = find_technique("ray_traced");
    const auto technique = test::run_technique(view, spec, spec.default_settings()).mask;

    const Disagreement a = compare_hard(view, points, on_cpu.visibility), b = compare_hard(view, points, on_gpu.visibility),
                       c = compare_hard(view, points, technique);
    fmt::print("{}: {} samples, {} lit; disagree on an edge: embree {}, pipeline {}, ray_traced {}\n", chart.text(), a.compared,
               a.lit, a.near, b.near, c.near);
    expect_exact(a, chart.text() + ", embree");
    expect_exact(b, chart.text() + ", pipeline");
    expect_exact(c, chart.text() + ", ray_traced");
    EXPECT_EQ(on_gpu.receiver, on_cpu.receiver) << chart.text();
  }
}

TEST(Reference, TheEdgeTestCanFail) {
  // A mask that is wrong everywhere is mostly wrong away from edges.
  View view(load_scene("chart/slab", {}), k_size);
  view.draw();
  const auto points = view.frame().read_points();
  const Disagreement d = compare_hard(view, points, std::vector<float>(points.size(), 0.5f));
  EXPECT_EQ(d.near + d.elsewhere, d.compared);
  EXPECT_GT(d.elsewhere, d.compared * 3 / 4);
}

// |found - exact| that n points of the scrambled sequence may show: five standard errors of as many independent ones, and two
// samples where the fraction is so small that there is no spread.
double sampling_bound(double exact, int samples) { return 5.0 * std::sqrt(exact * (1.0 - exact) / samples) + 2.0 / samples; }

struct AreaError {
  double worst = 0.0, mean = 0.0;
  size_t beyond = 0, compared = 0, penumbra = 0;
};

AreaError compare_area(View& view, const std::vector<SurfacePoint>& points, const ReferenceResult& found, int samples) {
  AreaError error;
  for (size_t i = 0; i < points.size(); ++i) {
    if (points[i].object != 0 || !found.receiver[i]) continue;
    const auto exact = view.scene().closed_form(dvec3(points[i].position_ws), view.scene().lights[0]);
    if (!exact) continue;
    const double difference = double(found.visibility[i]) - *exact;
    ++error.compared;
    error.penumbra += *exact > 0.0 && *exact < 1.0;
    error.mean += difference;
    error.worst = std::max(error.worst, std::abs(difference));
    error.beyond += std::abs(difference) > sampling_bound(*exact, samples);
  }
  error.mean /= static_cast<double>(std::max<size_t>(error.compared, 1));
  return error;
}

TEST(Reference, SoftShadowsEqualTheClosedFormWithinTheirConfidence) {
  constexpr int k_samples = 64;
  for (const Chart& chart : charts(2.0)) {
    if (chart.options.at("elevation") == 85.0) continue;  // penumbrae of a few pixels: nothing new
    View view(load_scene(chart.scene, chart.options), k_size);
    view.draw();
    const auto points = view.frame().read_points();
    const EmbreeReference embree(view.scene());
    const Light& sun = view.scene().lights[0];
    const auto on_cpu = embree.trace(points, view.frame().camera().eye_ws, sun, true, k_samples, 1);
    const AreaError error = compare_area(view, points, on_cpu, k_samples);
    fmt::print("{}: {} samples, {} in penumbra; largest difference {:.4f}, mean {:+.6f}, confidence {:.6f}\n", chart.text(),
               error.compared, error.penumbra, error.worst, error.mean, on_cpu.confidence);
    EXPECT_GT(error.penumbra, 100u) << chart.text();
    EXPECT_EQ(error.beyond, 0u) << chart.text();
    EXPECT_LE(std::abs(error.mean), on_cpu.confidence) << chart.text();
  }
}

TEST(Reference, PipelineTracesTheSameSoftShadows) {
  constexpr int k_samples = 16;
  View view(load_scene("chart/slab", {{"sun_deg", 2.0}}), {64, 48});
  view.draw();
  const auto points = view.frame().read_points();
  const Light& sun = view.scene().lights[0];
  const auto on_cpu = EmbreeReference(view.scene()).trace(points, view.frame().camera().eye_ws, sun, true, k_samples, 1);
  const auto on_gpu =
      PipelineReference(device(), view.context().acceleration_structure()).trace(view.frame(), sun, true, k_samples, 1);
  size_t different = 0;
  for (size_t i = 0; i < points.size(); ++i)
    different += std::abs(on_cpu.visibility[i] - on_gpu.visibility[i]) > 0.5f / k_samples;
  fmt::print("chart/slab, disc sun, {} rays each: {} of {} samples differ\n", k_samples, different, points.size());
  // The same rays from the same points: only those that graze the edge may answer differently.
  EXPECT_LE(different, points.size() / 200);
}

TEST(Reference, AnotherSeedGivesAnotherSampleOfTheSameMean) {
  View view(load_scene("chart/slab", {{"sun_deg", 3.0}}), {64, 48});
  view.draw();
  const auto points = view.frame().read_points();
  const EmbreeReference embree(view.scene());
  const Light& sun = view.scene().lights[0];
  const auto a = embree.trace(points, view.frame().camera().eye_ws, sun, true, 16, 1),
             b = embree.trace(points, view.frame().camera().eye_ws, sun, true, 16, 2);
  EXPECT_NE(a.visibility, b.visibility);
  double difference = 0.0, receivers = 0.0;
  for (size_t i = 0; i < points.size(); ++i)
    difference += double(a.visibility[i] - b.visibility[i]), receivers += a.receiver[i];
  EXPECT_LE(std::abs(difference / receivers), a.confidence + b.confidence);
}

}  // namespace
}  // namespace gnomon
