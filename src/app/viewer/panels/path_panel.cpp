#include "app/viewer/panels/path_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/viewer/camera/saved_cameras.h"
#include "app/viewer/lights/light_list.h"
#include "app/viewer/status_file.h"
#include "base/error.h"
#include "base/file.h"
#include "lab/view/path_file.h"

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
  note_text(fmt::format("{}_path", name),
            fmt::format("{:.3f} of {:.3f} s{}", head.time_s, head.duration_s, head.playing ? ", plays" : ""));
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

std::vector<std::string> names_of(const std::vector<CameraPath>& paths) {
  std::vector<std::string> names;
  for (const CameraPath& path : paths) names.push_back(path.name);
  return names;
}

std::vector<std::string> names_of(const std::vector<SunMotion>& paths) {
  std::vector<std::string> names;
  for (const SunMotion& path : paths) names.push_back(name_of(path));
  return names;
}

auto first_sun(std::vector<ListedLight>& lights) {
  return std::find_if(lights.begin(), lights.end(),
                      [](const ListedLight& listed) { return listed.light.kind == LightKind::directional; });
}

const char* what_moves(const Recording& recording) {
  return recording.camera && recording.sun ? "camera and sun" : recording.sun ? "the sun" : "the camera";
}

Moment moment_of(const ViewState& state, const Session& session, const CameraRig& rig) {
  const vec3& eye = rig.camera().eye();
  Moment moment = {{eye, eye + 10.0f * rig.camera().forward()}, std::nullopt};
  auto lights = lights_of(state, session.chosen_lights());
  const auto sun = first_sun(lights);
  if (sun != lights.end()) moment.sun = {sun->light.direction, sun->light.colour, sun->light.intensity};
  return moment;
}

}  // namespace

std::vector<CameraPath> PathPanel::camera_paths(const Session& session) const {
  std::vector<CameraPath> paths = session.scene().camera_paths;
  for (const Recording& own : own_) {
    if (own.camera) paths.push_back(*own.camera);
  }
  return paths;
}

std::vector<SunMotion> PathPanel::sun_paths(const Session& session) const {
  std::vector<SunMotion> paths(session.scene().sun_paths.begin(), session.scene().sun_paths.end());
  for (const Recording& own : own_) {
    if (own.sun) paths.emplace_back(*own.sun);
  }
  return paths;
}

void PathPanel::move_sun(ViewState& state, const Session& session) {
  const auto paths = sun_paths(session);
  if (sun_path_ >= paths.size()) return;
  auto lights = lights_of(state, session.chosen_lights());
  const auto sun = first_sun(lights);
  if (sun == lights.end()) {
    sun_.playing = false;
    fail_usage("the sun path '{}' moves a sun, and no light is one; add a sun to the lights", name_of(paths[sun_path_]));
  }
  sun->light = light_at(paths[sun_path_], sun_.time_s, sun->light);
  set_light(state, session.chosen_lights(), static_cast<size_t>(sun - lights.begin()), *sun);
}

bool PathPanel::advance(ViewState& state, const Session& session, const CameraRig& rig, double seconds) {
  if (recorder_.records()) recorder_.add(seconds, moment_of(state, session, rig));
  if (sun_.advance(seconds) || std::exchange(sun_scrubbed_, false)) move_sun(state, session);
  if (!camera_.advance(seconds) && !std::exchange(camera_scrubbed_, false)) return false;
  const auto paths = camera_paths(session);
  if (camera_path_ >= paths.size()) return false;
  const CameraPose pose = pose_at(paths[camera_path_], camera_.time_s);
  keep_lens(state, session);
  state.view.camera = camera_text(pose.eye, pose.target);
  return true;
}

void PathPanel::show(const ViewState& state, const Session& session, const CameraRig& rig) {
  const auto cameras = camera_paths(session);
  if (!cameras.empty()) {
    ImGui::PushID("camera");
    camera_path_ = std::min(camera_path_, cameras.size() - 1);
    choose("camera path", names_of(cameras), camera_path_, camera_);
    camera_.duration_s = duration_s(cameras[camera_path_]);
    camera_scrubbed_ = show_playhead("camera", camera_);
    ImGui::PopID();
  }
  const auto suns = sun_paths(session);
  if (!suns.empty()) {
    ImGui::PushID("sun");
    sun_path_ = std::min(sun_path_, suns.size() - 1);
    choose("sun path", names_of(suns), sun_path_, sun_);
    sun_.duration_s = duration_s(suns[sun_path_]);
    sun_scrubbed_ = show_playhead("sun", sun_);
    ImGui::PopID();
  }
  if (!cameras.empty() && !suns.empty()) {
    if (ImGui::Button("play both from the start")) {
      for (Playhead* head : {&camera_, &sun_}) head->time_s = 0.0, head->play();
    }
    note_widget("play_both");
  }
  ImGui::Separator();
  record(state, session, rig);
  files();
}

void PathPanel::record(const ViewState& state, const Session& session, const CameraRig& rig) {
  if (!recorder_.records()) {
    if (ImGui::Button("record camera and sun")) recorder_.start(moment_of(state, session, rig)), camera_.playing = false;
    note_widget("record");
    return;
  }
  const bool stop = ImGui::Button(fmt::format("stop recording ({:.1f} s)###record", recorder_.time_s()).c_str());
  note_widget("stop_recording");
  if (!stop) return;
  auto recording = recorder_.stop(fmt::format("recording {}", own_.size() + 1));
  if (!recording) fail_usage("nothing was recorded: neither camera nor sun moved");
  done_ = fmt::format("recorded {}", what_moves(*recording));
  take(*std::move(recording));
}

void PathPanel::take(Recording recording) {
  // The last of its list, once that is shown again.
  if (recording.camera) camera_path_ = ~size_t{0}, camera_.time_s = 0.0, camera_.playing = false;
  if (recording.sun) sun_path_ = ~size_t{0}, sun_.time_s = 0.0, sun_.playing = false;
  own_.push_back(std::move(recording));
}

void PathPanel::files() {
  ImGui::SetNextItemWidth(0.45f * ImGui::GetContentRegionAvail().x);
  ImGui::InputText("##file", file_, sizeof file_);
  note_widget("path_file");
  ImGui::SameLine();
  if (ImGui::Button("load")) {
    Recording recording = read_recording(file_);
    done_ = fmt::format("read {}: {}", file_, what_moves(recording));
    take(std::move(recording));
  }
  note_widget("load_path");
  ImGui::SameLine();
  if (ImGui::Button("save") && !own_.empty()) {
    if (std::filesystem::exists(file_)) fail_usage("{} exists; give another name", file_);
    write_file(file_, recording_text(own_.back()));
    done_ =
        fmt::format("wrote {}: gnomon render --frames N{}{}", file_, own_.back().camera ? fmt::format(" --path {}", file_) : "",
                    own_.back().sun ? fmt::format(" --sun-path {}", file_) : "");
  }
  note_widget("save_path");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("writes the last recorded or loaded paths");
  if (!done_.empty()) ImGui::TextWrapped("%s", done_.c_str());
  note_text("paths_done", done_);
}

}  // namespace gnomon::viewer
