// A small ray tracer.
#include "sample_pictures.h"

#include <algorithm>
#include <cmath>

namespace gnomon::sample {
namespace {

// Distance to the sphere along the ray, or a negative number.
float intersect(const Sphere& sphere, const vec3& origin, const vec3& direction) {
  const vec3 to_centre = sphere.centre - origin;
  const float along = glm::dot(to_centre, direction);
  const float inside = sphere.radius * sphere.radius - (glm::dot(to_centre, to_centre) - along * along);
  return inside < 0 ? -1.0f : along - std::sqrt(inside);
}

Hit trace(const Scene& scene, const vec3& origin, const vec3& direction) {
  float nearest = direction.y < 0 ? -origin.y / direction.y : 1e30f;
  Hit hit{origin + direction * nearest, vec3(0, 1, 0), direction.y < 0 && nearest < 60.0f};
  for (const Sphere& sphere : scene.spheres) {
    const float distance = intersect(sphere, origin, direction);
    if (distance <= 1e-3f || distance >= nearest) continue;
    nearest = distance;
    const vec3 position = origin + direction * distance;
    hit = {position, glm::normalize(position - sphere.centre), true};
  }
  return hit;
}

uint8_t byte_of(float value) { return static_cast<uint8_t>(std::lround(255.0f * glm::clamp(value, 0.0f, 1.0f))); }

Image8 draw(const Picture& picture, const std::function<vec3(size_t)>& colour) {
  Image8 image(picture.width, picture.height);
  for (size_t i = 0; i < picture.hits.size(); ++i) {
    const vec3 c = colour(i);
    uint8_t* out = &image.rgba[4 * i];
    out[0] = byte_of(c.x), out[1] = byte_of(c.y), out[2] = byte_of(c.z), out[3] = 255;
  }
  return image;
}

float diffuse(const Picture& picture, const Scene& scene, size_t i) {
  return std::max(0.0f, glm::dot(picture.hits[i].normal, scene.to_light));
}

}  // namespace

float lit(const Scene& scene, const vec3& point, const vec3& to_light) {
  for (const Sphere& sphere : scene.spheres) {
    if (intersect(sphere, point, to_light) > 1e-3f) return 0.0f;
  }
  return 1.0f;
}

// Area light: a disc of directions, by a fixed spiral.
float lit_area(const Scene& scene, const vec3& point) {
  constexpr int k_samples = 64;
  vec3 tangent, bitangent;
  orthonormal_basis(scene.to_light, tangent, bitangent);
  float sum = 0;
  for (int i = 0; i < k_samples; ++i) {
    const float r = 0.12f * std::sqrt((static_cast<float>(i) + 0.5f) / k_samples), a = static_cast<float>(i) * 2.39996f;
    sum += lit(scene, point, glm::normalize(scene.to_light + r * (std::cos(a) * tangent + std::sin(a) * bitangent)));
  }
  return sum / k_samples;
}

// A shadow map of texels `texel` wide: the point moves to its texel's centre in the light's plane, and away by the bias.
float lit_map(const Scene& scene, const vec3& point, const vec3& normal, float texel, float bias, float shift_x,
              float shift_y) {
  vec3 u, v;
  orthonormal_basis(scene.to_light, u, v);
  const float x = glm::dot(point, u), y = glm::dot(point, v), z = glm::dot(point, scene.to_light);
  const auto snap = [&](float value, float shift) { return (std::floor(value / texel + shift) + 0.5f) * texel; };
  const vec3 moved = snap(x, shift_x) * u + snap(y, shift_y) * v + z * scene.to_light;
  return lit(scene, moved + bias * scene.to_light + 0.2f * texel * normal, scene.to_light);
}

float lit_pcf(const Scene& scene, const vec3& point, const vec3& normal, float texel) {
  float sum = 0;
  for (int i = -2; i <= 2; ++i) {
    for (int k = -2; k <= 2; ++k)
      sum += lit_map(scene, point + 0.0f, normal, texel, 2 * texel, 0.4f * static_cast<float>(i), 0.4f * static_cast<float>(k));
  }
  return sum / 25;
}

Picture reference(const Scene& scene) {
  Picture picture{scene.width, scene.height, {}, {}, {}};
  const vec3 eye(0, 3.2f, 9);
  const vec3 forward = glm::normalize(vec3(0, 0.6f, 0) - eye), right = glm::normalize(glm::cross(forward, vec3(0, 1, 0)));
  const vec3 up = glm::cross(right, forward);
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const float sx = (static_cast<float>(2 * x + 1 - scene.width)) / static_cast<float>(scene.height);
      const float sy = (static_cast<float>(scene.height - 2 * y - 1)) / static_cast<float>(scene.height);
      const Hit hit = trace(scene, eye, glm::normalize(forward + 0.5f * (sx * right + sy * up)));
      picture.hits.push_back(hit);
      const bool faces = hit.found && glm::dot(hit.normal, scene.to_light) > 0;
      picture.hard.push_back(faces ? lit(scene, hit.position + 1e-3f * hit.normal, scene.to_light) : 0.0f);
      picture.area.push_back(faces ? lit_area(scene, hit.position + 1e-3f * hit.normal) : 0.0f);
    }
  }
  return picture;
}

Image8 shaded(const Picture& picture, const Scene& scene, const std::vector<float>& mask) {
  return draw(picture, [&](size_t i) {
    if (!picture.hits[i].found) return vec3(0.66f, 0.76f, 0.86f);
    const vec3& p = picture.hits[i].position;
    const bool floor = picture.hits[i].normal.y > 0.999f && p.y < 0.01f;
    const float tile = (static_cast<int>(std::floor(p.x)) + static_cast<int>(std::floor(p.z))) % 2 == 0 ? 0.82f : 0.74f;
    const vec3 albedo = floor ? vec3(tile, tile * 0.97f, tile * 0.9f) : vec3(0.86f, 0.62f, 0.42f);
    return albedo * (0.22f + 0.86f * mask[i] * diffuse(picture, scene, i));
  });
}

Image8 grey(const Picture& picture, const std::vector<float>& mask) {
  return draw(picture, [&](size_t i) { return vec3(mask[i]); });
}

Image8 error_map(const Picture& picture, const Scene& scene, const std::vector<float>& mask, const std::vector<float>& truth) {
  return draw(picture, [&](size_t i) {
    const float base = 0.3f + 0.45f * truth[i] * diffuse(picture, scene, i), error = mask[i] - truth[i];
    const vec3 towards = error < 0 ? vec3(0.9f, 0.1f, 0.08f) : vec3(0.1f, 0.35f, 0.95f);
    return glm::mix(vec3(base), towards, std::min(1.0f, std::abs(error) * 1.2f));
  });
}

}  // namespace gnomon::sample
