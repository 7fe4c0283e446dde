// One scene, seen by one camera under chosen lights, ready to be drawn: what render, compare and bench share.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "lab/view/settings.h"
#include "reference/cpu/embree_reference.h"
#include "scene/casting.h"
#include "scene/path.h"

namespace gnomon {

// What the command line says about a picture.
struct ViewOptions {
  std::string scene;
  uvec2 size = {800, 600};
  uint32_t samples = 1;
  bool fewer_samples = false;  // where the device does not offer `samples`: the most below that it does
  std::string camera;          // empty: the scene's first, else a framing one; a name, a number, or "x,y,z:x,y,z" (eye:target)
  // Empty: the first directional light, else all lights, else the sun of the light settings. Else "sun", "all", names, numbers,
  // lights as text (lab/view/light_text.h).
  std::vector<std::string> lights;
  std::vector<std::string>
      casts;                 // "GLOB=on" or "GLOB=off" of objects and materials (scene/casting.h); the last that fits counts
  CastSources cast_sources;  // presets that some of them are from
};

// The techniques that serve lights of that kind, by projection: "cube/..., ray_traced".
std::string techniques_for(LightKind kind);

// Settles `fewer_samples` for that device.
void settle_samples(ViewOptions& options, const DeviceInfo& device);

// Camera and lights after the scene and the settings were asked. choose_camera writes what is in force into
// `settings`.
Camera choose_camera(const Scene& scene, const ViewOptions& options, Settings& settings);
std::vector<Light> choose_lights(const Scene& scene, const ViewOptions& options, const Settings& settings);
// The scene's path of that name or number; or one of a .json file. Throws Error (usage), naming the valid ones.
CameraPath choose_camera_path(const Scene& scene, const std::string& text);
SunMotion choose_sun_path(const Scene& scene, const std::string& text);
// Writes what is in force of a light into `settings`.
void record_light(const Light& light, Settings& settings);

class Session {
 public:
  Session(Device& device, const ViewOptions& options, Settings settings);
  // Of a scene that is loaded already: what load_scene made of `options` and `settings`.
  Session(Device& device, const ViewOptions& options, Settings settings, Scene scene);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  Device& device() const { return device_; }
  const Scene& scene() const { return scene_; }
  const Camera& camera() const { return camera_; }
  Frame& frame() { return *frame_; }
  TechniqueContext& context() { return *context_; }
  const Settings& settings() const { return settings_; }
  const ViewOptions& options() const { return options_; }

  // The lights that the options name; a new session's frame has all of them, use_light leaves one.
  const std::vector<Light>& chosen_lights() const { return lights_; }
  // The place of a chosen light in the scene's list; its place among the chosen ones where the scene does not have it.
  size_t light_number(size_t index) const;
  void use_light(size_t index);

  // Between frames: nothing is built again, and techniques keep their objects. `lights` are the chosen ones, moved.
  void set_camera(const Camera& camera);
  void set_lights(std::vector<Light> lights);
  // The same scene as `options` and `settings` show it: camera, lights, samples, frame settings. Throws Error (usage), and is
  // then unchanged.
  void change(const ViewOptions& options, Settings settings);
  // Whether `change` to these makes another frame, since it has other samples, other casters, more or fewer lights, or other
  // kinds of them. Techniques of the old frame must then be gone.
  bool needs_new_frame(const ViewOptions& options, const Settings& settings) const;
  // A frame of another size (Frame::resize); techniques stay valid.
  void resize(uvec2 size);
  // The same frame from the shaders as they are now (gpu/shader.h); the scene stays. Techniques of the old one must be gone.
  void rebuild() { make_frame(lights_); }

  // Empty when `spec` can run here: on this device, under these lights. Else the reason.
  std::string unavailable(const TechniqueSpec& spec) const;
  // One technique object per light: each keeps its own map and has its own settings.
  std::vector<std::unique_ptr<Technique>> make_techniques(const TechniqueSpec& spec);
  // The same, where each light takes the first of the list that supports its kind. Throws Error (device) where none does.
  std::vector<std::unique_ptr<Technique>> make_techniques(std::span<const TechniqueSpec* const> specs);
  // What is in force for a light of the frame.
  SettingsMap settings_of(const TechniqueSpec& spec, size_t light) const;
  // Surface, masks of all lights, shading.
  void record_frame(Recorder& recorder, std::span<const std::unique_ptr<Technique>> techniques);
  // Shades with the mask as it lies in the frame. Returns the picture.
  Image8 shade();
  void draw_surface();  // only the surface buffer
  // Where a recorder gives up a frame (GivenUp), the surface buffer may hold a part of it, and that of a new frame holds
  // nothing: complete_surface then draws it.
  void frame_is_given_up() { surface_is_whole_ = false; }
  void complete_surface();

 private:
  bool other_frame(const ViewOptions& options, std::span<const Light> lights) const;
  void change_casting(const std::vector<std::string>& casts);
  void make_frame(std::span<const Light> lights);

  Device& device_;
  ViewOptions options_;
  Settings settings_;
  Scene scene_;
  Camera camera_;
  std::vector<Light> lights_;
  std::unique_ptr<GpuScene> gpu_scene_;
  std::unique_ptr<Frame> frame_;
  bool surface_is_whole_ = false;
  std::unique_ptr<TechniqueContext> context_;
};

}  // namespace gnomon
