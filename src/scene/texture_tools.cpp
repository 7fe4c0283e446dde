// Pictures made from pictures, as materials of files need them.
#include "scene/texture_tools.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace gnomon {

namespace {

constexpr bool is_clear(uint8_t alpha) { return alpha < 32; }
constexpr bool is_solid(uint8_t alpha) { return alpha >= 224; }

// Where a soft edge passes: a texel that has both ends within two texels of it.
bool is_edge(const Image8& image, int x, int y) {
  constexpr int k_reach = 2;
  bool clear = false, solid = false;
  for (int v = std::max(y - k_reach, 0); v <= std::min(y + k_reach, image.height - 1); ++v) {
    for (int u = std::max(x - k_reach, 0); u <= std::min(x + k_reach, image.width - 1); ++u) {
      const uint8_t alpha = image.at(u, v)[3];
      clear |= is_clear(alpha), solid |= is_solid(alpha);
      if (clear && solid) return true;
    }
  }
  return false;
}

}  // namespace

bool has_transparency(const Image8& image) { return least_alpha(image) < 255; }

uint8_t least_alpha(const Image8& image) {
  uint8_t least = 255;
  for (size_t i = 3; i < image.rgba.size() && least > 0; i += 4) least = std::min(least, image.rgba[i]);
  return least;
}

uint8_t greatest_alpha(const Image8& image) {
  uint8_t greatest = 0;
  for (size_t i = 3; i < image.rgba.size() && greatest < 255; i += 4) greatest = std::max(greatest, image.rgba[i]);
  return greatest;
}

AlphaShares alpha_shares(const Image8& image) {
  size_t clear = 0, solid = 0, edges = 0, holes = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const uint8_t alpha = image.at(x, y)[3];
      clear += is_clear(alpha), solid += is_solid(alpha), holes += alpha < 128;
      edges += !is_clear(alpha) && !is_solid(alpha) && is_edge(image, x, y);
    }
  }
  const double count = std::max(1.0, static_cast<double>(image.rgba.size() / 4));
  AlphaShares shares;
  shares.clear = static_cast<double>(clear) / count;
  shares.solid = static_cast<double>(solid) / count;
  shares.between = std::max(0.0, 1.0 - shares.clear - shares.solid);
  shares.edges = static_cast<double>(edges) / count;
  shares.holes = static_cast<double>(holes) / count;
  return shares;
}

// Of a cut-out the texels between are its soft edges: few beside both ends together, however few the wires of a net are. Their
// values span three quarters of all, so that a ramp has that many. Where they are no edges - a blurred picture, or highlights
// of a gloss - they are held against the scarcer end, of which a ramp has six times as many.
bool is_cut_out(const AlphaShares& shares) {
  const double scarcer = std::min(shares.clear, shares.solid), smooth = shares.between - shares.edges;
  return scarcer > 0.0 && shares.between < 0.5 && smooth <= 2.0 * scarcer;
}

bool is_grey(const Image8& image) {
  for (size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != image.rgba[i + 1] || image.rgba[i] != image.rgba[i + 2]) return false;
  }
  return true;
}

void set_alpha(Image8& colour, const Image8& mask, bool inverted) {
  const bool own_alpha = has_transparency(mask);
  const auto value = [&](int x, int y) {
    const uint8_t* p = mask.at(std::clamp(x, 0, mask.width - 1), std::clamp(y, 0, mask.height - 1));
    const float opacity = own_alpha ? static_cast<float>(p[3]) : static_cast<float>(p[0] + p[1] + p[2]) / 3.0f;
    return inverted ? 255.0f - opacity : opacity;
  };
  for (int y = 0; y < colour.height; ++y) {
    const float my =
        (static_cast<float>(y) + 0.5f) * static_cast<float>(mask.height) / static_cast<float>(colour.height) - 0.5f;
    const int y0 = static_cast<int>(std::floor(my));
    for (int x = 0; x < colour.width; ++x) {
      const float mx =
          (static_cast<float>(x) + 0.5f) * static_cast<float>(mask.width) / static_cast<float>(colour.width) - 0.5f;
      const int x0 = static_cast<int>(std::floor(mx));
      const float fx = mx - static_cast<float>(x0), fy = my - static_cast<float>(y0);
      const float top = glm::mix(value(x0, y0), value(x0 + 1, y0), fx),
                  bottom = glm::mix(value(x0, y0 + 1), value(x0 + 1, y0 + 1), fx);
      colour.at(x, y)[3] = static_cast<uint8_t>(std::lround(glm::mix(top, bottom, fy)));
    }
  }
}

Image8 normal_map_from_heights(const ImageF& heights, float slope) {
  const int w = heights.width, h = heights.height;
  const auto height = [&](int x, int y) { return *heights.at((x + w) % w, (y + h) % h); };
  const auto encode = [](float n) { return static_cast<uint8_t>(std::lround((n * 0.5f + 0.5f) * 255.0f)); };
  Image8 result(w, h);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const float along_x = 0.5f * slope * (height(x + 1, y) - height(x - 1, y));
      const float upwards = 0.5f * slope * (height(x, y - 1) - height(x, y + 1));
      const vec3 n = glm::normalize(vec3(-along_x, -upwards, 1.0f));
      uint8_t* out = result.at(x, y);
      out[0] = encode(n.x), out[1] = encode(n.y), out[2] = encode(n.z), out[3] = 255;
    }
  }
  return result;
}

}  // namespace gnomon
