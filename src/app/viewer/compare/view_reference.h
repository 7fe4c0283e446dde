// The reference of what the viewer shows: started when the view stands still, better with time, on the GPU as soon as it is
// there.
#pragma once

#include "frame/shading/error_view.h"
#include "lab/view/session.h"
#include "reference/cpu/progressive_reference.h"

namespace gnomon::viewer {

// Everything that a mask's reference depends on: camera, size, samples, lights.
std::vector<std::byte> view_key(const Frame& frame);

class ViewReference {
 public:
  ViewReference(Session& session, SharedReference& rays, size_t caster_triangles);

  // Before anything of a frame is drawn: drops the answer where the view, or its size, is no longer that of the answer.
  void forget_other_view(Session& session);
  // Once a frame, with the surface buffer drawn. True when there is a new answer, or none any more. Throws Error.
  bool update(Session& session);
  void give_up();

  // Of the view as update or forget_other_view last saw it.
  const ProgressiveReference::Answer* answer() const { return answer_ ? &*answer_ : nullptr; }
  const ErrorView& error_view() const { return error_view_; }
  bool under_way() const { return started_ || answer_; }
  bool complete() const { return answer_ && answer_->complete; }
  double share() const { return started_ ? tracer_.share() : 0.0; }
  int samples() const { return samples_; }  // of the complete answer

 private:
  void start(Session& session);

  ErrorView error_view_;
  std::vector<std::byte> key_;
  int still_frames_ = 0;
  bool started_ = false;
  int samples_ = 1;
  std::optional<ProgressiveReference::Answer> answer_;
  ProgressiveReference tracer_;  // last: its thread reads the scene
};

}  // namespace gnomon::viewer
