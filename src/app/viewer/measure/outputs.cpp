#include "app/viewer/measure/outputs.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <iostream>

#include "app/viewer/attempt.h"
#include "app/viewer/explain/legend.h"
#include "app/viewer/panels/section.h"
#include "app/viewer/status_file.h"
#include "base/log.h"
#include "base/shell.h"
#include "gpu/shader.h"

namespace gnomon::viewer {

Outputs::Outputs(Device& device) : clip_(background_), comparison_({"--device", device.info().name}) {}

void Outputs::show(const ViewState& next, const Session& session) {
  if (begin_section("Pictures, clips, reports")) {
    if (ImGui::Button("PNG (F12)")) want_picture(".png");
    note_widget("picture_png");
    ImGui::SameLine();
    if (ImGui::Button("EXR, scene-linear")) want_picture(".exr");
    note_widget("picture_exr");
    attempt(message_, [&] {
      show_clip();
      show_comparison(next, session);
    });
  }
  end_section();
}

void Outputs::show_clip() {
  ImGui::Separator();
  if (ImGui::Button(clip_.running() ? "Stop the clip" : "Record a clip")) {
    clip_.running() ? clip_.stop() : clip_.start(clip_name_, clip_seconds_);
  }
  note_widget("clip");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(90.0f);
  ImGui::InputFloat("s (0: until stopped)", &clip_seconds_, 0.0f, 0.0f, "%.3g");
  note_widget("clip_seconds");
  clip_seconds_ = std::max(clip_seconds_, 0.0f);
  ImGui::InputText("folder##clip", clip_name_, sizeof clip_name_);
  if (clip_.count() == 0) return;
  const size_t waiting = background_.waiting();
  note_text("clip", fmt::format("{}, {} waiting", clip_.running() ? "running" : "stopped", waiting));
  ImGui::TextDisabled("%s: %u pictures, %.1f s; %zu to be written", clip_.folder().c_str(), clip_.count(), clip_.seconds(),
                      waiting);
}

void Outputs::show_comparison(const ViewState& next, const Session& session) {
  ImGui::Separator();
  if (ImGui::Button("Add to comparison") && !comparison_.add(next))
    message_ = "the comparison has this technique with these settings";
  note_widget("add_to_comparison");
  note_text("comparison", fmt::format("{} rows{}", comparison_.size(), comparison_.busy() ? ", busy" : ""));
  const auto& lights = session.chosen_lights();
  for (size_t row = 0; row < comparison_.size();) {
    ImGui::PushID(static_cast<int>(row));
    const bool goes = ImGui::SmallButton("x");
    ImGui::SameLine();
    const std::string obstacle = comparison_.obstacle(row, lights);
    obstacle.empty() ? ImGui::TextUnformatted(comparison_.label(row).c_str())
                     : ImGui::TextDisabled("%s (left out: %s)", comparison_.label(row).c_str(), obstacle.c_str());
    ImGui::PopID();
    goes && !comparison_.busy() ? comparison_.remove(row) : void(++row);
  }
  if (comparison_.busy()) return show_progress();
  if (comparison_.size() == 0) return;
  const size_t measurable = comparison_.measurable(lights);
  const std::string what = fmt::format("{} of {} in {}", measurable, comparison_.size(), next.view.scene);
  note_text("report_of", what);
  ImGui::TextWrapped("A report measures %s, with camera and lights as they are now.", what.c_str());
  ImGui::BeginDisabled(measurable == 0);
  if (ImGui::Button("Write report")) comparison_.write_report(next, lights, session.options().size, free_name(report_name_));
  note_widget("write_report");
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::SetNextItemWidth(150.0f);
  ImGui::InputText("folder##report", report_name_, sizeof report_name_);
  if (!replaced_shaders().empty())
    ImGui::TextWrapped("The report is of the shaders that were built, not of those changed since.");
  note_text("report", comparison_.report().string());
  if (!comparison_.report().empty()) ImGui::TextWrapped("%s", comparison_.report().c_str());
}

void Outputs::show_progress() {
  ImGui::ProgressBar(static_cast<float>(comparison_.done()) / static_cast<float>(comparison_.steps()));
  ImGui::TextWrapped("%s", comparison_.command().c_str());
  remark("two pictures a second meanwhile, for the sake of the times");
  if (ImGui::Button("Stop")) comparison_.stop();
}

void Outputs::take(const ViewState& state, Session& session, const PictureContent& content, Notices& notices) {
  if (!wanted_.empty()) picture(state, session, content, notices);
  if (clip_.running()) clip_.add(session.frame().read_display());
}

void Outputs::update() {
  attempt(message_, [&] { comparison_.update(); });
  if (const std::string error = background_.take_error(); !error.empty()) {
    clip_.stop();
    message_ = error;
  }
}

void Outputs::picture(const ViewState& state, Session& session, PictureContent content, Notices& notices) {
  const std::filesystem::path path = free_name("gnomon", std::exchange(wanted_, {}));
  const bool written = attempt(message_, [&] {
    path.extension() == ".exr" ? write_exr(path, session.frame().read_linear())
                               : write_png(path, session.frame().read_display());
  });
  if (!written) return;
  std::cout << path.string() << std::endl;
  log_info("{} -o {}", state.command(session.options().size), shell_quoted(path.string()));
  // Scene-linear values have nothing drawn over them.
  if (path.extension() == ".exr") content.drawn_over.clear();
  const std::string notice = picture_notice(path.string(), content);
  notices.add(notice);
  if (!content.drawn_over.empty() || content.first_side_alone) log_info("{}", notice);
}

}  // namespace gnomon::viewer
