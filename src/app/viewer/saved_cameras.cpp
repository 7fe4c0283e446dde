#include "app/viewer/saved_cameras.h"

#include <fmt/format.h>

#include "base/error.h"

namespace gnomon::viewer {
namespace {

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
  for (const char* name : {"vertical_fov", "near"}) {
    state.edits.try_emplace(fmt::format("camera.{}", name), session.settings().block("camera").text(name));
  }
}

}  // namespace gnomon::viewer
