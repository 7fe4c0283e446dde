// How wrong a visibility mask is: compared with the reference of the same samples, receivers only.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "base/image.h"

namespace gnomon {

// Differences up to this are rounding of 8-bit pictures and no artefact.
inline constexpr float k_visible_difference = 1.0f / 255.0f;

struct OneSidedError {
  double area = 0.0;      // share of receivers, [0, 1]
  double severity = 0.0;  // mean difference among those, [0, 1]
};

struct VisibilityError {
  double mae = 0.0, rmse = 0.0;
  double bias = 0.0;  // mean(mask - reference)
  OneSidedError false_shadow, false_light;
  size_t receivers = 0;

  nlohmann::json to_json() const;
};

// One entry per sample in all three spans. Throws Error when there is no receiver (an error of nothing is not zero) or when
// the mask holds NaN or leaves [0, 1] by more than rounding, naming the first such sample.
VisibilityError visibility_error(std::span<const float> mask, std::span<const float> reference,
                                 std::span<const uint8_t> receiver);

// Vermilion: false shadow, blue: false light, grey: agreement, over the luminance of `shaded` (same size; samples are averaged
// per pixel, each sign apart). samples: per pixel; spans are ordered pixel by pixel, then sample.
Image8 signed_error_map(std::span<const float> mask, std::span<const float> reference, std::span<const uint8_t> receiver,
                        int samples, const Image8& shaded);

// The mask itself as grey levels; sky and points that face away from the light are violet, so that they are not taken for
// shadow.
Image8 mask_picture(std::span<const float> mask, std::span<const uint8_t> receiver, int width, int height, int samples);

// On 8-bit sRGB pictures of equal size, in display values [0, 1].
struct ImageError {
  double rmse = 0.0, psnr = 0.0;  // psnr in dB; 99 for equal pictures
  nlohmann::json to_json() const;
};
ImageError image_error(const Image8& image, const Image8& reference);

}  // namespace gnomon
