// Height and colour of each texel from noise; the normal map follows from the heights.
#include "scene/builtin/parts/procedural_textures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/builtin/parts/noise.h"

namespace gnomon {
namespace {

struct Texel {
  vec3 colour;   // sRGB
  float height;  // in texels of a 512 x 512 picture
};

uint8_t to_byte(float value) { return static_cast<uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f); }

void store(uint8_t* texel, const vec3& rgb, float alpha) {
  texel[0] = to_byte(rgb.x), texel[1] = to_byte(rgb.y), texel[2] = to_byte(rgb.z), texel[3] = to_byte(alpha);
}

Image8 normals_from_heights(const std::vector<float>& heights, int size) {
  Image8 image(size, size);
  const float scale = static_cast<float>(size) / 512.0f;
  const auto height = [&](int x, int y) { return heights[static_cast<size_t>((y + size) % size) * size + (x + size) % size]; };
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const float dx = 0.5f * scale * (height(x + 1, y) - height(x - 1, y)),
                  dy = 0.5f * scale * (height(x, y + 1) - height(x, y - 1));
      store(image.at(x, y), 0.5f + 0.5f * glm::normalize(vec3(-dx, dy, 1.0f)), 1.0f);  // rows run downward
    }
  }
  return image;
}

// texel(u, v): centre of a texel in the unit square.
template <class Function>
SurfaceTexture bake(int size, const Function& texel) {
  SurfaceTexture result{Image8(size, size), {}};
  std::vector<float> heights(static_cast<size_t>(size) * size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const float side = static_cast<float>(size);
      const Texel t = texel((static_cast<float>(x) + 0.5f) / side, (static_cast<float>(y) + 0.5f) / side);
      store(result.colour.at(x, y), t.colour, 1.0f);
      heights[static_cast<size_t>(y) * size + x] = t.height;
    }
  }
  result.normal = normals_from_heights(heights, size);
  return result;
}

// Blocks in courses: which block a point is in, and how far it is from the nearest joint.
struct Block {
  uint32_t id;
  float to_joint;  // in units of the picture's side
};

struct Courses {
  int rows, per_row;
  float jitter;  // of the upright joints, as a fraction of a block
  uint32_t seed;
};

Block block_at(const Courses& courses, float u, float v) {
  const float rows = static_cast<float>(courses.rows), count = static_cast<float>(courses.per_row);
  const float course = std::floor(v * rows), in_course = v * rows - course;
  const int row = ((static_cast<int>(course) % courses.rows) + courses.rows) % courses.rows;
  const float shift = unit_random(row, 0, courses.seed) + 0.5f * static_cast<float>(row % 2);
  const float along = u * count + shift;
  const auto joint = [&](int index) {  // position of the joint to the left of block `index`
    const int wrapped = ((index % courses.per_row) + courses.per_row) % courses.per_row;
    return static_cast<float>(index) + courses.jitter * (unit_random(row, wrapped, courses.seed + 1) - 0.5f);
  };
  int index = static_cast<int>(std::floor(along));
  if (along < joint(index)) --index;
  if (along >= joint(index + 1)) ++index;
  const float across = std::min(along - joint(index), joint(index + 1) - along) / count;
  const float upright = std::min(in_course, 1.0f - in_course) / rows;
  const int wrapped = ((index % courses.per_row) + courses.per_row) % courses.per_row;
  // A rounded corner: distance to the joints' corner falls off as in a circle of two joints' width.
  const float corner = 0.02f, ax = std::max(0.0f, corner - across), ay = std::max(0.0f, corner - upright);
  const float to_joint = ax > 0.0f && ay > 0.0f ? corner - std::sqrt(ax * ax + ay * ay) : std::min(across, upright);
  return {hash_cell(row, wrapped, 2, courses.seed), to_joint};
}

float centred(float value) { return 2.0f * value - 1.0f; }

// Independent numbers in [0, 1) of one block.
float trait(uint32_t id, int which) { return unit_random(static_cast<int>(id), which, 77u); }

// Stones laid in courses, with wavy joints.
struct Stonework {
  Courses courses;
  float joint, bevel;  // half width, and how far inside the stone falls to it [picture sides]
  float relief, grain;
  vec3 light, dark, joint_colour;
  float waviness;
};

Texel stonework(const Stonework& s, float u, float v) {
  const float wave_u = s.waviness * centred(tiling_fractal(u, v, ivec2(8), 3, s.courses.seed + 10));
  const float wave_v = s.waviness * centred(tiling_fractal(u, v, ivec2(8), 3, s.courses.seed + 20));
  const Block block = block_at(s.courses, u + wave_u, v + wave_v);
  const float stone = smooth_step(s.joint, s.joint + s.bevel, block.to_joint);
  const float fine = tiling_fractal(u, v, ivec2(32), 4, s.courses.seed + 30),
              coarse = tiling_fractal(u, v, ivec2(6), 4, s.courses.seed + 40);
  const float tone = std::clamp(0.55f * trait(block.id, 0) + 0.75f * (coarse - 0.35f) + 0.5f * (fine - 0.5f), 0.0f, 1.0f);
  vec3 colour = glm::mix(s.dark, s.light, tone);
  colour += vec3(0.035f, 0.0f, -0.035f) * centred(trait(block.id, 1));  // warmer and cooler stones
  colour *= 0.90f + 0.10f * smooth_step(s.joint, s.joint + 3.0f * s.bevel, block.to_joint);
  colour = glm::mix(s.joint_colour * (0.8f + 0.4f * fine), colour, stone);
  const float tilt = centred(trait(block.id, 2)) * 0.25f;
  return {colour, s.relief * stone * (1.0f + tilt) + s.grain * fine + 2.0f * s.grain * coarse};
}

}  // namespace

