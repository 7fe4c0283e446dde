// The reference of a view on the GPU: shaded like a technique's mask, and compared with one on the picture.
#pragma once

#include "frame/frame.h"

namespace gnomon {

class ErrorView {
 public:
  ErrorView(Device& device, uint32_t samples);

  // One entry per light, each a value per sample in the surface buffer's order: visibility, and whether the point is a
  // receiver.
  struct Reference {
    std::span<const float> visibility;
    std::span<const uint8_t> receiver;
  };
  void set_reference(const Frame& frame, std::span<const Reference> lights);
  const Buffer& reference() const { return reference_; }

  // Turns the shaded picture into one of the signed error of the light's mask.
  void record(Recorder& recorder, const Frame& frame, size_t light) const;

 private:
  Device& device_;
  Buffer reference_;  // light by light, as the mask; -1 where the point is no receiver
  Pipeline pipeline_;
};

}  // namespace gnomon
