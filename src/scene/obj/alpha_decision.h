// Whether the alpha channel of a colour picture (map_Kd) cuts holes where the library says nothing of it (no map_d): most such
// channels are cut-outs, and some hold gloss or the places of a second colour.
#pragma once

#include <string>
#include <vector>

#include "base/image.h"
#include "scene/load.h"

namespace gnomon {

class AlphaDecision {
 public:
  explicit AlphaDecision(const SceneFileOptions& options) : rule_(options.params.alpha_from_colour) {}

  // Remembers what was decided by looking at the picture alone, where faces have it (`is_seen`).
  bool cuts(const Image8& picture, const std::string& material, bool is_seen);
  // Names those materials, one line for each decision.
  void say(const std::string& source) const;

 private:
  uint32_t rule_;                                // one of scene_file_params::alpha_from_colour_*
  std::vector<std::string> cut_, whole_, none_;  // "leaf (70 %)"; none_: of which nothing would be left
};

}  // namespace gnomon
