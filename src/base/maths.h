// Vectors, matrices and boxes. Matrices read clip_from_world: the space on the right goes in, the one on the left comes out.
#pragma once

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#define GLM_FORCE_XYZW_ONLY
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

namespace gnomon {

using glm::ivec2;
using glm::mat3;
using glm::mat4;
using glm::uvec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr float k_pi = 3.14159265358979323846f;

// Axis-aligned box; empty until something is added.
struct Box {
  vec3 min = vec3(std::numeric_limits<float>::max());
  vec3 max = vec3(std::numeric_limits<float>::lowest());

  bool empty() const { return min.x > max.x; }
  void add(const vec3& point) { min = glm::min(min, point), max = glm::max(max, point); }
  void add(const Box& other) { min = glm::min(min, other.min), max = glm::max(max, other.max); }
  vec3 centre() const { return 0.5f * (min + max); }
  vec3 extent() const { return empty() ? vec3(0.0f) : max - min; }
  float radius() const { return 0.5f * glm::length(extent()); }  // of the sphere around the box
  // Corner 0 to 7: bit 0 selects x, bit 1 y, bit 2 z.
  vec3 corner(int index) const { return {index & 1 ? max.x : min.x, index & 2 ? max.y : min.y, index & 4 ? max.z : min.z}; }
};

// The box around the transformed box (Arvo 1990).
inline Box transformed(const mat4& to_from, const Box& box) {
  Box result;
  if (box.empty()) return result;
  const vec3 centre = vec3(to_from * vec4(box.centre(), 1.0f)), half = 0.5f * box.extent();
  const mat3 m(to_from);
  const vec3 reach = glm::abs(m[0]) * half.x + glm::abs(m[1]) * half.y + glm::abs(m[2]) * half.z;
  result.min = centre - reach, result.max = centre + reach;
  return result;
}

// False for transforms that flatten: neither normals nor ray directions survive those, so tracers bake them into vertices.
inline bool invertible(const mat4& transform) {
  const mat3 m(transform);
  return glm::abs(glm::determinant(m)) > 1.0e-6f * glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
}

// Any two unit vectors that make a right-handed basis with the unit vector n (Duff et al. 2017, JCGT 6(1)).
inline void orthonormal_basis(const vec3& n, vec3& tangent, vec3& bitangent) {
  const float sign = n.z >= 0.0f ? 1.0f : -1.0f;
  const float a = -1.0f / (sign + n.z), b = n.x * n.y * a;
  tangent = vec3(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x);
  bitangent = vec3(b, sign + n.y * n.y * a, -n.y);
}

}  // namespace gnomon
