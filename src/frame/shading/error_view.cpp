#include "frame/shading/error_view.h"

#include <algorithm>

#include "base/error.h"

namespace gnomon {

ErrorView::ErrorView(Device& device, uint32_t samples)
    : device_(device), pipeline_(make_compute_pipeline(device, "frame/shading/error_view.comp", {samples})) {}

void ErrorView::set_reference(const Frame& frame, std::span<const Reference> lights) {
  const size_t count = frame.sample_count();
  GNOMON_ASSERT(lights.size() == frame.lights().size());
  std::vector<float> values;
  values.reserve(lights.size() * count);
  for (const Reference& light : lights) {
    GNOMON_ASSERT(light.visibility.size() == count && light.receiver.size() == count);
    for (size_t i = 0; i < count; ++i) values.push_back(light.receiver[i] ? light.visibility[i] : -1.0f);
  }
  const size_t bytes = values.size() * sizeof(float);
  if (reference_.bytes() < bytes) reference_ = Buffer(device_, "reference", bytes);
  upload(device_, reference_, std::as_bytes(std::span(values)));
}

void ErrorView::record(Recorder& recorder, const Frame& frame, size_t light) const {
  struct Arguments {
    uint64_t frame, mask, reference, display;
  };
  const Arguments arguments = {frame.data_address(), frame.mask_address(light),
                               reference_.address() + light * frame.sample_count() * sizeof(float), frame.display().address()};
  recorder.pass("error", PassStage::other,
                {{frame.mask(), Use::compute_read}, {reference_, Use::compute_read}, {frame.display(), Use::compute_write}},
                [&](Commands& commands) {
                  commands.bind(pipeline_);
                  commands.push(arguments);
                  commands.dispatch(frame.size(), {8, 8});
                });
}

}  // namespace gnomon
