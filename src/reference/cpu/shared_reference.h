// One acceleration structure for all who trace the same scene.
#pragma once

#include <mutex>
#include <optional>

#include "reference/cpu/embree_reference.h"

namespace gnomon {

class SharedReference {
 public:
  // Keeps a reference to the scene.
  explicit SharedReference(const Scene& scene) : scene_(scene) {}

  // Built by the first thread that asks; others wait for it meanwhile. Throws what building throws; the next call then tries
  // again.
  const EmbreeReference& get();
  // The scene has other casters: the next call builds anew. Nobody may use an answer of get() any more.
  void forget();

 private:
  const Scene& scene_;
  std::mutex building_;
  std::optional<EmbreeReference> reference_;
};

}  // namespace gnomon
