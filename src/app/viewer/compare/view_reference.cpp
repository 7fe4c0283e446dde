#include "app/viewer/compare/view_reference.h"

#include "frame/light_data.h"
#include "lab/view/lab_params.h"

namespace gnomon::viewer {
namespace {

// A camera that moves starts nothing.
constexpr int k_still_frames = 3;

void add_bytes(std::vector<std::byte>& key, std::span<const std::byte> bytes) {
  key.insert(key.end(), bytes.begin(), bytes.end());
}

std::vector<std::byte> reference_key(Session& session) {
  std::vector<std::byte> key = view_key(session.frame());
  add_bytes(key, std::as_bytes(std::span(session.settings().block("reference").words())));
  return key;
}

}  // namespace

std::vector<std::byte> view_key(const Frame& frame) {
  std::vector<std::byte> key;
  const auto add = [&](const auto& value) { add_bytes(key, std::as_bytes(std::span(&value, 1))); };
  add(frame.camera());
  for (const Light& light : frame.lights()) add(light_data(light));
  return key;
}

ViewReference::ViewReference(Session& session, SharedReference& rays, size_t caster_triangles)
    : error_view_(session.device(), session.frame().samples()), tracer_(rays, caster_triangles) {}

void ViewReference::give_up() {
  tracer_.stop();
  answer_.reset();
  key_.clear();
  started_ = false;
}

void ViewReference::start(Session& session) {
  const auto params = session.settings().block("reference").as<reference_params::Params>();
  const Frame& frame = session.frame();
  ProgressiveReference::View view;
  view.points = frame.read_points();
  view.samples_of_pixel = frame.samples();
  view.eye_ws = frame.camera().eye_ws;
  view.lights.assign(frame.lights().begin(), frame.lights().end());
  view.area = params.area;
  view.samples = samples_ = params.samples;
  view.seed = static_cast<uint32_t>(params.seed);
  tracer_.start(std::move(view));
  started_ = true;
}

void ViewReference::forget_other_view(Session& session) {
  if ((answer_ || started_) && reference_key(session) != key_) give_up();
}

bool ViewReference::update(Session& session) {
  std::vector<std::byte> key = reference_key(session);
  if (key != key_) {
    const bool had_one = answer_.has_value();
    give_up();
    key_ = std::move(key);
    still_frames_ = 0;
    return had_one;
  }
  if (!started_ && ++still_frames_ >= k_still_frames) start(session);
  auto answer = tracer_.poll();
  if (!answer) return false;
  answer_ = std::move(answer);
  std::vector<ErrorView::Reference> lights;
  for (const ReferenceResult& light : answer_->lights) lights.push_back({light.visibility, light.receiver});
  error_view_.set_reference(session.frame(), lights);
  return true;
}

}  // namespace gnomon::viewer
