// Mesh tools: normals with creases, tangents, and optimise() that changes no picture.
#include "scene/mesh_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

namespace gnomon {
namespace {

// Two triangles a quad, vertices shared within the whole mesh.
MeshPart box_with_shared_corners() {
  MeshPart part;
  for (int i = 0; i < 8; ++i) part.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  part.indices = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
  return part;
}

vec3 face_normal(const MeshPart& part, size_t triangle) {
  const uint32_t* i = &part.indices[3 * triangle];
  return glm::normalize(glm::cross(part.positions[i[1]] - part.positions[i[0]], part.positions[i[2]] - part.positions[i[0]]));
}

void fill(MeshPart& part) {
  part.uvs.resize(part.positions.size(), vec2(0.0f));
  part.colours.resize(part.positions.size(), vec4(1.0f));
  if (part.normals.empty()) make_normals(part, k_pi / 4);
  if (part.tangents.empty()) make_tangents(part);
}

using Attributes = std::array<float, 16>;
using Triangle = std::array<Attributes, 3>;

Attributes attributes(const MeshPart& p, uint32_t i) {
  return {p.positions[i].x, p.positions[i].y, p.positions[i].z, p.normals[i].x,  p.normals[i].y, p.normals[i].z,
          p.tangents[i].x,  p.tangents[i].y,  p.tangents[i].z,  p.tangents[i].w, p.uvs[i].x,     p.uvs[i].y,
          p.colours[i].x,   p.colours[i].y,   p.colours[i].z,   p.colours[i].w};
}

// What a renderer sees: triangles with their attributes, whatever their order and whichever corner comes first.
std::multiset<Triangle> picture(const MeshPart& part) {
  std::multiset<Triangle> result;
  for (size_t t = 0; t < part.triangle_count(); ++t) {
    Triangle triangle;
    for (size_t k = 0; k < 3; ++k) triangle[k] = attributes(part, part.indices[3 * t + k]);
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    result.insert(triangle);
  }
  return result;
}

TEST(MakeNormals, ABoxKeepsItsEdges) {
  MeshPart part = box_with_shared_corners();
  make_normals(part, k_pi / 4);
  ASSERT_EQ(part.positions.size(), 24u);
  ASSERT_EQ(part.normals.size(), 24u);
  for (size_t t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) EXPECT_LT(glm::distance(part.normals[part.indices[3 * t + k]], face_normal(part, t)), 1e-6f);
  }
}

TEST(MakeNormals, AWideCreaseAngleSmoothsTheBox) {
  MeshPart part = box_with_shared_corners();
  make_normals(part, k_pi);
  ASSERT_EQ(part.positions.size(), 8u);
  for (size_t i = 0; i < 8; ++i) EXPECT_GT(glm::dot(part.normals[i], glm::normalize(part.positions[i])), 0.9f);
}

TEST(MakeNormals, SmoothsAcrossUvSeams) {
  // A bent strip whose middle edge is doubled, as texture seams do.
  MeshPart part;
  part.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {1, -0.0f, 0}, {1, 0, 1}, {2, -0.2f, 0}, {2, -0.2f, 1}};
  part.indices = {0, 1, 2, 2, 1, 3, 4, 5, 6, 6, 5, 7};
  make_normals(part, k_pi / 4);
  ASSERT_EQ(part.positions.size(), 8u);
  EXPECT_LT(glm::distance(part.normals[2], part.normals[4]), 1e-6f);
  EXPECT_LT(glm::distance(part.normals[3], part.normals[5]), 1e-6f);
  EXPECT_GT(part.normals[2].x, 0.05f) << "between up and the tilted half";
  EXPECT_NEAR(part.normals[0].y, 1.0f, 1e-6f);
}

TEST(MakeNormals, WeightsByArea) {
  // One vertex between a large face (normal z) and a small one tilted by 30 degrees.
  MeshPart part;
  part.positions = {{0, 0, 0}, {0, 1, 0}, {-10, 0, 0}, {0.1f * std::cos(k_pi / 6), 0, -0.1f * std::sin(k_pi / 6)}};
  part.indices = {0, 1, 2, 0, 3, 1};
  make_normals(part, k_pi / 4);
  ASSERT_EQ(part.positions.size(), 4u);
  EXPECT_NEAR(std::atan2(part.normals[0].x, part.normals[0].z), 0.01f * std::sin(k_pi / 6), 1e-3f);
}

