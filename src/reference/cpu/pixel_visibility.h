// The truth of pixels: what a pixel should show of a surface is the mean visibility over what it sees of it, not that of the
// one point at its centre, against which every antialiased technique is wrong. An average over points within each pixel that a
// tracer answers.
#pragma once

#include <span>
#include <vector>

#include "base/glsl/same_surface.glsl"
#include "reference/cpu/embree_reference.h"
#include "scene/surface_point.h"

namespace gnomon {

// `count` points within a pixel, each as its distance from the middle, in pixels: the middles of equal squares, so that a
// picture of as many times more pixels has the same points. Throws Error (usage) where `count` is no square number.
std::vector<vec2> subpixel_places(int count);

struct PixelVisibility {
  // As for the samples of a frame. receiver: the sample's own surface receives light and at least a quarter of the points lie
  // on it.
  ReferenceResult result;
  double uncovered = 0.0;  // share of the samples that receive light, in [0, 1], without so many points: they are not judged
};

class PixelAverage {
 public:
  // What the frame's samples see, `per_pixel` of them a pixel; `receiver` as its hard reference says.
  PixelAverage(std::vector<SurfacePoint> points, std::vector<SurfaceSample> surface, std::vector<uint8_t> receiver,
               uint32_t per_pixel);

  // One more point in each pixel: what it sees, and its answer from `rays` rays. Points that do not receive light do not count:
  // shading makes them dark, not shadow.
  void add(std::span<const SurfacePoint> points, std::span<const SurfaceSample> surface, const ReferenceResult& answer,
           int rays);

  PixelVisibility finish() const;

 private:
  struct Sum {
    float visibility = 0.0f, variance = 0.0f;
    uint32_t count = 0;
  };
  std::vector<SurfacePoint> points_;
  std::vector<SurfaceSample> surface_;
  std::vector<uint8_t> receiver_;
  uint32_t per_pixel_;
  int added_ = 0;
  std::vector<Sum> sums_;  // per sample
};

}  // namespace gnomon
