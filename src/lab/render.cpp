// One picture of one technique.
#include "lab/render.h"

#include "base/error.h"
#include "lab/reference_set.h"
#include "measure/visibility_error.h"

namespace gnomon {
namespace {

// Visibility averaged over the samples of each pixel.
ImageF visibility_image(std::span<const float> mask, uvec2 size, uint32_t samples) {
  ImageF image(static_cast<int>(size.x), static_cast<int>(size.y), 1);
  for (size_t i = 0; i < image.values.size(); ++i) {
    for (size_t s = 0; s < samples; ++s) image.values[i] += mask[i * samples + s] / static_cast<float>(samples);
  }
  return image;
}

}  // namespace

void render(Device& device, const RenderOptions& options, const Settings& settings) {
  const TechniqueSpec& spec = find_technique(options.technique);
  settings.check_used({&spec});
  const std::string extension = options.output.extension().string();
  if (extension != ".png" && extension != ".exr") fail_usage("-o {}: valid: a path that ends in .png or .exr", options.output.string());
  if (options.picture == Picture::error && extension == ".exr") fail_usage("--show error: valid: a path that ends in .png");
  Session session(device, options.view, settings);
  if (options.picture != Picture::shaded && session.chosen_lights().size() > 1) {
    fail_usage("--show mask, error and reference show one light; {} are chosen with --light", session.chosen_lights().size());
  }
  if (const std::string reason = session.unavailable(spec); !reason.empty()) fail_device("{}: {}", spec.name, reason);
  const auto techniques = session.make_techniques(spec);
  Recorder recorder(device, TimingMode::play, false);
  recorder.begin();
  session.record_frame(recorder, techniques);
  recorder.finish();

  Frame& frame = session.frame();
  const bool exr = extension == ".exr";
  if (options.picture == Picture::shaded) {
    exr ? write_exr(options.output, frame.read_linear()) : write_png(options.output, frame.read_display());
    return;
  }
  const ReferenceSet references = make_references(session);
  const ReferenceResult& truth = references.lights.front().area ? *references.lights.front().area : references.lights.front().hard;
  const std::vector<float> mask = options.picture == Picture::reference ? truth.visibility : frame.read_mask(0);
  const int samples = static_cast<int>(frame.samples());
  if (exr) {
    write_exr(options.output, visibility_image(mask, frame.size(), frame.samples()));
  } else if (options.picture == Picture::error) {
    write_png(options.output, signed_error_map(mask, truth.visibility, truth.receiver, samples, frame.read_display()));
  } else {
    write_png(options.output, mask_picture(mask, truth.receiver, static_cast<int>(frame.size().x), static_cast<int>(frame.size().y), samples));
  }
}

}  // namespace gnomon
