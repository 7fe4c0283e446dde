// Textures whose alpha is a shape: twigs and wrought iron.
#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/procedural_textures.h"

namespace gnomon {
namespace {

uint8_t to_byte(float value) { return static_cast<uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f); }

void store(uint8_t* texel, const vec3& rgb, float alpha) {
  texel[0] = to_byte(rgb.x), texel[1] = to_byte(rgb.y), texel[2] = to_byte(rgb.z), texel[3] = to_byte(alpha);
}

// --- twigs: y runs upward from the stem's foot ---

struct Leaf {
  vec2 root, along;  // unit
  float length, width;
  vec3 colour;
};

std::vector<Leaf> leaves_of(const TwigStyle& style) {
  Random random(style.seed);
  std::vector<Leaf> leaves;
  const int pairs = style.leaf_pairs;
  for (int i = 0; i < 2 * pairs + 1; ++i) {
    const float height = 0.08f + 0.70f * static_cast<float>(i / 2) / static_cast<float>(pairs);
    const float side = i == 2 * pairs ? 0.0f : i % 2 == 0 ? -1.0f : 1.0f;
    const float lean = side * style.spread * random.range(0.75f, 1.15f), angle = lean + random.range(-0.12f, 0.12f);
    const glm::dvec2 turn = unit_circle(angle);
    const float size = random.range(0.8f, 1.1f) * (1.0f - 0.35f * height);
    leaves.push_back({{0.5f, height + random.range(-0.02f, 0.02f)},
                      vec2(float(turn.y), float(turn.x)),
                      style.leaf_length * size,
                      style.leaf_width * size,
                      style.colour + style.colour_variation * random.range(-1.0f, 1.0f)});
  }
  return leaves;
}

// Where across the leaf a point is: 0 on the midrib, 1 on the rim, more outside.
float across_leaf(const Leaf& leaf, const vec2& point) {
  const vec2 offset = point - leaf.root;
  const float t = glm::dot(offset, leaf.along) / leaf.length;
  if (t <= 0.0f || t >= 1.0f) return 2.0f;
  const float half_width = 0.5f * leaf.width * std::sqrt(4.0f * t * (1.0f - t)) * (1.15f - 0.35f * t);
  return std::abs(offset.x * leaf.along.y - offset.y * leaf.along.x) / half_width;
}

struct Coverage {
  vec3 colour = vec3(0.0f);
  float weight = 0.0f;
};

void add_twig_sample(Coverage& coverage, const std::vector<Leaf>& leaves, const vec2& point) {
  for (auto leaf = leaves.rbegin(); leaf != leaves.rend(); ++leaf) {  // upper leaves cover lower ones
    const float across = across_leaf(*leaf, point);
    if (across > 1.0f) continue;
    coverage.colour += leaf->colour * (across < 0.12f ? 1.18f : 1.0f - 0.15f * across);
    coverage.weight += 1.0f;
    return;
  }
  const bool on_stem = std::abs(point.x - 0.5f) < 0.010f && point.y < 0.8f;
  if (on_stem) coverage.colour += vec3(0.34f, 0.28f, 0.18f), coverage.weight += 1.0f;
}

// --- iron: metres, y upward, for a panel of 1.6 x 1.6 m ---

constexpr float k_panel = 1.6f;

bool in_ring(const vec2& point, const vec2& centre, float radius, float half_width) {
  return std::abs(glm::length(point - centre) - radius) < half_width;
}

// Bars every 0.2 m, rails at three heights, rings between the upper two, a spear point on each bar.
bool is_iron(const vec2& point) {
  constexpr float k_spacing = 0.2f;
  const float cell = std::floor(point.x / k_spacing), x = point.x - (cell + 0.5f) * k_spacing;  // from the nearest bar
  const float y = point.y;
  if (std::abs(x) < 0.010f && y < 1.38f) return true;
  for (const float rail : {0.10f, 1.02f, 1.24f}) {
    if (std::abs(y - rail) < 0.014f) return true;
  }
  if (y > 1.34f && y < 1.54f && std::abs(x) < 0.036f * std::min((y - 1.34f) / 0.05f, (1.54f - y) / 0.15f)) return true;
  const float to_gap = std::abs(x) - 0.5f * k_spacing;  // rings sit between bars
  if (in_ring({to_gap, y}, {0.0f, 1.13f}, 0.080f, 0.009f)) return true;
  // A pair of scrolls at the foot of each second bar.
  const bool scrolled = static_cast<int>(cell) % 2 == 0;
  return scrolled && (in_ring({std::abs(x), y}, {0.046f, 0.17f}, 0.038f, 0.008f) ||
                      in_ring({std::abs(x), y}, {0.036f, 0.243f}, 0.028f, 0.007f));
}

// Share of a texel that the shape covers, from 4 x 4 points.
template <class Inside>
float coverage_of(int x, int y, int size, const Inside& inside) {
  int hits = 0;
  for (int s = 0; s < 16; ++s) {
    const float px = (static_cast<float>(x) + (static_cast<float>(s % 4) + 0.5f) / 4.0f) / static_cast<float>(size);
    const float py = (static_cast<float>(y) + (static_cast<float>(s / 4) + 0.5f) / 4.0f) / static_cast<float>(size);
    hits += inside(vec2(px, 1.0f - py)) ? 1 : 0;
  }
  return static_cast<float>(hits) / 16.0f;
}

}  // namespace

Image8 twig_texture(int size, const TwigStyle& style) {
  const std::vector<Leaf> leaves = leaves_of(style);
  Image8 image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      Coverage coverage;
      const float alpha = coverage_of(x, y, size, [&](const vec2& point) {
        const float before = coverage.weight;
        add_twig_sample(coverage, leaves, point);
        return coverage.weight > before;
      });
      store(image.at(x, y), coverage.weight > 0.0f ? coverage.colour / coverage.weight : style.colour, alpha);
    }
  }
  return image;
}

Image8 iron_panel_texture(int size) {
  Image8 image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size),
                  v = (static_cast<float>(y) + 0.5f) / static_cast<float>(size);
      const float rust = smooth_step(0.52f, 0.70f, tiling_fractal(u, v, ivec2(12), 4, 900));
      const vec3 colour = glm::mix(vec3(0.17f, 0.16f, 0.16f), vec3(0.36f, 0.21f, 0.13f), rust);
      store(image.at(x, y), colour, coverage_of(x, y, size, [](const vec2& point) { return is_iron(point * k_panel); }));
    }
  }
  return image;
}

}  // namespace gnomon
