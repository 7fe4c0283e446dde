// The sides' pictures and scores; what the user sees of them is in sides_panel.cpp.
#include "app/viewer/compare/sides.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.h"
#include "lab/experiment/reference_set.h"

namespace gnomon::viewer {
namespace {

// A technique's first frames may differ from the later ones: caches fill.
constexpr int k_settling_frames = 3;
// Reading a mask back and comparing it takes a few milliseconds.
constexpr std::chrono::milliseconds k_between_scores{300};

void append(std::vector<std::byte>& key, std::span<const std::byte> bytes) {
  key.insert(key.end(), bytes.begin(), bytes.end());
}

bool of_view(const std::string& key) {
  return key.starts_with("light.") || key.starts_with("camera.") || key.starts_with("scene.");
}

}  // namespace

Sides::Sides(SidesChoice& choice, const ViewState& state, SharedReference& rays) : rays_(rays), choice_(choice) {
  if (choice_.other.view.scene != state.view.scene) choice_.other = state_for_scene(choice_.other, state.view.scene);
}

float Sides::divider() const {
  // Until there is a reference the second picture is of another view, or of another scene.
  if (choice_.second == SecondSide::none || (choice_.second == SecondSide::reference && !(reference_ && reference_->answer())))
    return 1.0f;
  if (choice_.flip_mode) return choice_.flipped ? 0.0f : 1.0f;
  return choice_.divider;
}

ViewState Sides::second_state(const ViewState& first) const {
  ViewState state = choice_.other;
  state.view = first.view;
  std::erase_if(state.edits, [](const auto& edit) { return of_view(edit.first); });
  for (const auto& [key, value] : first.edits) {
    if (of_view(key)) state.edits[key] = value;
  }
  if (first.base.assignments() == choice_.other.base.assignments()) return state;
  // A preset was loaded since, which has brought its own.
  state.base = {};
  for (const std::string& assignment : choice_.other.base.assignments()) {
    if (!of_view(assignment)) state.base.assign(assignment);
  }
  for (const std::string& assignment : first.base.assignments()) {
    if (of_view(assignment)) state.base.assign(assignment);
  }
  return state;
}

std::string Sides::key() const {
  const int samples = shows_error() ? reference_->answer()->samples : 0;
  return fmt::format("{} {} {} {}", static_cast<int>(choice_.second), samples, light_, choice_.error);
}

bool Sides::draw_second(Recorder& recorder, Session& session, const ViewState& state, Canvas& canvas, Explain& explain) {
  // Camera, lights or size may be others since the last frame: neither picture nor score may read the old answer.
  if (reference_) reference_->forget_other_view(session);
  if (choice_.second == SecondSide::none) return techniques_.clear(), score_[1].reset(), false;
  const auto name_of_side = [&](const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names_in_force(names, session.frame().lights()), ", "));
  };
  names_[0] = name_of_side(state.techniques);
  if (choice_.second == SecondSide::settings) {
    choice_.other.complete_techniques(session.frame().lights());
    names_[1] = name_of_side(choice_.other.techniques);
    return draw_settings(recorder, session, state, canvas, explain);
  }
  techniques_.clear(), score_[1].reset();
  names_[1] = reference_ && reference_->answer() ? "reference" : "reference: waits for a still view";
  draw_reference(recorder, session, canvas);
  return false;
}

bool Sides::draw_settings(Recorder& recorder, Session& session, const ViewState& state, Canvas& canvas, Explain& explain) {
  if (!first_.same_picture(state) || !made_of_.same_picture(choice_.other)) {
    first_ = state, made_of_ = choice_.other;
    ViewState second = second_state(state);
    if (!second.same_picture(second_)) second_ = std::move(second), second_key_.clear();
  }
  std::vector<std::byte> key = view_key(session.frame());
  append(key, std::as_bytes(std::span(&choice_.error, 1)));
  const std::string explained = explain.key(1);
  append(key, std::as_bytes(std::span(explained)));
  if (key != second_key_) settling_ = k_settling_frames;
  second_key_ = std::move(key);
  if (settling_ == 0) return false;
  const auto back_to_first = [&] { session.change(state.view, state.settings()); };
  try {
    session.change(second_.view, second_.settings());
    techniques_.update(session, second_.techniques);
    if (!techniques_.has_history()) --settling_;
    recorder.frame([&] {
      session.record_frame(recorder, techniques_.techniques());
      explain.record(recorder, session, techniques_, 1);
      record_error(recorder, session.frame());
      canvas.record_picture(recorder, session.frame(), 1);
    });
    explain.collect(session, techniques_, 1);
    score_[1] = score(session);
    back_to_first();
    return true;
  } catch (const GivenUp&) {
    second_key_.clear();
    back_to_first();
    throw;
  } catch (const Error&) {
    choice_.second = SecondSide::none;
    back_to_first();
    throw;
  }
}

void Sides::draw_reference(Recorder& recorder, Session& session, Canvas& canvas) {
  if (!reference_ || !reference_->answer()) return;
  std::vector<std::byte> key = view_key(session.frame());
  append(key, std::as_bytes(std::span(&reference_->answer()->samples, 1)));
  append(key, std::as_bytes(std::span(session.settings().block("frame").words())));
  if (key == second_key_) return;
  second_key_ = std::move(key);
  // The surface buffer is that of the last frame, which had the same view.
  recorder.frame([&] {
    session.frame().record_shade(recorder, reference_->error_view().reference());
    canvas.record_picture(recorder, session.frame(), 1);
  });
}

void Sides::record_error(Recorder& recorder, const Frame& frame) const {
  if (shows_error()) reference_->error_view().record(recorder, frame, light_);
}

std::optional<Sides::Score> Sides::score(Session& session) const {
  const ProgressiveReference::Answer* answer = reference_ ? reference_->answer() : nullptr;
  if (!answer || light_ >= answer->lights.size()) return std::nullopt;
  const ReferenceResult& truth = answer->lights[light_];
  // A view may show no receiver.
  if (std::find(truth.receiver.begin(), truth.receiver.end(), 1) == truth.receiver.end()) return std::nullopt;
  return Score{visibility_error(session.frame().read_mask(light_), truth.visibility, truth.receiver), answer->samples};
}

void Sides::follow(Session& session) {
  if (!wants_reference()) {
    if (reference_) reference_->give_up();
    score_ = {};
    return;
  }
  if (!reference_) reference_ = std::make_unique<ViewReference>(session, rays_, rasterised_caster_triangles(session));
  const bool changed = reference_->update(session);
  if (changed) settling_ = std::max(settling_, 1);  // the second side's scores, too
  if (!reference_->answer()) {
    score_ = {};
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (!changed && now - scored_ < k_between_scores) return;
  scored_ = now;
  score_[0] = score(session);
}

}  // namespace gnomon::viewer
