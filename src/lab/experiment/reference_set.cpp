// Who traces, and the check of what was traced against.
#include "lab/experiment/reference_set.h"

#include "base/error.h"
#include "base/log.h"
#include "frame/casters/caster_draws.h"
#include "lab/view/lab_params.h"
#include "reference/pipeline_reference.h"

namespace gnomon {
namespace {

bool use_pipeline(const Session& session, const DeviceInfo& device) {
  const auto params = session.settings().block("reference").as<reference_params::Params>();
  if (params.kind == reference_params::kind_pipeline && !device.ray_tracing) {
    fail_device("reference.kind=pipeline: '{}' has no ray-tracing pipeline; valid here: embree", device.name);
  }
  if (params.kind != reference_params::kind_automatic) return params.kind == reference_params::kind_pipeline;
  // A software device traces its pipeline a hundred times slower than Embree does.
  return device.ray_tracing && !device.software;
}

// A view along -Y that holds every caster: nothing is culled, so every triangle is assembled.
mat4 view_of_everything(const Box& box) {
  const vec3 extent = glm::max(box.extent(), vec3(1e-3f)) * 1.01f, centre = box.centre();
  mat4 clip_from_world(0.0f);
  clip_from_world[0][0] = 2.0f / extent.x;
  clip_from_world[2][1] = 2.0f / extent.z;
  clip_from_world[1][2] = -1.0f / extent.y;
  clip_from_world[3] = vec4(-2.0f * centre.x / extent.x, -2.0f * centre.z / extent.z, 0.5f + centre.y / extent.y, 1.0f);
  return clip_from_world;
}

void check_triangles(size_t in_structure, size_t rasterised, const std::string& kind) {
  if (in_structure == rasterised) return;
  fail("the {} reference holds {} triangles, but {} are drawn as casters: it is not to be believed", kind, in_structure,
       rasterised);
}

// Draws the surface once for each place, with a frame of its own: that of the session stays as it is. `trace` as in
// make_references.
template <class Trace>
void average_pixels(Session& session, std::span<const SurfacePoint> points, std::span<const vec2> places, bool area,
                    ReferenceSet& set, uint32_t seed, const Trace& trace) {
  const Frame& frame = session.frame();
  const auto surface = frame.read_surface(points);
  std::vector<PixelAverage> averages;
  for (const LightReference& reference : set.lights)
    averages.emplace_back(std::vector(points.begin(), points.end()), surface, reference.hard.receiver, frame.samples());

  Frame between(session.device(), frame.scene(), frame.size(), 1, frame.lights());
  Recorder recorder(session.device(), TimingMode::play, false);
  for (size_t i = 0; i < places.size(); ++i) {
    between.set_camera(session.camera(), places[i]);
    recorder.frame([&] { between.record_surface(recorder); });
    const auto points_between = between.read_points();
    const auto surface_between = between.read_surface(points_between);
    for (size_t light = 0; light < averages.size(); ++light) {
      const bool sized = area && frame.lights()[light].has_size();
      const int rays = sized ? set.rays_per_pixel_sample : 1;
      // Another seed for each place: their rays are no copies of each other.
      const ReferenceResult answer =
          trace(between, points_between, frame.lights()[light], sized, rays, seed + static_cast<uint32_t>(i) * 0x9e3779b9u);
      averages[light].add(points_between, surface_between, answer, rays);
    }
  }
  for (size_t light = 0; light < averages.size(); ++light) set.lights[light].pixel = averages[light].finish();
}

}  // namespace

size_t rasterised_caster_triangles(Session& session) {
  Device& device = session.device();
  const GpuScene& scene = session.frame().scene();
  if (!device.info().pipeline_statistics) return scene.caster_triangles();
  ImageInfo info;
  info.name = "caster count";
  info.width = info.height = 16;
  info.format = VK_FORMAT_D32_SFLOAT;
  info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  const Image map(device, info);
  const Buffer view(device, "caster count view", sizeof(LightView), BufferMemory::upload);
  view.mapped_as<LightView>()[0] = {view_of_everything(scene.caster_bounds()), k_view_projective, 0.0f, 1.0f, 1};
  view.flush();
  CasterDraws draws(device, scene, "caster count", {.depth_clamp = true});
  Recorder recorder(device, TimingMode::measure, false);
  recorder.begin();
  draws.record(recorder, "caster count", {&view, 0, sizeof(LightView), 1}, CasterCulling::none, false, map);
  return recorder.finish().passes.back().triangles;
}

const char* truth_name(Truth truth) { return truth == Truth::hard ? "hard" : truth == Truth::area ? "area" : "pixel"; }

Truth truth_named(std::string_view name) {
  for (const Truth truth : k_truths) {
    if (name == truth_name(truth)) return truth;
  }
  fail_usage("--against {}: valid: pixel, area, hard", name);
}

const ReferenceResult* LightReference::find(Truth truth) const {
  if (truth == Truth::hard) return &hard;
  if (truth == Truth::area) return area ? &*area : nullptr;
  return pixel ? &pixel->result : nullptr;
}

ReferenceSet make_references(Session& session, std::optional<Truth> only) {
  const auto params = session.settings().block("reference").as<reference_params::Params>();
  const size_t rasterised = rasterised_caster_triangles(session);
  const auto seed = static_cast<uint32_t>(params.seed);
  ReferenceSet set;
  set.samples = params.samples;
  const bool wants_area = only ? *only == Truth::area : params.area;
  const bool wants_pixel = only ? *only == Truth::pixel : params.pixel;
  const std::vector<vec2> places = subpixel_places(params.pixel_samples);
  set.pixel_samples = params.pixel_samples;
  set.rays_per_pixel_sample = std::max((params.samples + params.pixel_samples - 1) / params.pixel_samples, 1);

  // trace(frame, its points, light, whether with its size, rays, seed)
  const auto trace_all = [&](const auto& trace) {
    const Frame& frame = session.frame();
    const auto points = frame.read_points();
    for (const Light& light : frame.lights()) {
      LightReference& reference = set.lights.emplace_back();
      reference.hard = trace(frame, points, light, false, 1, seed);
      if (light.has_size() && wants_area) reference.area = trace(frame, points, light, true, params.samples, seed);
    }
    if (wants_pixel) average_pixels(session, points, places, params.area, set, seed, trace);
  };
  if (use_pipeline(session, session.device().info())) {
    set.kind = "pipeline";
    const AccelerationStructure& structure = session.context().acceleration_structure();
    check_triangles(structure.triangle_count(), rasterised, set.kind);
    const PipelineReference reference(session.device(), structure);
    trace_all([&](const Frame& frame, const auto&, const Light& light, bool area, int rays, uint32_t of_rays) {
      return reference.trace(frame, light, area, rays, of_rays);
    });
  } else {
    set.kind = "embree";
    const EmbreeReference reference(session.scene());
    check_triangles(reference.triangle_count(), rasterised, set.kind);
    trace_all([&](const Frame& frame, const auto& points, const Light& light, bool area, int rays, uint32_t of_rays) {
      return reference.trace(points, frame.camera().eye_ws, light, area, rays, of_rays);
    });
  }
  return set;
}

}  // namespace gnomon
