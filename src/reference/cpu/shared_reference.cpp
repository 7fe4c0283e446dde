#include "reference/cpu/shared_reference.h"

namespace gnomon {

const EmbreeReference& SharedReference::get() {
  const std::lock_guard lock(building_);
  if (!reference_) reference_.emplace(scene_);
  return *reference_;
}

void SharedReference::forget() {
  const std::lock_guard lock(building_);
  reference_.reset();
}

}  // namespace gnomon
