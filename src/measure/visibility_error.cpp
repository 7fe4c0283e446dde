// One pass over the samples for the numbers, one over the pixels for each picture.
#include "measure/visibility_error.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/maths.h"

namespace gnomon {
namespace {

// Half floats and 8-bit texels overshoot [0, 1] by less.
constexpr float k_range_slack = 1.0e-3f;
// A mask of 8 bits that is one step off differs by 1/255 give or take a rounding of the subtraction.
constexpr float k_threshold = k_visible_difference * 1.0001f;

// Sums of one kind of error.
struct OneSidedSum {
  size_t count = 0;
  double sum = 0.0;
  void add(double difference) { ++count, sum += difference; }
  OneSidedError over(size_t receivers) const {
    const auto n = static_cast<double>(count);
    return {n / static_cast<double>(receivers), count > 0 ? sum / n : 0.0};
  }
};

void check_range(const char* what, std::span<const float> values) {
  for (size_t i = 0; i < values.size(); ++i) {
    // Written so that NaN fails the test.
    if (values[i] >= -k_range_slack && values[i] <= 1.0f + k_range_slack) continue;
    fail("the {} holds {} at sample {} of {}; valid: 0 to 1", what, values[i], i, values.size());
  }
}

nlohmann::json one_sided_json(const OneSidedError& error) { return {{"area", error.area}, {"severity", error.severity}}; }

uint8_t to_byte(float value) { return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f)); }

void store(Image8& image, int x, int y, const vec3& colour) {
  uint8_t* texel = image.at(x, y);
  texel[0] = to_byte(colour.x), texel[1] = to_byte(colour.y), texel[2] = to_byte(colour.z), texel[3] = 255;
}

// Rec. 709 luma in display values.
float luma(const uint8_t* texel) {
  return (0.2126f * static_cast<float>(texel[0]) + 0.7152f * static_cast<float>(texel[1]) +
          0.0722f * static_cast<float>(texel[2])) /
         255.0f;
}

// Vermilion and blue of Okabe and Ito (2008), which colour-blind readers tell apart, lightened to stand off a dark grey.
const vec3 k_false_shadow_colour(0.95f, 0.33f, 0.05f);
const vec3 k_false_light_colour(0.15f, 0.55f, 0.98f);
// No grey: neither shadow nor light.
const vec3 k_no_receiver_colour(0.27f, 0.22f, 0.40f);

// A difference of 2 % must be seen and one of 50 % still be told from one of 100 %.
float error_strength(float difference) {
  return difference > k_threshold ? std::min(1.0f, 0.15f + 0.85f * std::sqrt(difference)) : 0.0f;
}

}  // namespace

nlohmann::json VisibilityError::to_json() const {
  return {{"mae", mae},
          {"rmse", rmse},
          {"bias", bias},
          {"false_shadow", one_sided_json(false_shadow)},
          {"false_light", one_sided_json(false_light)},
          {"receivers", receivers}};
}

VisibilityError visibility_error(std::span<const float> mask, std::span<const float> reference,
                                 std::span<const uint8_t> receiver) {
  GNOMON_ASSERT(mask.size() == reference.size() && mask.size() == receiver.size());
  check_range("visibility mask", mask);
  check_range("reference", reference);
  VisibilityError error;
  OneSidedSum false_shadow, false_light;
  double sum = 0.0, sum_of_absolutes = 0.0, sum_of_squares = 0.0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (!receiver[i]) continue;
    ++error.receivers;
    const double difference = static_cast<double>(mask[i]) - static_cast<double>(reference[i]);
    sum += difference;
    sum_of_absolutes += std::abs(difference);
    sum_of_squares += difference * difference;
    if (difference < -k_threshold) false_shadow.add(-difference);
    if (difference > k_threshold) false_light.add(difference);
  }
  if (error.receivers == 0)
    fail("no sample of the picture shows a surface that faces the light: there is no visibility to compare");
  const auto n = static_cast<double>(error.receivers);
  error.mae = sum_of_absolutes / n;
  error.rmse = std::sqrt(sum_of_squares / n);
  error.bias = sum / n;
  error.false_shadow = false_shadow.over(error.receivers);
  error.false_light = false_light.over(error.receivers);
  return error;
}

Image8 signed_error_map(std::span<const float> mask, std::span<const float> reference, std::span<const uint8_t> receiver,
                        int samples, const Image8& shaded) {
  GNOMON_ASSERT(samples > 0 && mask.size() == static_cast<size_t>(shaded.width) * shaded.height * samples);
  GNOMON_ASSERT(mask.size() == reference.size() && mask.size() == receiver.size());
  Image8 image(shaded.width, shaded.height);
  size_t i = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      // Both signs apart: at an edge they would cancel.
      float too_dark = 0.0f, too_bright = 0.0f;
      for (const size_t end = i + static_cast<size_t>(samples); i < end; ++i) {
        if (!receiver[i]) continue;
        too_dark += std::max(reference[i] - mask[i], 0.0f);
        too_bright += std::max(mask[i] - reference[i], 0.0f);
      }
      const float total = (too_dark + too_bright) / static_cast<float>(samples);
      const vec3 grey(0.06f + 0.5f * luma(shaded.at(x, y)));
      const vec3 hue =
          total > 0.0f ? glm::mix(k_false_light_colour, k_false_shadow_colour, too_dark / (too_dark + too_bright)) : grey;
      store(image, x, y, glm::mix(grey, hue, error_strength(total)));
    }
  }
  return image;
}

Image8 mask_picture(std::span<const float> mask, std::span<const uint8_t> receiver, int width, int height, int samples) {
  GNOMON_ASSERT(samples > 0 && mask.size() == static_cast<size_t>(width) * height * samples && mask.size() == receiver.size());
  Image8 image(width, height);
  size_t i = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      vec3 sum(0.0f);
      for (const size_t end = i + static_cast<size_t>(samples); i < end; ++i)
        sum += receiver[i] ? vec3(mask[i]) : k_no_receiver_colour;
      store(image, x, y, sum / static_cast<float>(samples));
    }
  }
  return image;
}

nlohmann::json ImageError::to_json() const { return {{"rmse", rmse}, {"psnr", psnr}}; }

ImageError image_error(const Image8& image, const Image8& reference) {
  if (image.width != reference.width || image.height != reference.height || image.rgba.empty()) {
    fail("pictures of {} x {} and {} x {} pixels cannot be compared", image.width, image.height, reference.width,
         reference.height);
  }
  uint64_t sum = 0;  // exact: 3 * 255^2 * 2^28 pixels fit
  for (size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 == 3) continue;  // alpha
    const int difference = image.rgba[i] - reference.rgba[i];
    sum += static_cast<uint64_t>(difference * difference);
  }
  const double values = 0.75 * static_cast<double>(image.rgba.size());
  ImageError error;
  error.rmse = std::sqrt(static_cast<double>(sum) / values) / 255.0;
  // 99 dB stands for equal pictures; one step in one value of 16384 x 16384 pixels is 137 dB, so unequal ones are capped below.
  error.psnr = sum == 0 ? 99.0 : std::min(98.9, -20.0 * std::log10(error.rmse));
  return error;
}

}  // namespace gnomon
