// Errors on hand-computed data, refusals, and the colours of the pictures.
#include "measure/visibility_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/error.h"

namespace gnomon {
namespace {

using Floats = std::vector<float>;
using Bytes = std::vector<uint8_t>;

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(VisibilityError, HandComputed) {
  // Differences of the receivers: -1, +0.5, 0, +0.25; the last sample is no receiver.
  const Floats mask = {0, 0.75f, 1, 0.25f, 1}, reference = {1, 0.25f, 1, 0, 0};
  const VisibilityError error = visibility_error(mask, reference, Bytes{1, 1, 1, 1, 0});
  EXPECT_EQ(error.receivers, 4u);
  EXPECT_DOUBLE_EQ(error.mae, 1.75 / 4);
  EXPECT_DOUBLE_EQ(error.rmse, std::sqrt((1 + 0.25 + 0.0625) / 4));
  EXPECT_DOUBLE_EQ(error.bias, -0.25 / 4);
  EXPECT_DOUBLE_EQ(error.false_shadow.area, 0.25);
  EXPECT_DOUBLE_EQ(error.false_shadow.severity, 1.0);
  EXPECT_DOUBLE_EQ(error.false_light.area, 0.5);
  EXPECT_DOUBLE_EQ(error.false_light.severity, 0.375);
  const nlohmann::json json = error.to_json();
  EXPECT_EQ(json.at("false_light").at("severity"), 0.375);
  EXPECT_EQ(json.at("receivers"), 4);
}

TEST(VisibilityError, PartialDifferencesCountAsMuchAsTheyAre) {
  // Differences: -0.25, -0.75, +0.125, +0.5, +0.25, 0, and +1 of what is no receiver. No score equals another one.
  const Floats mask = {0.5f, 0.125f, 0.625f, 0.75f, 0.25f, 0.375f, 1}, reference = {0.75f, 0.875f, 0.5f, 0.25f, 0, 0.375f, 0};
  const VisibilityError error = visibility_error(mask, reference, Bytes{1, 1, 1, 1, 1, 1, 0});
  EXPECT_EQ(error.receivers, 6u);
  EXPECT_DOUBLE_EQ(error.mae, 1.875 / 6);
  EXPECT_DOUBLE_EQ(error.rmse, std::sqrt((0.0625 + 0.5625 + 0.015625 + 0.25 + 0.0625) / 6));
  EXPECT_DOUBLE_EQ(error.bias, -0.125 / 6);
  EXPECT_DOUBLE_EQ(error.false_shadow.area, 2.0 / 6);
  EXPECT_DOUBLE_EQ(error.false_shadow.severity, 0.5) << "a mean, neither of squares nor the largest";
  EXPECT_DOUBLE_EQ(error.false_light.area, 3.0 / 6);
  EXPECT_DOUBLE_EQ(error.false_light.severity, 0.875 / 3);
  EXPECT_EQ(error.to_json(), (nlohmann::json{{"mae", error.mae},
                                             {"rmse", error.rmse},
                                             {"bias", error.bias},
                                             {"false_shadow", {{"area", 2.0 / 6}, {"severity", 0.5}}},
                                             {"false_light", {{"area", 0.5}, {"severity", 0.875 / 3}}},
                                             {"receivers", 6}}));
}

// Three tenths and seven tenths by either sign: their mean is a half, that of their squares 0.29.
TEST(VisibilityError, SeverityIsTheMeanOfBothSigns) {
  const Floats low = {0.2f, 0.1f}, high = {0.5f, 0.8f};
  EXPECT_NEAR(visibility_error(low, high, Bytes{1, 1}).false_shadow.severity, 0.5, 1e-7);
  EXPECT_NEAR(visibility_error(high, low, Bytes{1, 1}).false_light.severity, 0.5, 1e-7);
}

TEST(VisibilityError, EqualMasksHaveNone) {
  const Floats mask = {0, 0.3f, 1};
  const VisibilityError error = visibility_error(mask, mask, Bytes{1, 1, 1});
  EXPECT_EQ(error.mae + error.rmse + std::abs(error.bias) + error.false_shadow.area + error.false_light.area, 0.0);
  EXPECT_EQ(error.false_shadow.severity, 0.0);
}

TEST(VisibilityError, OneStepOfEightBitsIsNoArtefact) {
  for (int i = 0; i < 255; ++i) {
    const Floats low = {static_cast<float>(i) / 255.0f}, high = {static_cast<float>(i + 1) / 255.0f};
    EXPECT_EQ(visibility_error(low, high, Bytes{1}).false_shadow.area, 0.0) << i;
    EXPECT_EQ(visibility_error(high, low, Bytes{1}).false_light.area, 0.0) << i;
  }
  EXPECT_EQ(visibility_error(Floats{0.5f}, Floats{0.505f}, Bytes{1}).false_shadow.area, 1.0);
}

TEST(VisibilityError, RefusesNothingToCompare) {
  EXPECT_NE(message_of([] { visibility_error(Floats{1}, Floats{1}, Bytes{0}); }).find("faces the light"), std::string::npos);
  EXPECT_NE(message_of([] { visibility_error(Floats{}, Floats{}, Bytes{}); }).find("faces the light"), std::string::npos);
}

TEST(VisibilityError, RefusesMasksThatAreNoVisibility) {
  const Floats good = {1, 1, 1};
  const Bytes receiver = {1, 1, 0};
  for (const float bad : {std::nanf(""), 1.01f, -0.01f, std::numeric_limits<float>::infinity()}) {
    EXPECT_NE(message_of([&] {
                visibility_error(Floats{1, bad, bad}, good, receiver);
              }).find("mask holds"),
              std::string::npos)
        << bad;
    EXPECT_NE(message_of([&] {
                visibility_error(Floats{1, bad, bad}, good, receiver);
              }).find("sample 1 of 3"),
              std::string::npos);
    EXPECT_NE(message_of([&] {
                visibility_error(good, Floats{1, bad, 1}, receiver);
              }).find("reference holds"),
              std::string::npos);
  }
  EXPECT_NE(message_of([&] {
              visibility_error(Floats{1, 1, std::nanf("")}, good, receiver);
            }).find("sample 2"),
            std::string::npos)
      << "shading reads the mask of every sample";
  EXPECT_NO_THROW(visibility_error(Floats{1.0005f, -0.0005f, 0}, good, receiver)) << "rounding of half floats";
}

TEST(VisibilityError, MapTellsFalseShadowFromFalseLight) {
  Image8 shaded(4, 1);
  for (uint8_t& value : shaded.rgba) value = 128;
  // Per pixel two samples: false shadow, false light, agreement, error of a sample that is no receiver.
  const Floats mask = {0, 0, 1, 1, 0.5f, 1, 0, 0}, reference = {1, 1, 0, 0, 0.5f, 1, 1, 1};
  const Image8 map = signed_error_map(mask, reference, Bytes{1, 1, 1, 1, 1, 1, 0, 0}, 2, shaded);
  const uint8_t *shadow = map.at(0, 0), *light = map.at(1, 0), *agree = map.at(2, 0), *sky = map.at(3, 0);
  EXPECT_GT(shadow[0], 2 * shadow[2]);
  EXPECT_GT(light[2], 2 * light[0]);
  for (const uint8_t* grey : {agree, sky}) EXPECT_TRUE(grey[0] == grey[1] && grey[1] == grey[2]);
  EXPECT_EQ(map.at(0, 0)[3], 255);
}

TEST(VisibilityError, OppositeErrorsInAPixelDoNotCancel) {
  const Image8 map = signed_error_map(Floats{0, 1}, Floats{1, 0}, Bytes{1, 1}, 2, Image8(1, 1));
  EXPECT_NE(map.at(0, 0)[0], map.at(0, 0)[1]);
}

TEST(VisibilityError, MapIsBrighterWhereThePictureIs) {
  Image8 shaded(2, 1);
  for (int c = 0; c < 3; ++c) shaded.at(1, 0)[c] = 255;
  const Image8 map = signed_error_map(Floats{1, 1}, Floats{1, 1}, Bytes{1, 1}, 1, shaded);
  EXPECT_GT(map.at(1, 0)[0], map.at(0, 0)[0] + 50);
}

TEST(VisibilityError, MaskPictureTintsWhatReceivesNothing) {
  const Image8 picture = mask_picture(Floats{0, 0.5f, 1, 0}, Bytes{1, 1, 1, 0}, 2, 2, 1);
  EXPECT_EQ(picture.at(0, 0)[0], 0);
  EXPECT_EQ(picture.at(1, 0)[0], 128);
  EXPECT_EQ(picture.at(0, 1)[2], 255);
  EXPECT_NE(picture.at(1, 1)[0], picture.at(1, 1)[2]);
  const Image8 averaged = mask_picture(Floats{0, 1}, Bytes{1, 1}, 1, 1, 2);
  EXPECT_EQ(averaged.at(0, 0)[1], 128);
}

TEST(ImageError, AllThreeColoursCountAlike) {
  for (int channel = 0; channel < 3; ++channel) {
    Image8 a(1, 2), b(1, 2);
    a.at(0, 0)[channel] = 100, b.at(0, 0)[channel] = 49;  // 0.2 too bright
    b.at(0, 1)[channel] = 102;                            // 0.4 too dark
    EXPECT_DOUBLE_EQ(image_error(a, b).rmse, std::sqrt((0.04 + 0.16) / 6.0)) << channel;
    EXPECT_DOUBLE_EQ(image_error(a, b).psnr, -10.0 * std::log10(0.2 / 6.0)) << channel;
  }
}

TEST(ImageError, HandComputed) {
  Image8 a(2, 1), b(2, 1);
  b.at(1, 0)[2] = 51;   // 0.2 in one of six values
  b.at(0, 0)[3] = 200;  // alpha does not count
  const ImageError error = image_error(a, b);
  EXPECT_DOUBLE_EQ(error.rmse, 0.2 / std::sqrt(6.0));
  EXPECT_NEAR(error.psnr, -20.0 * std::log10(error.rmse), 1.0e-12);
  EXPECT_EQ(image_error(a, a).psnr, 99.0);
  EXPECT_EQ(image_error(a, a).rmse, 0.0);
  EXPECT_NE(message_of([&] { image_error(a, Image8(1, 2)); }).find("2 x 1 and 1 x 2"), std::string::npos);
}

}  // namespace
}  // namespace gnomon