SurfaceTexture paving_texture(int size) {
  const Stonework style{{7, 5, 0.5f, 100},     0.0045f, 0.012f, 5.0f, 6.0f, {0.87f, 0.78f, 0.65f}, {0.59f, 0.52f, 0.43f},
                        {0.43f, 0.36f, 0.28f}, 0.008f};
  return bake(size, [&](float u, float v) { return stonework(style, u, v); });
}

SurfaceTexture masonry_texture(int size) {
  const Stonework style{{6, 3, 0.4f, 200},     0.004f, 0.010f, 6.0f, 7.0f, {0.84f, 0.72f, 0.55f}, {0.60f, 0.49f, 0.36f},
                        {0.50f, 0.42f, 0.32f}, 0.005f};
  return bake(size, [&](float u, float v) { return stonework(style, u, v); });
}

SurfaceTexture plaster_texture(int size) {
  return bake(size, [](float u, float v) -> Texel {
    const float stain = tiling_fractal(u, v, ivec2(4), 5, 300), fine = tiling_fractal(u, v, ivec2(48), 3, 310);
    const float run = tiling_fractal(u, v, {16, 4}, 3, 320);  // where rain runs down
    const float bare = smooth_step(0.62f, 0.66f, stain + 0.10f * (fine - 0.5f));
    vec3 colour = glm::mix(vec3(0.89f, 0.73f, 0.51f), vec3(0.95f, 0.84f, 0.66f), smooth_step(0.3f, 0.7f, stain));
    colour *= 0.92f + 0.10f * run + 0.10f * (fine - 0.5f);
    colour = glm::mix(colour, vec3(0.74f, 0.62f, 0.48f) * (0.85f + 0.3f * fine), bare);
    return {colour, 2.5f * (1.0f - bare) + 3.0f * fine + 6.0f * stain};
  });
}

SurfaceTexture limestone_texture(int size) {
  return bake(size, [](float u, float v) -> Texel {
    const float cloud = tiling_fractal(u, v, ivec2(3), 5, 400), fine = tiling_fractal(u, v, ivec2(40), 3, 410);
    const float pit = smooth_step(0.74f, 0.86f, tiling_fractal(u, v, ivec2(48), 2, 420));
    const vec3 colour =
        glm::mix(vec3(0.76f, 0.68f, 0.56f), vec3(0.92f, 0.86f, 0.74f), std::clamp(1.6f * cloud - 0.3f, 0.0f, 1.0f));
    return {colour * (0.95f + 0.10f * (fine - 0.5f)) * (1.0f - 0.14f * pit), 2.5f * fine - 4.0f * pit + 4.0f * cloud};
  });
}

SurfaceTexture terracotta_texture(int size) {
  return bake(size, [](float u, float v) -> Texel {
    const float cloud = tiling_fractal(u, v, ivec2(5), 5, 500), fine = tiling_fractal(u, v, ivec2(40), 3, 510);
    const vec3 colour =
        glm::mix(vec3(0.58f, 0.29f, 0.18f), vec3(0.84f, 0.53f, 0.36f), std::clamp(1.7f * cloud - 0.35f, 0.0f, 1.0f));
    return {colour * (0.90f + 0.2f * (fine - 0.4f)), 3.0f * fine + 4.0f * cloud};
  });
}

SurfaceTexture wood_texture(int size) {
  return bake(size, [](float u, float v) -> Texel {
    const float bend = tiling_fractal(u, v, ivec2(3), 3, 600);
    const float ring = 0.5f + 0.5f * static_cast<float>(sine(2.0 * k_pi * (8.0 * v + 2.0 * bend)));
    const float streak = tiling_noise(u * 8.0f, v * 128.0f, {8, 128}, 610);
    const vec3 colour =
        glm::mix(vec3(0.40f, 0.27f, 0.17f), vec3(0.68f, 0.51f, 0.34f), std::clamp(0.55f * ring + 0.45f * streak, 0.0f, 1.0f));
    return {colour, 2.0f * streak + 1.5f * ring};
  });
}

SurfaceTexture bark_texture(int size) {
  return bake(size, [](float u, float v) -> Texel {
    const float warp = 0.06f * centred(tiling_fractal(u, v, ivec2(4), 3, 700));
    const float ridge = 1.0f - std::abs(centred(tiling_fractal(u + warp, v, {12, 3}, 3, 710)));
    const float fine = tiling_fractal(u, v, ivec2(32), 3, 720);
    const float crest = smooth_step(0.55f, 1.0f, ridge);
    const vec3 colour = glm::mix(vec3(0.44f, 0.39f, 0.33f), vec3(0.25f, 0.20f, 0.16f), crest) * (0.8f + 0.4f * fine);
    return {colour, 10.0f * (1.0f - crest) + 4.0f * fine};
  });
}

SurfaceTexture soil_texture(int size) {
  return bake(size, [](float u, float v) -> Texel {
    const float cloud = tiling_fractal(u, v, ivec2(9), 5, 800), fine = tiling_fractal(u, v, ivec2(64), 3, 810);
    const float grass = smooth_step(0.36f, 0.62f, cloud + 0.25f * (fine - 0.5f));
    const vec3 earth = glm::mix(vec3(0.46f, 0.37f, 0.26f), vec3(0.62f, 0.53f, 0.40f), fine);
    const vec3 green = glm::mix(vec3(0.32f, 0.33f, 0.18f), vec3(0.56f, 0.53f, 0.31f), fine);
    return {glm::mix(earth, green, grass), 6.0f * fine + 8.0f * cloud};
  });
}

}  // namespace gnomon
