// Spheres on a floor, their exact shadows and what shadow maps would make of them: the pictures of the sample report.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/maths.h"

namespace gnomon::sample {

struct Sphere {
  vec3 centre;
  float radius;
};

struct Scene {
  std::string name;
  std::vector<Sphere> spheres;
  vec3 to_light;
  int width, height;
};

struct Hit {
  vec3 position{}, normal{};
  bool found = false;
};

// The part of the light that reaches a point: of a point light; of a disc of 64 directions; through a shadow map of texels
// `texel` wide, hard and with 25 taps.
float lit(const Scene& scene, const vec3& point, const vec3& to_light);
float lit_area(const Scene& scene, const vec3& point);
float lit_map(const Scene& scene, const vec3& point, const vec3& normal, float texel, float bias, float shift_x, float shift_y);
float lit_pcf(const Scene& scene, const vec3& point, const vec3& normal, float texel);

struct Picture {
  int width, height;
  std::vector<Hit> hits;
  std::vector<float> hard, area;  // the reference

  bool is_receiver(size_t i, const vec3& to_light) const { return hits[i].found && glm::dot(hits[i].normal, to_light) > 0; }
};

Picture reference(const Scene& scene);
Image8 shaded(const Picture& picture, const Scene& scene, const std::vector<float>& mask);
Image8 grey(const Picture& picture, const std::vector<float>& mask);
// Red: false shadow; blue: false light; grey: agreement.
Image8 error_map(const Picture& picture, const Scene& scene, const std::vector<float>& mask, const std::vector<float>& truth);

}  // namespace gnomon::sample
