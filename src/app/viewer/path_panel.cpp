#include "app/viewer/path_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/viewer/light_list.h"
#include "app/viewer/saved_cameras.h"
#include "app/viewer/status_file.h"
#include "base/error.h"
#include "base/file.h"
#include "lab/path_file.h"

namespace gnomon::viewer {
namespace {

// Play, pause, scrub, loop, speed. True while it is scrubbed.
bool show_playhead(const char* name, Playhead& head) {
  if (ImGui::Button(head.playing ? "pause" : "play", {4.0f * ImGui::GetFontSize(), 0.0f})) {
    if (head.playing) {
      head.playing = false;
    } else {
      head.play();
    }
  }
  note_widget("play", name);
  note_text(fmt::format("{}_path", name), fmt::format("{:.3f} of {:.3f} s{}", head.time_s, head.duration_s, head.playing ? ", plays" : ""));
  ImGui::SameLine();
  auto time = static_cast<float>(head.time_s);
  ImGui::SetNextItemWidth(-1.0f);
  const bool scrubbed =
      ImGui::SliderFloat("##time", &time, 0.0f, static_cast<float>(head.duration_s), "%.2f s", ImGuiSliderFlags_AlwaysClamp);
  if (scrubbed) head.time_s = static_cast<double>(time);
  ImGui::SetNextItemWidth(0.4f * ImGui::GetContentRegionAvail().x);
  ImGui::SliderFloat("speed", &head.speed, 0.05f, 8.0f, "%.2f", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  ImGui::SameLine();
  ImGui::Checkbox("loop", &head.loops);
  note_widget("loop", name);
  return scrubbed;
}

template <class Paths>
void choose(const char* label, const Paths& names, size_t& chosen, Playhead& head) {
  ImGui::SetNextItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
  if (!ImGui::BeginCombo(label, names[chosen].c_str())) return;
  for (size_t i = 0; i < names.size(); ++i) {
    if (ImGui::Selectable(fmt::format("{}##{}", names[i], i).c_str(), i == chosen) && i != chosen)
      chosen = i, head.time_s = 0.0, head.playing = false;
  }
  ImGui::EndCombo();
}

CameraPose pose_of(const CameraRig& rig) {
  const vec3& eye = rig.camera().eye();
  return {eye, eye + 10.0f * rig.camera().forward()};
}

}  // namespace

const CameraPath& PathPanel::path(const Session& session) const {
  const auto& paths = session.scene().camera_paths;
  return camera_path_ < paths.size() ? paths[camera_path_] : own_[camera_path_ - paths.size()];
}

bool PathPanel::advance(ViewState& state, const Session& session, const CameraRig& rig, double seconds) {
  if (recorder_.records()) recorder_.add(seconds, pose_of(rig));
  const auto& suns = session.scene().sun_paths;
  if ((sun_.advance(seconds) || std::exchange(sun_scrubbed_, false)) && sun_path_ < suns.size()) {
    auto lights = lights_of(state, session.chosen_lights());
    const auto sun = std::find_if(lights.begin(), lights.end(),
                                  [](const ListedLight& listed) { return listed.light.kind == LightKind::directional; });
    if (sun == lights.end()) {
      sun_.playing = false;
      fail_usage("the sun path '{}' moves a sun, and no light is one; add a sun to the lights", suns[sun_path_].name);
    }
    sun->light = light_at(suns[sun_path_], sun_.time_s, sun->light);
    set_light(state, session.chosen_lights(), static_cast<size_t>(sun - lights.begin()), *sun);
  }
  if (!camera_.advance(seconds) && !std::exchange(camera_scrubbed_, false)) return false;
  if (camera_path_ >= session.scene().camera_paths.size() + own_.size()) return false;
  const CameraPose pose = pose_at(path(session), camera_.time_s);
  keep_lens(state, session);
  state.view.camera = camera_text(pose.eye, pose.target);
  return true;
}

void PathPanel::show(const Session& session, const CameraRig& rig) {
  std::vector<std::string> names;
  for (const CameraPath& path : session.scene().camera_paths) names.push_back(path.name);
  for (const CameraPath& path : own_) names.push_back(path.name);
  ImGui::PushID("camera");
  if (!names.empty()) {
    camera_path_ = std::min(camera_path_, names.size() - 1);
    choose("camera path", names, camera_path_, camera_);
    camera_.duration_s = duration_s(path(session));
    camera_scrubbed_ = show_playhead("camera", camera_);
  }
  record(rig);
  files();
  ImGui::PopID();
  if (session.scene().sun_paths.empty()) return;
  ImGui::Separator();
  ImGui::PushID("sun");
  names.clear();
  for (const SunPath& path : session.scene().sun_paths) names.push_back(path.name);
  sun_path_ = std::min(sun_path_, names.size() - 1);
  choose("sun path", names, sun_path_, sun_);
  sun_.duration_s = session.scene().sun_paths[sun_path_].duration_s;
  sun_scrubbed_ = show_playhead("sun", sun_);
  ImGui::PopID();
}

void PathPanel::record(const CameraRig& rig) {
  if (!recorder_.records()) {
    if (ImGui::Button("record a walk")) recorder_.start(pose_of(rig)), camera_.playing = false;
    note_widget("record");
    return;
  }
  const bool stop = ImGui::Button(fmt::format("stop recording ({:.1f} s)###record", recorder_.time_s()).c_str());
  note_widget("stop_recording");
  if (!stop) return;
  auto walked = recorder_.stop(fmt::format("recording {}", own_.size() + 1));
  if (!walked) fail_usage("nothing was recorded: the camera did not move");
  own_.push_back(std::move(*walked));
  camera_path_ = ~size_t{0};  // the last one, once the list is shown again
  camera_.time_s = 0.0;
}

void PathPanel::files() {
  ImGui::SetNextItemWidth(0.45f * ImGui::GetContentRegionAvail().x);
  ImGui::InputText("##file", file_, sizeof file_);
  note_widget("path_file");
  ImGui::SameLine();
  if (ImGui::Button("load")) {
    own_.push_back(read_camera_path(file_));
    camera_path_ = ~size_t{0};
    camera_.time_s = 0.0, camera_.playing = false;
    done_ = fmt::format("read {}", file_);
  }
  ImGui::SameLine();
  if (ImGui::Button("save") && !own_.empty()) {
    if (std::filesystem::exists(file_)) fail_usage("{} exists; give another name", file_);
    write_file(file_, camera_path_text(own_.back()));
    done_ = fmt::format("wrote {}: gnomon render --frames N --path {}", file_, file_);
  }
  note_widget("save_path");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("writes the last recorded or loaded path");
  if (!done_.empty()) ImGui::TextWrapped("%s", done_.c_str());
}

}  // namespace gnomon::viewer
