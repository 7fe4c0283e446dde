// A scene on the GPU, seen by its first camera under its lights; and a technique run on it.
#pragma once

#include "frame/rays/acceleration_structure.h"
#include "shadow/technique.h"
#include "support/device_tests.h"

namespace gnomon::test {

class View {
 public:
  explicit View(Scene scene, uvec2 size = {64, 64}, uint32_t samples = 1)
      : scene_(std::move(scene)),
        gpu_scene_(device(), scene_),
        frame_(device(), gpu_scene_, size, samples, scene_.lights),
        context_(device(), frame_) {
    frame_.set_camera(scene_.cameras.at(0));
  }
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  Scene& scene() { return scene_; }
  const GpuScene& gpu_scene() const { return gpu_scene_; }
  Frame& frame() { return frame_; }
  TechniqueContext& context() { return context_; }

  FrameResult draw() {
    return run_passes([&](Recorder& recorder) { frame_.record_surface(recorder); });
  }
  void shade() {
    run_passes([&](Recorder& recorder) { frame_.record_shade(recorder); });
  }

 private:
  Scene scene_;
  GpuScene gpu_scene_;
  Frame frame_;
  TechniqueContext context_;
};

struct TechniqueRun {
  std::vector<float> mask;  // of the first light
  FrameResult frame;
  uint64_t bytes = 0;  // that making the technique took, without what it shares
};

// Makes the technique, draws the surface and the mask.
TechniqueRun run_technique(View& view, const TechniqueSpec& spec, const SettingsMap& settings,
                           TimingMode mode = TimingMode::play);
// {"bias.constant=0.5", ...} on top of the defaults.
SettingsMap settings_of(const TechniqueSpec& spec, std::initializer_list<std::string_view> assignments = {});

// The contents of a buffer that the surface pass fills: "surface view_z", "surface share", ...
std::vector<uint32_t> read_surface_buffer(View& view, std::string_view name);
template <class T>
std::vector<T> read_surface(View& view, std::string_view name) {
  const auto words = read_surface_buffer(view, name);
  std::vector<T> values(words.size());
  static_assert(sizeof(T) == 4);
  std::memcpy(values.data(), words.data(), words.size() * 4);
  return values;
}

}  // namespace gnomon::test
