// What a technique that reads a shadow map shows of it, for those who explain or display it.
#pragma once

#include <string>

#include "gpu/buffer.h"
#include "gpu/image.h"

namespace gnomon {

// Of the frame that was recorded last; valid until the technique records again.
struct ShadowMapView {
  std::string projection, filter;             // ids
  const Image* depth = nullptr;               // an array
  const Image* filtered = nullptr;            // what the filter reads: `depth` itself, or what was made of it
  const Image* object_ids = nullptr;          // null where the filter stores none
  const Buffer* views = nullptr;              // ShadowMapData, then a ShadowView for each layer
  const Buffer* params = nullptr;             // of the projection, then those of filter and bias
  size_t filter_offset = 0, bias_offset = 0;  // bytes
  uint32_t layers = 0;
  bool kept = false;       // drawn in an earlier frame (submission.cache)
  float unsettled = 0.0f;  // share of the map that is from before the views' last change (temporal.history)
};

}  // namespace gnomon
