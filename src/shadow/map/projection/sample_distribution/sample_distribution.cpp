// Sample distribution shadow maps (Lauritzen, Salvi and Lefohn 2011): where the maps go is read from the picture itself. A
// reduction over the surface buffer finds the nearest and the farthest visible sample; logarithmic splits between them; a
// second reduction finds the light-space box of each split's samples. Everything stays on the GPU: no read-back, no frame of
// delay. Cost: two reads of the surface buffer beside a cascade's passes, and maps that cannot be kept between frames. Fails:
// maps move with every visible sample, so edges crawl when the viewer does; one far sample widens the last split.
#include <algorithm>

#include "gpu/pipeline.h"
#include "scene/light_shape.h"
#include "shadow/map/light_views.h"
#include "shadow/map/projection/sample_distribution/sample_distribution_data.glsl"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Cascades fitted to the samples that are visible, found on the GPU.\n"
    "Lauritzen, Salvi, Lefohn 2011. Splits in equal ratios between the nearest and the farthest sample; each map is the tight "
    "box of\n"
    "its split's samples that face the light. Far finer texels than cascades where walls or hills hide most of the view. Two "
    "reads of\n"
    "the surface buffer more than cascades; maps move with what is visible, so edges crawl while the viewer moves, and nothing "
    "can be\n"
    "kept between frames.";

constexpr uint32_t k_stages = 4;  // reset, depths, boxes, views
constexpr uint32_t k_samples_per_group = 256 * 8;

class SampleDistribution : public Projection {
 public:
  explicit SampleDistribution(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  uint32_t map_size() const override { return static_cast<uint32_t>(params_.size); }
  uint32_t layers() const override { return static_cast<uint32_t>(params_.count); }
  bool on_gpu() const override { return true; }

  // All of the scene; record_views replaces it.
  std::vector<ShadowView> views(const Frame& frame, const Light& light) const override {
    const LightFrame light_frame(light.direction);
    const Box scene = light_frame.bounds(frame.scene().bounds());
    const auto [near, far] =
        depth_range(light_frame.bounds(frame.scene().caster_bounds()), scene, light_start(light_frame, light));
    return std::vector<ShadowView>(layers(), orthographic_view(light_frame, scene, near, far, map_size()));
  }

  void record_views(Recorder& recorder, const Frame& frame, const Light& light, const Buffer& views) override {
    if (!state_) create(frame.device());
    *reinterpret_cast<SampleDistributionInput*>(input_.mapped()) = make_input(frame, light);
    input_.flush();
    std::vector<ResourceUse> uses = frame.surface_uses(Use::compute_read);
    uses.emplace_back(state_, Use::compute_write);
    uses.emplace_back(views, Use::compute_write);
    const uint64_t addresses[] = {frame.data_address(), input_.address(), state_.address(), views.address()};
    recorder.pass(GNOMON_ID_TEXT "/reduce", PassStage::build, uses, [&](Commands& commands) {
      for (uint32_t stage = 0; stage < k_stages; ++stage) {
        if (stage > 0) commands.compute_barrier();
        commands.bind(pipelines_[stage]);
        commands.push(addresses);
        const bool whole = stage == 1 || stage == 2;
        commands.dispatch_1d(whole ? static_cast<uint32_t>(frame.sample_count()) : 1, whole ? k_samples_per_group : 1);
      }
    });
  }

 private:
  void create(Device& device) {
    input_ = Buffer(device, GNOMON_ID_TEXT " input", sizeof(SampleDistributionInput), BufferMemory::upload);
    state_ = Buffer(device, GNOMON_ID_TEXT " state", sizeof(SampleDistributionState));
    for (uint32_t stage = 0; stage < k_stages; ++stage) {
      pipelines_[stage] =
          make_compute_pipeline(device, "shadow/map/projection/sample_distribution/sample_distribution.comp", {stage});
    }
  }

  SampleDistributionInput make_input(const Frame& frame, const Light& light) const {
    const LightFrame light_frame(light.direction);
    SampleDistributionInput input = {};
    Box scene = light_frame.bounds(frame.scene().bounds()), casters = light_frame.bounds(frame.scene().caster_bounds());
    input.start = light_start(light_frame, light);
    casters.min.z = std::max(casters.min.z, input.start);
    clip_to_beam(light_frame, light, scene);
    input.light_x_ws = light_frame.world_from_light[0];
    input.light_y_ws = light_frame.world_from_light[1];
    input.light_z_ws = light_frame.world_from_light[2];
    input.scene_min = scene.min, input.scene_max = scene.max;
    input.caster_min = casters.min, input.caster_max = casters.max;
    input.shape = light_shape(light, true);
    input.count = layers(), input.size = map_size(), input.tight = params_.tight;
    input.lambda = params_.lambda, input.border = params_.border;
    return input;
  }

  Params params_;
  Buffer input_, state_;
  Pipeline pipelines_[k_stages];
};

}  // namespace

GNOMON_REGISTER(projection, Projection) {
  return {GNOMON_ID_TEXT,
          k_manual,
          param_table_storage(),
          {LightKind::directional, LightKind::projector},
          [](const ParamBlock& params) -> std::unique_ptr<Projection> { return std::make_unique<SampleDistribution>(params); }};
}

}  // namespace gnomon
