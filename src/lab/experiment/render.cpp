// One picture of one technique, or a sequence.
#include "lab/experiment/render.h"

#include <algorithm>

#include "base/error.h"
#include "base/file.h"
#include "base/log.h"
#include "lab/experiment/reference_set.h"
#include "measure/visibility_error.h"
#include "scene/path.h"

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

void draw(Session& session, std::span<const std::unique_ptr<Technique>> techniques) {
  Recorder recorder(session.device(), TimingMode::play, false);
  recorder.begin();
  session.record_frame(recorder, techniques);
  recorder.finish();
}

// The picture that lies in the session's frame.
void write_picture(Session& session, Picture picture, Truth against, const std::filesystem::path& output) {
  Frame& frame = session.frame();
  const bool exr = output.extension() == ".exr";
  if (picture == Picture::shaded) {
    exr ? write_exr(output, frame.read_linear()) : write_png(output, frame.read_display());
    return;
  }
  // Of a mask the reference only says which samples receive light.
  if (picture == Picture::mask) against = Truth::hard;
  const ReferenceSet references = make_references(session, against);
  const LightReference& reference = references.lights.front();
  const ReferenceResult& truth = reference.find(against) ? *reference.find(against) : reference.hard;
  const std::vector<float> mask = picture == Picture::reference ? truth.visibility : frame.read_mask(0);
  const int samples = static_cast<int>(frame.samples());
  if (exr) {
    write_exr(output, visibility_image(mask, frame.size(), frame.samples()));
  } else if (picture == Picture::error) {
    write_png(output, signed_error_map(mask, truth.visibility, truth.receiver, samples, frame.read_display()));
  } else {
    write_png(output,
              mask_picture(mask, truth.receiver, static_cast<int>(frame.size().x), static_cast<int>(frame.size().y), samples));
  }
}

// Moves camera and sun of a session along the paths that the options name.
class Motion {
 public:
  Motion(const Session& session, const RenderOptions& options)
      : lens_(session.camera()), lights_(session.chosen_lights()), frames_(options.frames), seconds_(options.seconds) {
    const std::string name = options.path.empty() && options.sun_path.empty() ? "walk" : options.path;
    if (!name.empty()) {
      if (!options.view.camera.empty()) fail_usage("--camera and a camera path both place the camera; valid: one of them");
      camera_path_ = choose_camera_path(session.scene(), name);
      check_seconds(camera_path_->name, duration_s(*camera_path_));
    }
    if (options.sun_path.empty()) return;
    sun_path_ = choose_sun_path(session.scene(), options.sun_path);
    check_seconds(name_of(*sun_path_), duration_s(*sun_path_));
    sun_ = static_cast<size_t>(
        std::find_if(lights_.begin(), lights_.end(), [](const Light& l) { return l.kind == LightKind::directional; }) -
        lights_.begin());
    if (sun_ == lights_.size())
      fail_usage("--sun-path {}: no chosen light is directional; valid: with --light sun", options.sun_path);
    for (const char* key : {"light.azimuth", "light.elevation", "light.intensity"}) {
      if (session.settings().was_set(key)) fail_usage("--set {}=...: the sun path decides it", key);
    }
  }

  void apply(Session& session, uint32_t frame) {
    const double part = frames_ > 1 ? static_cast<double>(frame) / (frames_ - 1) : 0.0;
    if (camera_path_) session.set_camera(camera_at(*camera_path_, time_of(part, duration_s(*camera_path_)), lens_));
    if (sun_path_) {
      lights_[sun_] = light_at(*sun_path_, time_of(part, duration_s(*sun_path_)), lights_[sun_]);
      session.set_lights(lights_);
      session.set_camera(session.camera());  // the frame's data again
    }
  }

 private:
  double time_of(double part, double duration) const { return part * (seconds_ > 0.0 ? seconds_ : duration); }

  void check_seconds(const std::string& name, double duration) const {
    if (seconds_ > duration) fail_usage("--seconds {}: the path '{}' lasts {} s; valid: up to that", seconds_, name, duration);
  }

  Camera lens_;
  std::vector<Light> lights_;
  uint32_t frames_;
  double seconds_;
  std::optional<CameraPath> camera_path_;
  std::optional<SunMotion> sun_path_;
  size_t sun_ = 0;
};

std::filesystem::path numbered(const std::filesystem::path& output, uint32_t frame, uint32_t frames) {
  const size_t digits = std::max<size_t>(4, std::to_string(frames - 1).size());
  std::filesystem::path path = output;
  return path.replace_filename(fmt::format("{}_{:0{}}{}", output.stem().string(), frame, digits, output.extension().string()));
}

}  // namespace

void render(Device& device, const RenderOptions& options, const Settings& settings) {
  std::vector<const TechniqueSpec*> specs;
  for (const std::string& name : options.techniques) specs.push_back(&find_technique(name));
  settings.check_used(specs);
  const std::string extension = options.output.extension().string();
  if (extension != ".png" && extension != ".exr")
    fail_usage("-o {}: valid: a path that ends in .png or .exr", options.output.string());
  if (options.picture == Picture::error && extension == ".exr") fail_usage("--show error: valid: a path that ends in .png");
  const bool moves = !options.path.empty() || !options.sun_path.empty() || options.seconds != 0.0;
  if (options.frames == 0 && moves) fail_usage("--path, --sun-path and --seconds are for sequences; valid: with --frames N");
  check_can_write(options.output);
  Session session(device, options.view, settings);
  if (options.picture != Picture::shaded && session.chosen_lights().size() > 1) {
    fail_usage("--show mask, error and reference show one light; {} are chosen with --light", session.chosen_lights().size());
  }
  if (options.frames == 0) {
    draw(session, session.make_techniques(specs));
    write_picture(session, options.picture, options.against, options.output);
    return;
  }
  Motion motion(session, options);
  const auto techniques = session.make_techniques(specs);
  Progress progress("frames", options.frames);
  for (uint32_t frame = 0; frame < options.frames; ++frame) {
    motion.apply(session, frame);
    draw(session, techniques);
    write_picture(session, options.picture, options.against, numbered(options.output, frame, options.frames));
    progress.update(frame + 1);
  }
}

}  // namespace gnomon
