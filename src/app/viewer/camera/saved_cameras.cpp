#include "app/viewer/camera/saved_cameras.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"

namespace gnomon::viewer {
namespace {

// The near plane of one who walks about, relative to the scene's radius, where the scene has no camera that says.
constexpr double k_walkable_near = 0.005;

bool of_lens(const std::string& key) { return key.starts_with("camera."); }

}  // namespace

void SavedCameras::store(int number, const ViewState& state) {
  GNOMON_ASSERT(number >= 1 && number <= 9);
  Saved saved{state.view.camera, {}};
  for (const auto& [key, value] : state.edits) {
    if (of_lens(key)) saved.lens[key] = value;
  }
  cameras_[number] = std::move(saved);
}

bool SavedCameras::recall(int number, ViewState& state) const {
  const auto found = cameras_.find(number);
  if (found == cameras_.end()) return false;
  choose_scene_camera(state, found->second.camera);
  state.edits.insert(found->second.lens.begin(), found->second.lens.end());
  return true;
}

std::vector<int> SavedCameras::numbers() const {
  std::vector<int> numbers;
  for (const auto& [number, camera] : cameras_) numbers.push_back(number);
  return numbers;
}

int SavedCameras::free_number() const {
  int number = 1;
  while (number < 9 && cameras_.contains(number)) ++number;
  return number;
}

void choose_scene_camera(ViewState& state, const std::string& camera) {
  state.view.camera = camera;
  std::erase_if(state.edits, [](const auto& edit) { return of_lens(edit.first); });
}

void keep_lens(ViewState& state, const Session& session) {
  if (session.camera().orthographic) return;
  const ParamBlock& lens = session.settings().block("camera");
  state.edits.try_emplace("camera.vertical_fov", lens.text("vertical_fov"));
  // That of the view of the whole scene begins just before the scene: one who walks in would see it cut open.
  const bool frames_scene = state.view.camera == "frame" || (state.view.camera.empty() && session.scene().cameras.empty());
  const double walkable_m = std::clamp(k_walkable_near * static_cast<double>(session.scene().bounds().radius()), 1e-4, 1e3);
  const bool near = !frames_scene || lens.number("near") <= walkable_m;
  state.edits.try_emplace("camera.near", near ? lens.text("near") : fmt::format("{:.3g}", walkable_m));
}

}  // namespace gnomon::viewer