TEST(MakeNormals, DegenerateTrianglesStillGetUnitNormals) {
  MeshPart part;
  part.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}};
  part.indices = {0, 1, 2, 3, 3, 3};
  make_normals(part, k_pi / 4);
  for (const vec3& n : part.normals) EXPECT_NEAR(glm::length(n), 1.0f, 1e-6f);
}

TEST(MakeNormals, AFanOfManyHardFacesTakesNoQuadraticTime) {
  MeshPart part;
  part.positions.emplace_back(0, 0, 0);
  constexpr uint32_t k_faces = 200000;
  for (uint32_t i = 0; i < k_faces; ++i) {
    const float a = static_cast<float>(i) * 2.4f;
    part.positions.emplace_back(std::cos(a), std::sin(a), i % 2),
        part.positions.emplace_back(std::cos(a + 1), i % 3, std::sin(a));
    part.indices.insert(part.indices.end(), {0, 2 * i + 1, 2 * i + 2});
  }
  make_normals(part, 0.01f);
  EXPECT_EQ(part.indices.size(), 3 * k_faces);
  EXPECT_GT(part.positions.size(), 2u * k_faces);
}

TEST(MakeTangents, FollowTheTexture) {
  // Picture upright on a wall that faces +z: u to the right, v downward.
  MeshPart part;
  part.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  part.normals.assign(4, vec3(0, 0, 1));
  part.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  part.indices = {0, 1, 2, 0, 2, 3};
  make_tangents(part);
  for (const vec4& t : part.tangents) {
    EXPECT_LT(glm::distance(vec3(t), vec3(1, 0, 0)), 1e-6f);
    EXPECT_EQ(t.w, 1.0f) << "cross(normal, tangent) * w is the top of the picture";
  }
  for (vec2& uv : part.uvs) uv.x = -uv.x;  // mirrored
  make_tangents(part);
  for (const vec4& t : part.tangents) {
    EXPECT_LT(glm::distance(vec3(t), vec3(-1, 0, 0)), 1e-6f);
    EXPECT_EQ(t.w, -1.0f);
  }
}

TEST(MakeTangents, DegenerateUvsGiveABasis) {
  MeshPart part = box_with_shared_corners();
  make_normals(part, k_pi / 4);
  part.uvs.assign(part.positions.size(), vec2(0.3f, 0.7f));
  make_tangents(part);
  for (size_t i = 0; i < part.positions.size(); ++i) {
    EXPECT_NEAR(glm::length(vec3(part.tangents[i])), 1.0f, 1e-5f);
    EXPECT_NEAR(glm::dot(vec3(part.tangents[i]), part.normals[i]), 0.0f, 1e-5f);
    EXPECT_EQ(std::abs(part.tangents[i].w), 1.0f);
  }
}

TEST(Optimise, MergesVerticesAndChangesNoPicture) {
  std::mt19937 random(7);
  MeshPart part;
  constexpr uint32_t k_side = 40;
  const auto height = [](uint32_t x, uint32_t y) { return 0.1f * static_cast<float>((x * 7 + y * 13) % 5); };
  std::vector<std::array<uint32_t, 2>> quads;
  for (uint32_t y = 0; y < k_side; ++y) {
    for (uint32_t x = 0; x < k_side; ++x) quads.push_back({x, y});
  }
  std::shuffle(quads.begin(), quads.end(), random);
  for (const auto& [x, y] : quads) {
    // A soup: no vertex is shared.
    for (const auto& [dx, dy] : std::vector<std::array<uint32_t, 2>>{{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}}) {
      part.indices.push_back(static_cast<uint32_t>(part.positions.size()));
      part.positions.emplace_back(x + dx, height(x + dx, y + dy), y + dy);
      part.uvs.emplace_back(static_cast<float>(x + dx) / k_side, static_cast<float>(y + dy) / k_side);
      part.normals.emplace_back(0, 1, 0);
      part.colours.emplace_back(1, x % 2, 0, 1);
    }
  }
  make_tangents(part);
  for (vec4& t : part.tangents) t = vec4(1, 0, 0, 1);
  const auto before = picture(part);
  const size_t soup = part.positions.size();
  optimise(part);
  EXPECT_EQ(picture(part), before);
  EXPECT_LT(part.positions.size(), soup / 2);
  EXPECT_EQ(part.triangle_count(), 2u * k_side * k_side);
  // Vertices are fetched in order: the first use of each vertex is the next new one.
  uint32_t seen = 0;
  for (const uint32_t i : part.indices) {
    ASSERT_LE(i, seen);
    seen = std::max(seen, i + 1);
  }
  EXPECT_EQ(seen, part.positions.size()) << "no vertex is left unused";
}

