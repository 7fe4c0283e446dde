// One ray per visible surface point toward the light's centre, through the ray-tracing pipeline.
// Cost: the acceleration structure (built once, static scene) and a ray per pixel. Fails: nothing but the emitter's size, which
// a single ray cannot see: edges are hard.
#include "frame/rays/acceleration_structure.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "One ray per visible point toward the light's centre.\n"
    "Exact for a light without size, on any geometry, alpha-tested casters included; edges are hard whatever the light's "
    "size.\n"
    "Needs a device with a ray-tracing pipeline. The acceleration structure of the static scene is built once and not part of\n"
    "the frame's cost.";

class RayTraced : public Technique {
 public:
  explicit RayTraced(TechniqueContext& context)
      : scene_(context.acceleration_structure()),
        pipeline_(make_visibility_pipeline(context.device(), "shadow/direct/" GNOMON_ID_TEXT "/" GNOMON_ID_TEXT ".rgen")) {}

  void set(const SettingsMap&) override {}

  void record(Recorder& recorder, const Frame& frame, size_t light) override {
    struct Arguments {
      uint64_t frame, scene, mask;
      uint32_t light;
      vec2 extents;
    };
    const Arguments arguments = {frame.data_address(), scene_.address(), frame.mask_address(light),
                                 static_cast<uint32_t>(light), frame.scene().ray_extents()};
    std::vector<ResourceUse> uses = frame.surface_uses(Use::ray_read);
    uses.emplace_back(frame.mask(), Use::ray_write);
    recorder.pass(GNOMON_ID_TEXT "/trace", PassStage::resolve, uses, [&](Commands& commands) {
      commands.push(arguments);
      commands.trace(pipeline_, frame.size());
    });
  }

 private:
  const AccelerationStructure& scene_;
  RayPipeline pipeline_;
};

}  // namespace

GNOMON_REGISTER(direct, Direct) {
  return {GNOMON_ID_TEXT,
          k_manual,
          param_table_storage(),
          {LightKind::directional, LightKind::point, LightKind::spot, LightKind::projector},
          [](TechniqueContext& context, const ParamBlock&) -> std::unique_ptr<Technique> {
            return std::make_unique<RayTraced>(context);
          }};
}

}  // namespace gnomon
