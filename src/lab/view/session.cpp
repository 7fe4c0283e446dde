// Loading, upload, frames.
#include "lab/view/session.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "lab/view/lab_params.h"
#include "scene/casting.h"
#include "scene/drawable.h"
#include "scene/load.h"

namespace gnomon {

namespace {

// Legal, and seldom meant: the ground is dark, and what is seen of the shadows is the underside of things.
void warn_of_suns_below_horizon(std::span<const Light> lights) {
  for (const Light& light : lights) {
    if (light.kind == LightKind::directional && light.direction.y >= 0.0f) {
      log_warning(
          "the sun '{}' is not above the horizon: it shines from below, or along the ground; light.elevation above 0 raises it",
          light.name);
    }
  }
}

// Positions are 32-bit floats: far from the origin they lie on a grid, which no camera and no bias can mend.
void warn_of_coarse_coordinates(const Scene& scene) {
  const Box& box = scene.bounds();
  if (box.empty()) return;
  const vec3 farthest = glm::max(glm::abs(box.min), glm::abs(box.max));
  const float step_m = 1.2e-7f * std::max({farthest.x, farthest.y, farthest.z});
  if (step_m > 1e-5f * box.radius()) {
    log_warning(
        "{}: {:.3g} m across, and up to {:.3g} m from the origin, where 32-bit numbers are {:.2g} m apart: surfaces and "
        "shadows will be coarse or "
        "lost; move the model to the origin",
        scene.file_or_name(), 2.0f * box.radius(), box.radius() + glm::length(box.centre()), step_m);
  }
}

// Rarely what is wanted, and the picture alone would not tell it from shadows that are lost.
void warn_where_nothing_casts(const Scene& scene, const GpuScene& gpu_scene) {
  if (gpu_scene.caster_triangles() > 0) return;
  log_warning(
      "{}: nothing casts a shadow, so everything is lit; --cast GLOB=on, or scene.blend_casts=opaque for blended materials, "
      "makes it cast",
      scene.name);
}

void check_lights_named(std::span<const Light> lights, const Settings& settings) {
  for (const std::string& name : settings.lights_named()) {
    const bool chosen = std::any_of(lights.begin(), lights.end(), [&](const Light& light) { return light.name == name; });
    std::vector<std::string_view> names;
    for (const Light& light : lights) names.push_back(light.name);
    if (!chosen) fail_usage("--set {}@...: no chosen light has that name; valid: {}", name, fmt::join(names, ", "));
  }
}

}  // namespace

std::string techniques_for(LightKind kind) {
  std::vector<std::string> names;
  for (const TechniqueSpec& spec : all_techniques()) {
    if (!spec.supports(kind)) continue;
    const size_t slash = spec.name.find('/');
    const std::string name = slash == spec.name.npos ? spec.name : spec.name.substr(0, slash) + "/...";
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

void settle_samples(ViewOptions& options, const DeviceInfo& device) {
  if (!std::exchange(options.fewer_samples, false)) return;
  uint32_t offered = 1;
  for (const int count : device.sample_counts) {
    if (static_cast<uint32_t>(count) <= options.samples) offered = std::max(offered, static_cast<uint32_t>(count));
  }
  options.samples = offered;
}

Session::Session(Device& device, const ViewOptions& options, Settings settings)
    : Session(device, options, settings, load_scene(options.scene, settings.scene_options(), settings.scene_file_options())) {}

Session::Session(Device& device, const ViewOptions& options, Settings settings, Scene scene)
    : device_(device), options_(options), settings_(std::move(settings)), scene_(std::move(scene)) {
  settle_samples(options_, device_.info());
  check_drawable(scene_);
  apply_casting(scene_, options_.casts, options_.cast_sources);
  warn_of_strays(scene_);
  warn_of_coarse_coordinates(scene_);
  settings_.complete_scene_options(options_.scene);
  camera_ = choose_camera(scene_, options_, settings_);
  lights_ = choose_lights(scene_, options_, settings_);
  warn_of_suns_below_horizon(lights_);
  check_lights_named(lights_, settings_);
  gpu_scene_ = std::make_unique<GpuScene>(device_, scene_);
  warn_where_nothing_casts(scene_, *gpu_scene_);
  record_light(lights_.front(), settings_);
  make_frame(lights_);
}

size_t Session::light_number(size_t index) const {
  const Light& light = lights_[index];
  for (size_t i = 0; i < scene_.lights.size(); ++i) {
    const Light& other = scene_.lights[i];
    if (other.name == light.name && other.kind == light.kind && other.position == light.position) return i;
  }
  return index;
}

void Session::use_light(size_t index) {
  record_light(lights_[index], settings_);
  if (lights_.size() > 1) make_frame(std::span(&lights_[index], 1));
}

void Session::set_camera(const Camera& camera) {
  camera_ = camera;
  frame_->set_camera(camera_);
}

void Session::set_lights(std::vector<Light> lights) {
  frame_->set_lights(lights);
  lights_ = std::move(lights);
}

void Session::change(const ViewOptions& options, Settings settings) {
  settings.complete_scene_options(options_.scene);
  const Camera camera = choose_camera(scene_, options, settings);
  std::vector<Light> lights = choose_lights(scene_, options, settings);
  check_lights_named(lights, settings);
  record_light(lights.front(), settings);
  const bool another_frame = other_frame(options, lights);
  if (options.casts != options_.casts) change_casting(options.casts);
  options_.camera = options.camera, options_.lights = options.lights, options_.samples = options.samples;
  settings_ = std::move(settings);
  if (another_frame) {
    camera_ = camera;
    lights_ = std::move(lights);
    make_frame(lights_);
    return;
  }
  set_lights(std::move(lights));
  frame_->expose();
  frame_->set_params(settings_.block("frame").as<frame_params::Params>());
  set_camera(camera);  // writes all of the frame's data
}

void Session::change_casting(const std::vector<std::string>& casts) {
  apply_casting(scene_, casts, options_.cast_sources);
  context_.reset(), frame_.reset();  // both know the old casters
  gpu_scene_ = std::make_unique<GpuScene>(device_, scene_);
  warn_where_nothing_casts(scene_, *gpu_scene_);
  options_.casts = casts;
}

bool Session::other_frame(const ViewOptions& options, std::span<const Light> lights) const {
  const auto same_kind = [](const Light& a, const Light& b) { return a.kind == b.kind; };
  return options.samples != options_.samples || options.casts != options_.casts ||
         !std::equal(lights.begin(), lights.end(), lights_.begin(), lights_.end(), same_kind);
}

bool Session::needs_new_frame(const ViewOptions& options, const Settings& settings) const {
  return other_frame(options, choose_lights(scene_, options, settings));
}

void Session::resize(uvec2 size) {
  frame_->resize(size);
  options_.size = size;
  frame_->set_camera(camera_);
  surface_is_whole_ = false;
}

void Session::make_frame(std::span<const Light> lights) {
  context_.reset();
  frame_ = std::make_unique<Frame>(device_, *gpu_scene_, options_.size, options_.samples, lights);
  frame_->set_params(settings_.block("frame").as<frame_params::Params>());
  frame_->set_camera(camera_);
  context_ = std::make_unique<TechniqueContext>(device_, *frame_);
  surface_is_whole_ = false;
}

std::string Session::unavailable(const TechniqueSpec& spec) const {
  for (const Light& light : frame_->lights()) {
    if (!spec.supports(light.kind))
      return fmt::format("no {} lights ('{}'); valid: {}", light_kind_name(light.kind), light.name, techniques_for(light.kind));
  }
  return {};
}

std::vector<std::unique_ptr<Technique>> Session::make_techniques(const TechniqueSpec& spec) {
  const TechniqueSpec* const one[] = {&spec};
  return make_techniques(one);
}

std::vector<std::unique_ptr<Technique>> Session::make_techniques(std::span<const TechniqueSpec* const> specs) {
  std::vector<std::unique_ptr<Technique>> techniques;
  for (size_t light = 0; light < frame_->lights().size(); ++light) {
    const LightKind kind = frame_->lights()[light].kind;
    const auto spec =
        std::find_if(specs.begin(), specs.end(), [&](const TechniqueSpec* candidate) { return candidate->supports(kind); });
    if (spec == specs.end())
      fail_device("light '{}': no technique of this run supports {} lights; valid: {}", frame_->lights()[light].name,
                  light_kind_name(kind), techniques_for(kind));
    techniques.push_back((*spec)->make(*context_, settings_of(**spec, light)));
  }
  return techniques;
}

SettingsMap Session::settings_of(const TechniqueSpec& spec, size_t light) const {
  return settings_.for_technique(spec, frame_->lights()[light].name);
}

void Session::record_frame(Recorder& recorder, std::span<const std::unique_ptr<Technique>> techniques) {
  frame_->record_surface(recorder);
  surface_is_whole_ = true;
  for (size_t light = 0; light < techniques.size(); ++light) techniques[light]->record(recorder, *frame_, light);
  frame_->record_shade(recorder);
}

void Session::draw_surface() {
  Recorder recorder(device_, TimingMode::play, false);
  recorder.begin();
  frame_->record_surface(recorder);
  recorder.finish();
  surface_is_whole_ = true;
}

void Session::complete_surface() {
  if (!surface_is_whole_) draw_surface();
}

Image8 Session::shade() {
  Recorder recorder(device_, TimingMode::play, false);
  recorder.begin();
  frame_->record_shade(recorder);
  recorder.finish();
  return frame_->read_display();
}

}  // namespace gnomon
