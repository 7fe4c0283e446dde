#include "app/viewer/viewer.h"

#include <GLFW/glfw3.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "app/viewer/attempt.h"
#include "app/viewer/panels/section.h"
#include "app/viewer/state/start_settings.h"
#include "base/interrupt.h"
#include "base/log.h"

namespace gnomon::viewer {
namespace {

// A window that is being dragged to another size asks for many; the old picture is stretched meanwhile.
constexpr std::chrono::milliseconds k_size_settles{200};
// Of the picture on a software device, before anything is measured.
constexpr float k_software_start = 0.35f;
// Of the picture at rest, at least.
constexpr float k_least_rest = 0.5f;
// The longest step of the camera: after a slow frame it does not leap.
constexpr float k_longest_step_s = 0.25f;
// Between pictures while a report is measured on the same device.
constexpr std::chrono::milliseconds k_measuring_interval(500);

uvec2 scaled(uvec2 size, float scale) {
  const vec2 exact = glm::round(vec2(size) * scale);
  return glm::clamp(uvec2(exact), uvec2(1), uvec2(16384));
}

}  // namespace

Opened::Opened(Opening& opening, Screen& screen, bool another)
    : session(opening.finish(screen.device, glm::max(screen.window.size(), uvec2(1)))), state(opening.state()) {
  if (another) state.complete_techniques(session->frame().lights());
  techniques.update(*session, state.techniques);
  warnings = opening.warnings();
}

std::optional<Opened> open_first(Screen& screen, ViewState state) {
  const InterruptScope interrupt;
  Opening opening(std::move(state));
  while (!opening.ready()) {
    check_interrupted();
    screen.window.poll(true);
    if (screen.window.closing()) return std::nullopt;
    screen.show_panels([&] { show_progress(opening.status(), opening.share()); });
  }
  return Opened(opening, screen, false);
}

Viewer::Viewer(Screen& screen, Opened opened, Workspace& workspace, const ViewerOptions& options)
    : screen_(screen),
      window_(screen.window),
      device_(screen.device),
      workspace_(workspace),
      wishes_(workspace.wishes),
      shaders_(workspace.shaders),
      outputs_(workspace.outputs),
      options_(options),
      state_(std::move(opened.state)),
      session_(std::move(opened.session)),
      techniques_(std::move(opened.techniques)),
      rays_(session_->scene()),
      interface_(screen.interface),
      panels_(start_settings(state_, session_->scene())),
      explain_(device_, interface_.render_pass(), workspace.explain, rays_),
      state_panels_(state_, workspace.scenes.of(state_.view.scene)),
      camera_(session_->camera(), session_->scene().bounds().radius()),
      timings_(device_.info().software),
      sides_(workspace.sides, state_, rays_),
      render_scale_(wishes_.target_ms, device_.info().software ? k_software_start : 1.0f),
      last_window_(screen.window.size()),
      last_frame_(std::chrono::steady_clock::now()) {
  workspace_.notices.add(warnings_notice(state_.view.scene, opened.warnings), k_long_notice_s);
  if (!session_->scene().source.empty()) workspace_.recent.add(session_->scene().source);
  window_.set_title("gnomon: " + state_.view.scene);
}

std::optional<Opened> Viewer::run() {
  const InterruptScope interrupt;
  while (!window_.closing() && !next_ && (options_.frames == 0 || workspace_.frames < options_.frames)) {
    check_interrupted();
    const uvec2 size = window_.size();
    const bool visible = size.x > 0 && size.y > 0;
    window_.poll(!visible);
    follow_drops();
    if (next_) break;
    outputs_.update();
    if (!visible) continue;
    if (outputs_.measuring()) std::this_thread::sleep_for(k_measuring_interval);
    draw();
    const bool waits = sides_.waits_for_reference() || (!options_.screenshot.empty() && !is_drawn_as_it_stays());
    if (!waits) ++workspace_.frames;
  }
  if (!next_ && !options_.screenshot.empty() && screen_.canvas.image()) write_png(options_.screenshot, screen_.canvas.read());
  return std::move(next_);
}

bool Viewer::open(const std::string& scene) {
  if (opening_) {
    message_ = fmt::format("{} is still being opened", opening_->scene_name());
    return false;
  }
  if (outputs_.measuring()) {
    message_ = "a report is being measured; opening a scene would disturb its times: stop it first";
    return false;
  }
  message_.clear();
  // The scene that is shown is read again, and keeps all that the user made of it.
  opening_.emplace(same_scene(scene, state_.view.scene) ? state_ : state_for_scene(state_, scene));
  return true;
}

void Viewer::follow_drops() {
  const auto& dropped = window_.dropped();
  if (!dropped.empty() && open(dropped.front())) workspace_.notices.add(drop_notice(dropped));
  if (!opening_ || !opening_->ready()) return;
  const std::string scene = opening_->scene_name();
  const bool again = scene == state_.view.scene;
  if (again) opening_->set_state(state_);  // the user may have gone on meanwhile
  std::string problem;
  if (attempt(problem, [&] { next_.emplace(*opening_, screen_, true); })) {
    outputs_.stop_clip();  // pictures of another scene may have another size
    if (again) workspace_.notices.add(fmt::format("{} is read again: camera, lights and settings stay", scene));
  } else {
    const bool names_it = problem.find(scene) != problem.npos;
    message_ = fmt::format("{}not {}: {}", names_it ? "" : scene + " is ", again ? "read again" : "opened", problem);
  }
  opening_.reset();
}

void Viewer::draw() {
  const auto now = std::chrono::steady_clock::now();
  const float seconds = std::chrono::duration<float>(now - last_frame_).count();
  last_frame_ = now;
  screen_.fit_canvas();

  const bool says_what_is_built = building_.has_value();
  ViewState next = building_.value_or(state_);
  interface_.begin_frame();
  handle_keys();
  explain_.handle_keys(window_);
  state_panels_.before_panels(next, camera_, *session_, window_, static_cast<double>(seconds), message_);
  move_camera(next, std::min(seconds, k_longest_step_s));
  show_interface(next);
  interface_.end_frame();
  const bool same_view = next.view.camera == state_.view.camera;
  if (const auto travelled = state_panels_.travel(state_)) next = *travelled;
  follow(next);
  // While something is to be built, the state is still the one before: no new step.
  if (!building_) state_panels_.remember(state_);
  state_panels_.follow_camera(camera_, *session_);
  explain_.set_sides(sides_.divider(), sides_.second_settings());
  choose_draws();
  if (follow_size() && pace_.last() == Pace::Draws::nothing) pace_.draw_again();
  shaders_.update([&] { rebuild(); });

  record();
  // Waiting for the screen is no work: it must not make the picture smaller.
  const std::chrono::duration<float, std::milli> work = std::chrono::steady_clock::now() - now;
  screen_.swapchain.set_vsync(wishes_.vsync);
  screen_.swapchain.present(screen_.canvas.image());
  // A reference is for one size: once it is under way, only a camera that moves changes it.
  follow_pace(work.count(), !sides_.has_reference() || !same_view);
  hand_out();  // before the reference goes on: what is said of a picture is of what was drawn
  const bool scores_anew = sides_.has_reference() && pace_.last() == Pace::Draws::full;
  if (!sides_.wants_reference() || is_drawn_as_it_stays() || scores_anew) attempt(message_, [&] { sides_.follow(*session_); });
  if (says_what_is_built) {
    const ViewState built = *std::exchange(building_, std::nullopt);
    if (built.same_picture(state_)) return;
    if (const auto settings = parsed(built)) apply(built, *settings);
  }
}

void Viewer::show_interface(ViewState& next) {
  panels_.set_speed(camera_.camera().speed());
  panels_.set_map_divisor(pace_.slow() ? pace_.divisor() : 1);
  if (wishes_.interface) {
    if (begin_main_panel()) {
      if (const auto scene = scene_panel_.show(state_.view.scene, workspace_.recent)) open(*scene);
      scene_panel_.show_casting(next, session_->scene());
    }
    ImGui::End();
    panels_.show(next, wishes_, *session_, techniques_);
    if (begin_section("Compare", sides_.compares())) sides_.show(next, *session_, panels_.light());
    end_section();
    explain_.show(*session_, techniques_);
    measure_.show(timings_, wishes_.separate_passes, *session_, techniques_);
    outputs_.show(next, *session_);
    state_panels_.show(next, camera_, *session_, message_);
  }
  if (building_) {
    const auto names = names_in_force(building_->techniques, session_->frame().lights());
    show_notice(fmt::format("building {} ...", fmt::join(names, ", ")));
  }
  if (opening_) show_progress(opening_->status(), opening_->share());
  sides_.show_divider();
  explain_.show_marks(*session_);
  // One box at a time: a notice waits until the failure is closed.
  if (std::string& failed = failure(); !failed.empty()) {
    if (Panels::show_message(failed, MessageKind::failure)) failed.clear();
    return;
  }
  Notices& notices = workspace_.notices;
  notices.pass(static_cast<double>(ImGui::GetIO().DeltaTime));
  if (Panels::show_message(notices.text(), MessageKind::notice)) notices.clear();
}

std::string& Viewer::failure() {
  if (!message_.empty()) return message_;
  return !shaders_.message().empty() ? shaders_.message() : outputs_.message();
}

PictureContent Viewer::picture_content() const {
  PictureContent content;
  content.drawn_over = explain_.overlay_drawn();
  // The error keeps the brightness of what it lies on, and none of its colours.
  if (sides_.shows_error())
    content.drawn_over = "the error" + (content.drawn_over.empty() ? "" : ", and in grey below it " + content.drawn_over);
  content.first_side_alone = sides_.divider() < 1.0f;
  return content;
}

void Viewer::record() {
  if (!recorder_ || recorder_separates_ != wishes_.separate_passes) {
    recorder_separates_ = wishes_.separate_passes;
    const bool alone = recorder_separates_ && device_.info().software;
    recorder_ = std::make_unique<Recorder>(device_, recorder_separates_ ? TimingMode::measure : TimingMode::play, alone);
    timings_.clear();
  }
  draw_second();
  if (pace_.draws_once()) draw_once();
  const bool draws = pace_.last() != Pace::Draws::nothing;
  recorder_->begin();
  if (draws) record_picture(*recorder_);
  screen_.canvas.record_window(*recorder_, sides_.divider(), interface_, explain_.uses());
  const FrameResult result = recorder_->finish();
  // The time of another frame is not that of its techniques.
  if (draws && !draws_small_maps()) timings_.add(result);
  // Of a picture that was given up there is nothing to tell.
  if (draws || pace_.stays())
    attempt(message_, [&] {
      explain_.collect(*session_, techniques_, 0);
      explain_.judge(*session_);
    });
}

void Viewer::record_picture(Recorder& recorder) {
  session_->record_frame(recorder, (draws_small_maps() ? small_ : techniques_).techniques());
  explain_.record(recorder, *session_, techniques_, 0);
  sides_.record_error(recorder, session_->frame());
  screen_.canvas.record_picture(recorder, session_->frame(), 0);
}

// What it records ends between two passes where the user does something meanwhile.
Recorder& Viewer::patient() {
  if (!patient_) {
    patient_ = std::make_unique<Recorder>(device_, TimingMode::play, true);
    patient_->give_up_when([this] { return interrupted() || window_.has_input(); });
  }
  return *patient_;
}

void Viewer::give_up() {
  pace_.give_up();
  session_->frame_is_given_up();
}

void Viewer::draw_once() {
  const auto start = std::chrono::steady_clock::now();
  try {
    patient().begin();
    record_picture(patient());
    patient().finish();
    const std::chrono::duration<float, std::milli> took = std::chrono::steady_clock::now() - start;
    pace_.done(took.count(), wishes_.target_ms);
  } catch (const GivenUp&) {
    give_up();
  }
}

void Viewer::choose_draws() {
  const std::string over = explain_.key(0) + " " + sides_.key();
  const bool slides = ImGui::IsAnyItemActive() && ImGui::IsMouseDown(0);  // the opacity does, say
  Pace::Asked asked = {};
  asked.outdated = std::exchange(drawn_over_key_, over) != over;
  asked.changed = !drawn_ || !drawn_->same_picture(state_) || (asked.outdated && slides);
  if (asked.changed) drawn_ = state_;
  const bool taken = wishes_.screenshot || outputs_.wants_frame();
  const bool measured = measure_.open() || wishes_.separate_passes;
  const bool in_each_frame = taken || measured || explain_.reads_map() || techniques_.has_history() || sides_.has_history();
  // What is explained or set beside another has maps in full size.
  const bool compared = sides_.second_settings() || explain_.reads_frame();
  may_shrink_ = asked.may_shrink = wishes_.adapt_size && !in_each_frame && !compared;
  // Before the size is found nothing stays: it is found by drawing.
  // It is found where a reference holds it, or where there is no memory for another one.
  const bool settled = pace_.slow() || render_scale_.settled() || sides_.has_reference() || refused_size_;
  stays_finer_ =
      wishes_.adapt_size && !in_each_frame && (!settled || pace_.slow() || render_scale_.scale() < RenderScale::k_most);
  asked.may_stay = stays_finer_ && settled;
  pace_.next(asked, last_frame_);
}

void Viewer::follow_pace(float work_ms, bool size_is_free) {
  // What others do on the device at the same time is not the view's.
  const bool alone = size_is_free && !outputs_.measuring() && !sides_.has_reference();
  if (!wishes_.adapt_size) pace_.forget();
  if (may_shrink_ && alone) pace_.add_frame(work_ms, wishes_.target_ms, render_scale_.exhausted());
  if (std::exchange(was_slow_, pace_.slow()) != pace_.slow()) render_scale_.forget();
  render_scale_.set_least(draws_small_maps() ? RenderScale::k_least_moving : RenderScale::k_least);
  const uint32_t divisor = pace_.slow() ? pace_.divisor() : 0;
  if (std::exchange(small_divisor_, divisor) != divisor) {
    small_.clear();
    if (divisor > 0 && !attempt(message_, [&] { small_.update(*session_, state_.techniques, divisor); }))
      pace_.refuse(), small_.clear();
  }
  // One that is taken home may have another size.
  const bool own_size = session_->options().size == scaled(window_.size(), render_scale_.scale());
  if (size_is_free && own_size && pace_.last() != Pace::Draws::nothing) render_scale_.add_frame(work_ms);
}

// What leaves the window: pictures, clips, the clipboard, the status file.
void Viewer::hand_out() {
  if (std::exchange(wishes_.screenshot, false)) outputs_.want_picture(".png");
  if (!draws_small_maps()) outputs_.take(state_, *session_, picture_content(), workspace_.notices);
  if (std::exchange(wishes_.copy_command, false)) glfwSetClipboardString(window_.handle(), command().c_str());
  if (!status_.on()) return;
  status_.write({window_.size(), session_->options().size, command(), camera_.camera().text(), failure(),
                 screen_.swapchain.vsync(), opening_.has_value(), pace_.shows_full()});
}

void Viewer::draw_second() {
  const bool rests = pace_.draws_once() || pace_.stays();
  try {
    attempt(message_, [&] {
      const bool drawn = sides_.draw_second(rests ? patient() : *recorder_, *session_, state_, screen_.canvas, explain_);
      if (drawn && pace_.last() == Pace::Draws::nothing) pace_.draw_again();
    });
  } catch (const GivenUp&) {
    give_up();
  }
}

// Changes count in this frame, unless something must be built for them: then the next frame says so, and they count behind it.
void Viewer::follow(const ViewState& next) {
  if (building_) {
    building_ = next;
    return;
  }
  if (next.same_picture(state_)) return;
  const auto settings = parsed(next);
  bool must_build = false;
  if (!settings || !attempt(message_, [&] { must_build = builds(next, *settings); })) return;
  if (must_build) {
    building_ = next;
  } else {
    apply(next, *settings);
  }
}

std::optional<Settings> Viewer::parsed(const ViewState& state) {
  std::optional<Settings> settings;
  attempt(message_, [&] { settings = state.settings(); });
  return settings;
}

bool Viewer::builds(const ViewState& next, const Settings& settings) const {
  if (next.same_but_camera(state_)) return false;
  return session_->needs_new_frame(next.view, settings) ||
         techniques_.builds(session_->frame().lights(), next.techniques, settings);
}

void Viewer::apply(const ViewState& wanted, const Settings& settings) {
  ViewState next = wanted;
  settle_samples(next.view, device_.info());
  const auto change = [this](const ViewState& state, const Settings& of_state) {
    if (session_->needs_new_frame(state.view, of_state)) techniques_.clear(), small_.clear(), sides_.forget();
    if (state.view.casts != session_->options().casts) explain_.forget_rays(), rays_.forget();
    session_->change(state.view, of_state);
  };
  const bool done = attempt(message_, [&] {
    change(next, settings);
    if (next.techniques != state_.techniques) timings_.clear(), render_scale_.forget(), pace_.forget(), small_.clear();
    update_techniques(next.techniques);
    const bool other_settings = next.edits != state_.edits || next.base.assignments() != state_.base.assignments();
    if (other_settings || next.view.samples != state_.view.samples) timings_.change();
    state_ = next;
    message_.clear();
  });
  if (done) return;
  drawn_.reset();  // the frame may be a new one
  change(state_, state_.settings());
  update_techniques(state_.techniques);
}

void Viewer::update_techniques(const std::vector<std::string>& names) {
  techniques_.update(*session_, names);
  if (pace_.slow()) small_.update(*session_, names, pace_.divisor());
}

uvec2 Viewer::wanted_size() const {
  if (!wishes_.adapt_size) return scaled(window_.size(), wishes_.scale);
  // The picture at rest, or one that is saved, is drawn once: it may take longer. So may those of a clip that would have small
  // maps.
  const bool saved = wishes_.screenshot || outputs_.wants_picture() || (pace_.slow() && outputs_.wants_frame());
  const bool stays = saved || pace_.draws_once() || pace_.last() == Pace::Draws::nothing;
  return scaled(window_.size(), stays ? rest_scale() : render_scale_.scale());
}

float Viewer::rest_scale() const {
  const float moving = render_scale_.scale();
  // Four times the pixels take at most four times as long, and input waits for one pass of them.
  const float finer = pace_.slow() ? moving : 2.0f * moving;
  return std::clamp(finer, std::max(moving, k_least_rest), RenderScale::k_most);
}

bool Viewer::follow_size() {
  render_scale_.set_target(wishes_.target_ms);
  // Without adapting, the picture keeps the size that it has.
  if (wishes_.adapt_size)
    wishes_.scale = static_cast<float>(session_->options().size.x) / static_cast<float>(std::max(window_.size().x, 1u));
  // While a window is dragged to another size the old picture is stretched.
  const uvec2 window = window_.size();
  const auto now = std::chrono::steady_clock::now();
  if (window != last_window_) last_window_ = window, window_changed_ = now;
  const uvec2 wanted = wanted_size();
  if (wanted == session_->options().size || wanted == refused_size_ || now - window_changed_ < k_size_settles) return false;
  // A reference that is there, or under way, is for this size; only a view that moves gives it up.
  if (outputs_.recording() || (wishes_.adapt_size && window == sized_for_ && sides_.has_reference())) return false;
  refused_size_ = wanted;  // unless it goes well: the old size is then stretched to the window
  attempt(message_, [&] {
    session_->resize(wanted);
    state_.view.size = wanted;
    refused_size_.reset();
    sized_for_ = window;
    timings_.change();
    if (!state_.view.camera.empty() && state_.view.camera != "frame") return;
    // A camera that holds the whole scene in the picture stands elsewhere in a picture of another shape, as it does for
    // `render`.
    session_->change(state_.view, state_.settings());
    camera_.stand_at(session_->camera());
  });
  return session_->options().size == wanted;
}

std::string Viewer::command() const { return state_.command(session_->options().size); }

void Viewer::rebuild() {
  techniques_.clear();
  small_.clear();
  pace_.forget();
  sides_.forget();
  explain_.rebuild(interface_.render_pass());
  session_->rebuild();
  techniques_.update(*session_, state_.techniques);
}

}  // namespace gnomon::viewer
