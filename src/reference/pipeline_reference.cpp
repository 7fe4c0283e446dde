// Dispatches of the reference's rays in pieces, so that no submission runs long enough to be taken for a hang.
#include "reference/pipeline_reference.h"

#include <cstring>

#include "base/interrupt.h"
#include "base/log.h"
#include "gpu/recorder.h"
#include "reference/cpu/confidence.h"
#include "scene/light_shape.h"

namespace gnomon {
namespace {

constexpr size_t k_rays_per_submission = size_t{1} << 22;

}  // namespace

PipelineReference::PipelineReference(Device& device, const AccelerationStructure& structure)
    : device_(device), structure_(structure), pipeline_(make_visibility_pipeline(device, "reference/reference_points.rgen")) {}

ReferenceResult PipelineReference::trace(const Frame& frame, const Light& light, bool area, int samples, uint32_t seed) const {
  const Buffer points = frame.make_points();
  const size_t count = frame.sample_count();
  const Buffer answers(device_, "reference answers", count * sizeof(float));
  const Buffer shape(device_, "reference light", sizeof(LightShape), BufferMemory::upload);
  const LightShape light_on_gpu = light_shape(light, area);
  std::memcpy(shape.mapped(), &light_on_gpu, sizeof light_on_gpu);
  shape.flush();

  struct Arguments {
    uint64_t frame, scene, points, answers, light;
    uint32_t first, count, samples, seed;
    vec2 extents;
  };
  const size_t rays = light_on_gpu.emitter_radius > 0.0f ? static_cast<size_t>(samples) : 1;
  const size_t piece = std::max<size_t>(k_rays_per_submission / rays, 64);
  Progress progress("reference (GPU)", count);
  for (size_t first = 0; first < count; first += piece) {
    check_interrupted();
    const size_t width = std::min(piece, count - first);
    Recorder recorder(device_, TimingMode::play, false);
    recorder.begin();
    recorder.pass("reference", PassStage::other, {{points, Use::ray_read}, {answers, Use::ray_write}}, [&](Commands& commands) {
      commands.push(Arguments{frame.data_address(), structure_.address(), points.address(), answers.address(), shape.address(),
                              static_cast<uint32_t>(first), static_cast<uint32_t>(count), static_cast<uint32_t>(samples), seed,
                              frame.scene().ray_extents()});
      commands.trace(pipeline_, {static_cast<uint32_t>(width), 1});
    });
    recorder.finish();
    progress.update(first + width);
  }

  ReferenceResult result;
  result.visibility = read_back_as<float>(device_, answers, count);
  result.receiver.resize(count);
  std::vector<float> variance(count, 0.0f);
  for (size_t i = 0; i < count; ++i) {
    float& v = result.visibility[i];
    result.receiver[i] = v >= 0.0f;
    v = std::max(v, 0.0f);
    // Points that see part of the emitter below their horizon count fewer rays than this.
    if (result.receiver[i] && light_on_gpu.emitter_radius > 0.0f) variance[i] = visibility_variance(v, samples);
  }
  result.confidence = mean_confidence(read_back_as<SurfacePoint>(device_, points, count), variance, result.receiver);
  return result;
}

}  // namespace gnomon
