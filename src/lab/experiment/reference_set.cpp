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

ReferenceSet make_references(Session& session) {
  const auto params = session.settings().block("reference").as<reference_params::Params>();
  const size_t rasterised = rasterised_caster_triangles(session);
  const auto seed = static_cast<uint32_t>(params.seed);
  ReferenceSet set;
  set.samples = params.samples;

  const auto trace_all = [&](const auto& trace) {
    for (const Light& light : session.frame().lights()) {
      LightReference reference;
      reference.hard = trace(light, false);
      if (light.has_size() && params.area) reference.area = trace(light, true);
      set.lights.push_back(std::move(reference));
    }
  };
  if (use_pipeline(session, session.device().info())) {
    set.kind = "pipeline";
    const AccelerationStructure& structure = session.context().acceleration_structure();
    check_triangles(structure.triangle_count(), rasterised, set.kind);
    const PipelineReference reference(session.device(), structure);
    trace_all(
        [&](const Light& light, bool area) { return reference.trace(session.frame(), light, area, params.samples, seed); });
  } else {
    set.kind = "embree";
    const EmbreeReference reference(session.scene());
    check_triangles(reference.triangle_count(), rasterised, set.kind);
    const auto points = session.frame().read_points();
    const vec3 eye = session.frame().camera().eye_ws;
    trace_all([&](const Light& light, bool area) { return reference.trace(points, eye, light, area, params.samples, seed); });
  }
  return set;
}

}  // namespace gnomon