TEST(Optimise, DropsTrianglesWithoutAreaAndOnlyThose) {
  MeshPart part;
  part.positions = {{0, 0, 0},
                    {1, 0, 0},
                    {0, 1, 0},  // good
                    {1, 2, 3},
                    {2, 4, 6},
                    {3, 6, 9},  // on a line
                    {14678, 0, 9605},
                    {14678.001f, 0, 9605},
                    {14678, 0, 9605.001f},  // small and far
                    {0.1f, 0.1f, 0.1f},
                    {0.2f, 0.2f, 0.2f},
                    {0.4f, 0.4f, 0.4f},  // on the diagonal: exactly flat
                    {0, 0, 0},
                    {1e-20f, 0, 0},
                    {0, 1e-20f, 0}};  // tiny, but with area
  part.indices = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 0, 0, 1, 2, 1, 1};
  fill(part);
  optimise(part);
  EXPECT_EQ(part.triangle_count(), 3u);
}

TEST(Optimise, AreaIsDecidedExactly) {
  // b lies one float step beside the line from a to c.
  const auto kept = [](vec3 a, vec3 b, vec3 c) {
    MeshPart part;
    part.positions = {a, b, c};
    part.indices = {0, 1, 2};
    fill(part);
    optimise(part);
    return part.triangle_count();
  };
  const vec3 a(1, 1, 1), c(4097, 8193, 12289), b(2049, 4097, 6145);
  EXPECT_EQ(kept(a, b, c), 0u);
  EXPECT_EQ(kept(a, vec3(std::nextafter(b.x, 1e9f), b.y, b.z), c), 1u);
  EXPECT_EQ(kept(a, vec3(b.x, b.y, std::nextafter(b.z, 0.0f)), c), 1u);
  // Far from the origin the differences alone would not tell.
  const vec3 far_a(16777215, 1, 0), far_c(16777215, 3, 0), far_b(16777215, 2, 0);
  EXPECT_EQ(kept(far_a, far_b, far_c), 0u);
  EXPECT_EQ(kept(far_a, vec3(std::nextafter(16777215.0f, 0.0f), 2, 0), far_c), 1u);
  EXPECT_EQ(kept(far_a, vec3(16777215, 2, 1e-30f), far_c), 1u);
}

TEST(Optimise, OfNothingIsNothing) {
  MeshPart part;
  part.material = 3;
  optimise(part);
  EXPECT_TRUE(part.positions.empty());
  part.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  part.indices = {0, 1, 2};
  fill(part);
  optimise(part);
  EXPECT_TRUE(part.positions.empty());
  EXPECT_TRUE(part.indices.empty());
  EXPECT_EQ(part.material, 3);
}

TEST(Optimise, IsIdempotentAndDeterministic) {
  MeshPart a = box_with_shared_corners();
  fill(a);
  MeshPart b = a;
  optimise(a), optimise(b);
  EXPECT_EQ(a.indices, b.indices);
  EXPECT_EQ(a.positions, b.positions);
  const auto once = picture(a);
  optimise(a);
  EXPECT_EQ(picture(a), once);
}

}  // namespace
}  // namespace gnomon
