// What filterable maps store, texel by texel, against the same computed in doubles; and what theory says about their bounds.
#include <cmath>
#include <cstring>
#include <random>

#include "base/params.h"
#include "frame/casters/caster_draws.h"
#include "shadow/map/filter/evsm/evsm_warp.glsl"
#include "shadow/map/filter/msm/msm_moments.glsl"
#include "shadow/map/glsl/chebyshev.glsl"
#include "shadow/registry.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::device;
using test::View;

// A depth map whose depth is linear, of 10 m.
struct DepthMap {
  uint32_t size = 0;
  std::vector<float> texels;
  float at(int x, int y) const {
    const int last = static_cast<int>(size) - 1;
    return texels[static_cast<size_t>(std::clamp(y, 0, last)) * size + static_cast<size_t>(std::clamp(x, 0, last))];
  }
};

DepthMap random_map(uint32_t size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  DepthMap map = {size, std::vector<float>(size * size)};
  for (float& texel : map.texels) texel = uniform(random);
  // Both ends, and a region without variance.
  map.texels[0] = 0.0f, map.texels[1] = 1.0f;
  for (uint32_t y = 0; y < size / 4; ++y) std::fill_n(&map.texels[(size / 2 + y) * size], size / 2, 1.0f);
  return map;
}

template <class Info>
const Info& by_id(std::span<const Info> infos, std::string_view id) {
  for (const Info& info : infos) {
    if (info.id == id) return info;
  }
  fail("no {}", id);
}

void copy_image(Commands& commands, const Image& image, const Buffer& buffer, bool to_image) {
  VkBufferImageCopy region = {};
  region.imageSubresource = {image.aspect(), 0, 0, 1};
  region.imageExtent = {image.info().width, image.info().height, 1};
  if (to_image)
    vkCmdCopyBufferToImage(commands.handle(), buffer.handle(), image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                           &region);
  else
    vkCmdCopyImageToBuffer(commands.handle(), image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.handle(), 1,
                           &region);
}

// What the filter makes of a depth map: its image, `words` 32-bit words for each texel.
template <class Word>
std::vector<Word> converted(std::string_view id, const DepthMap& map, uint32_t words,
                            std::initializer_list<std::pair<std::string_view, double>> settings) {
  // Images of the last call leave the bindless set: validation takes every descriptor of an array for used.
  device().wait_idle();
  const FilterInfo& info = by_id(filters(), id);
  ParamBlock block(info.params);
  for (const auto& [name, value] : settings) block.set_number(name, value, name);
  const auto filter = info.make(block);
  filter->prepare(device(), {std::string(id), map.size, 1});

  ImageInfo depth_info;
  depth_info.name = "depth";
  depth_info.width = depth_info.height = map.size;
  depth_info.array = true;
  depth_info.format = VK_FORMAT_D32_SFLOAT;
  depth_info.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  const Image depth(device(), depth_info);
  const size_t count = map.texels.size();
  const Buffer source(device(), "depths", count * 4, BufferMemory::upload), result(device(), "texels", count * words * 4);
  std::memcpy(source.mapped(), map.texels.data(), count * 4);
  source.flush();
  const Buffer views(device(), "views", sizeof(ShadowMapData) + sizeof(ShadowView), BufferMemory::upload);
  ShadowView view = {};
  view.raster.in_use = 1;
  view.linear_numerator = vec4(0, 0, 1, 0), view.linear_denominator = vec4(0, 0, 0, 1);
  view.depth_range_m = 10.0f, view.size = static_cast<float>(map.size);
  std::memcpy(views.mapped() + sizeof(ShadowMapData), &view, sizeof view);
  views.flush();
  const Buffer params(device(), "parameters", block.words().size_bytes() + 4, BufferMemory::upload);
  std::memcpy(params.mapped(), block.words().data(), block.words().size_bytes());
  params.flush();

  const DrawnMap drawn = {depth, nullptr, views, params.address()};
  test::run_passes([&](Recorder& recorder) {
    recorder.pass("upload", PassStage::other, {{source, Use::copy_read}, {depth, Use::copy_write}},
                  [&](Commands& commands) { copy_image(commands, depth, source, true); });
    filter->record(recorder, drawn);
    const Image& image = filter->map(drawn);
    recorder.pass("read back", PassStage::other, {{image, Use::copy_read}, {result, Use::copy_write}},
                  [&](Commands& commands) { copy_image(commands, image, result, false); });
  });
  return read_back_as<Word>(device(), result, count * words);
}

// Weights of the Gaussian: the middle of a row of Pascal's triangle.
std::vector<double> weights_of(int radius) {
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i)
    weights.push_back(
        std::exp(std::lgamma(6 * radius + 1) - std::lgamma(3 * radius + i + 1) - std::lgamma(3 * radius - i + 1)));
  for (const double w : weights) sum += w;
  for (double& w : weights) w /= sum;
  return weights;
}

// The mean of value(depth) around a texel.
template <class Value>
double blurred(const DepthMap& map, int x, int y, int radius, const std::vector<double>& weights, const Value& value) {
  double sum = 0.0;
  for (int j = -radius; j <= radius; ++j) {
    for (int i = -radius; i <= radius; ++i) {
      sum += weights[static_cast<size_t>(i + radius)] * weights[static_cast<size_t>(j + radius)] *
             value(double(map.at(x + i, y + j)));
    }
  }
  return sum;
}

using Values = std::vector<std::function<double(double)>>;

// `found` against the blurred values, in each row_step-th row; relative to `scale` where that is larger than the value.
void expect_blurred(const DepthMap& map, const std::vector<float>& found, int radius, const Values& values, double tolerance,
                    double scale = 1.0, int row_step = 1) {
  const auto weights = weights_of(radius);
  double worst = 0.0;
  for (size_t i = 0; i < map.texels.size(); ++i) {
    const int x = static_cast<int>(i % map.size), y = static_cast<int>(i / map.size);
    if (y % row_step != 0) continue;
    for (size_t channel = 0; channel < values.size(); ++channel) {
      const double expected = blurred(map, x, y, radius, weights, values[channel]);
      worst = std::max(worst,
                       std::abs(double(found[i * values.size() + channel]) - expected) / std::max(std::abs(expected), scale));
    }
  }
  EXPECT_LT(worst, tolerance) << "size " << map.size << ", radius " << radius;
}

constexpr uint32_t k_size = 67;  // no multiple of a tile

TEST(MomentIdentity, MapsHoldTheBlurOfWhatTheyEncodeAndWithoutBlurTheEncodedItself) {
  const DepthMap map = random_map(k_size);
  for (const int radius : {0, 2, 7, 10}) {
    const double blur = radius;
    expect_blurred(map, converted<float>("vsm", map, 2, {{"blur", blur}, {"slope_term", 0.0}, {"mips", 0.0}}), radius,
                   {[](double z) { return z; }, [](double z) { return z * z; }}, 1e-6);
    expect_blurred(map, converted<float>("msm", map, 4, {{"blur", blur}, {"format", 1.0}}), radius,
                   {[](double z) { return 2 * z - 1; }, [](double z) { return std::pow(2 * z - 1, 2); },
                    [](double z) { return std::pow(2 * z - 1, 3); }, [](double z) { return std::pow(2 * z - 1, 4); }},
                   2e-6);
    // exp of a float is right to a few units of its last place times the exponent.
    expect_blurred(
        map, converted<float>("evsm", map, 4, {{"blur", blur}, {"positive", 42.0}, {"negative", 20.0}}), radius,
        {[](double z) { return std::exp(42 * (2 * z - 1)); }, [](double z) { return std::exp(84 * (2 * z - 1)); },
         [](double z) { return -std::exp(-20 * (2 * z - 1)); }, [](double z) { return std::exp(-40 * (2 * z - 1)); }},
        5e-5, 0.0);
    for (const double c : {1.0, 80.0, 160.0}) {
      for (const bool exponential : {false, true}) {
        auto found =
            converted<float>("esm", map, 1, {{"unit", 0.0}, {"blur", blur}, {"c", c}, {"space", exponential ? 1.0 : 0.0}});
        const auto weights = weights_of(radius);
        double worst = 0.0;
        for (size_t i = 0; i < found.size(); ++i) {
          const double expected = blurred(map, static_cast<int>(i % k_size), static_cast<int>(i / k_size), radius, weights,
                                          [=](double z) { return std::exp(c * (z - 0.5)); });
          worst = std::max(worst, std::abs((exponential ? std::log(double(found[i])) : double(found[i])) - std::log(expected)));
        }
        EXPECT_LT(worst, 1e-4) << "esm, c " << c << ", radius " << radius << (exponential ? ", exponential" : ", log");
      }
    }
  }
}

// Maps wider than what one group of threads converts. From blur 8 on threads share texels on every device, as GPUs always do: a
// group then writes 106 to 110 columns. With less a CPU's writes 512. Strips are 34 and 64 rows long: the rows compared meet
// each place in one.
TEST(MomentIdentity, GroupsOfThreadsMeetWithoutASeam) {
  constexpr int k_rows = 7;
  const Values vsm = {[](double z) { return z; }, [](double z) { return z * z; }};
  const Values msm = {[](double z) { return 2 * z - 1; }, [](double z) { return std::pow(2 * z - 1, 2); },
                      [](double z) { return std::pow(2 * z - 1, 3); }, [](double z) { return std::pow(2 * z - 1, 4); }};
  const Values evsm = {[](double z) { return std::exp(42 * (2 * z - 1)); }, [](double z) { return std::exp(84 * (2 * z - 1)); },
                       [](double z) { return -std::exp(-20 * (2 * z - 1)); },
                       [](double z) { return std::exp(-40 * (2 * z - 1)); }};
  const DepthMap map = random_map(300), wide = random_map(600);
  for (const int radius : {8, 10}) {
    const double blur = radius;
    expect_blurred(map, converted<float>("vsm", map, 2, {{"blur", blur}, {"slope_term", 0.0}, {"mips", 0.0}}), radius, vsm,
                   1e-6, 1.0, k_rows);
    expect_blurred(map, converted<float>("msm", map, 4, {{"blur", blur}, {"format", 1.0}}), radius, msm, 2e-6, 1.0, k_rows);
    expect_blurred(map, converted<float>("evsm", map, 4, {{"blur", blur}, {"positive", 42.0}, {"negative", 20.0}}), radius,
                   evsm, 5e-5, 0.0, k_rows);
    auto esm = converted<float>("esm", map, 1, {{"unit", 0.0}, {"blur", blur}, {"c", 80.0}, {"space", 0.0}});
    for (float& texel : esm) texel = std::exp(texel);
    // An error of 1e-4 in the logarithm, as above.
    expect_blurred(map, esm, radius, {[](double z) { return std::exp(80.0 * (z - 0.5)); }}, 1e-4, 0.0, k_rows);
  }
  expect_blurred(wide, converted<float>("vsm", wide, 2, {{"blur", 2.0}, {"slope_term", 0.0}, {"mips", 0.0}}), 2, vsm, 1e-6, 1.0,
                 k_rows);
}

// The slope that vsm adds reads neighbours, which at the ends of a shared row nobody has encoded. In a map that repeats
// itself a texel is what it is a period later, wherever groups and strips meet.
TEST(MomentIdentity, SlopesMeetWithoutASeam) {
  constexpr int k_period = 50;
  const DepthMap pattern = random_map(k_period);
  for (const uint32_t size : {300u, 600u}) {
    DepthMap map = {size, std::vector<float>(size * size)};
    for (size_t i = 0; i < map.texels.size(); ++i) {
      map.texels[i] = pattern.at(static_cast<int>(i % size) % k_period, static_cast<int>(i / size) % k_period);
    }
    for (const int radius : size == 300 ? std::vector<int>{8, 10} : std::vector<int>{2}) {
      const auto found = converted<float>("vsm", map, 2, {{"blur", radius}, {"slope_term", 1.0}, {"mips", 0.0}});
      const auto flat = converted<float>("vsm", map, 2, {{"blur", radius}, {"slope_term", 0.0}, {"mips", 0.0}});
      double worst = 0.0, most_slope = 0.0;
      // The map's own edge cuts windows off.
      for (int y = radius + 2; y < int(size) - k_period - radius - 2; ++y) {
        for (int x = radius + 2; x < int(size) - k_period - radius - 2; ++x) {
          for (int channel = 0; channel < 2; ++channel) {
            const auto at = [&](int u, int v) { return double(found[size_t(2 * (v * int(size) + u) + channel)]); };
            worst = std::max({worst, std::abs(at(x, y) - at(x + k_period, y)), std::abs(at(x, y) - at(x, y + k_period))});
          }
          const auto square = size_t(2 * (y * int(size) + x) + 1);
          most_slope = std::max(most_slope, double(found[square]) - double(flat[square]));
        }
      }
      EXPECT_GT(most_slope, 1e-3) << "the slope must be seen at all";
      EXPECT_LT(worst, 1e-6) << "size " << size << ", radius " << radius;
    }
  }
}

// Within one texel a plane's depth varies by a quarter of its squared slopes (Lauritzen, GPU Gems 3, 2007, chapter 8).
TEST(MomentIdentity, APlaneHasTheVarianceOfItsSlope) {
  constexpr uint32_t k_side = 64;
  constexpr double k_across = 0.004, k_down = -0.003;  // a texel
  DepthMap map = {k_side, std::vector<float>(k_side * k_side)};
  for (uint32_t y = 0; y < k_side; ++y) {
    for (uint32_t x = 0; x < k_side; ++x) map.texels[y * k_side + x] = static_cast<float>(0.5 + k_across * x + k_down * y);
  }
  const auto found = converted<float>("vsm", map, 2, {{"blur", 0}, {"slope_term", 1.0}, {"mips", 0.0}});
  for (uint32_t y = 2; y < k_side - 2; ++y) {
    for (uint32_t x = 2; x < k_side - 2; ++x) {
      const double depth = found[2 * (y * k_side + x)], square = found[2 * (y * k_side + x) + 1];
      ASSERT_NEAR(square - depth * depth, 0.25 * (k_across * k_across + k_down * k_down), 3e-7) << x << ", " << y;
    }
  }
}

TEST(MomentIdentity, LogSpaceBlurHoldsForExponentsThatNoFloatHolds) {
  const DepthMap map = random_map(k_size);
  const auto found = converted<float>("esm", map, 1, {{"unit", 0.0}, {"blur", 2.0}, {"c", 5000.0}});
  const auto weights = weights_of(2);
  double worst = 0.0;
  for (size_t i = 0; i < found.size(); ++i) {
    const int x = static_cast<int>(i % k_size), y = static_cast<int>(i / k_size);
    double most = 0.0;
    for (int k = 0; k < 25; ++k) most = std::max(most, double(map.at(x + k % 5 - 2, y + k / 5 - 2)));
    const double mean = blurred(map, x, y, 2, weights, [=](double z) { return std::exp(5000.0 * (z - most)); });
    worst = std::max(worst, std::abs(double(found[i]) - (5000.0 * (most - 0.5) + std::log(mean))));
  }
  EXPECT_LT(worst, 0.01);
}

TEST(MomentIdentity, PrefilteredEsmIsTheMeanOfFourExponentials) {
  const DepthMap map = random_map(k_size);
  const auto found = converted<float>("esm", map, 1, {{"unit", 0.0}, {"blur", 0.0}, {"prefilter", 1.0}, {"c", 80.0}});
  double worst = 0.0;
  for (size_t i = 0; i < found.size(); ++i) {
    const int x = static_cast<int>(i % k_size), y = static_cast<int>(i / k_size);
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) sum += 0.25 * std::exp(80.0 * (double(map.at(x + k % 2, y + k / 2)) - 0.5));
    worst = std::max(worst, std::abs(double(found[i]) - std::log(sum)));
  }
  EXPECT_LT(worst, 1e-4);
}

TEST(MomentIdentity, QuantizedMomentsAreTheMomentsToSixteenBits) {
  const DepthMap map = random_map(k_size);
  const auto words = converted<uint32_t>("msm", map, 2, {{"blur", 2.0}, {"format", 0.0}});
  const auto exact = converted<float>("msm", map, 4, {{"blur", 2.0}, {"format", 1.0}});
  float worst = 0.0f;
  for (size_t i = 0; i < map.texels.size(); ++i) {
    vec4 q;
    for (int k = 0; k < 4; ++k)
      q[k] = static_cast<float>((words[2 * i + size_t(k) / 2] >> (16 * (k % 2))) & 0xffffu) / 65535.0f;
    const vec4 b = msm_unquantized(q);
    for (int k = 0; k < 4; ++k) worst = std::max(worst, std::abs(b[k] - exact[4 * i + size_t(k)]));
  }
  // Half a step of each, through the rows of the inverse transform.
  EXPECT_LT(worst, 0.5f / 65535.0f * 2.2f);
}

// As savsm_fixed.glsl says, in other words: 64-bit integers, and a division.
std::pair<uint64_t, uint64_t> fixed_of(float z, int bits) {
  const uint64_t one = uint64_t(1) << bits;
  const auto depth = std::min(static_cast<uint64_t>(z * static_cast<float>(one) + 0.5f), one - 1);
  const int64_t from_middle = static_cast<int64_t>(2 * depth) - static_cast<int64_t>(one);
  return {depth, std::min(static_cast<uint64_t>(from_middle * from_middle) / one, one - 1)};
}

TEST(MomentIdentity, SummedAreaAveragesAreTheDirectAverages) {
  std::mt19937 random(3);
  for (const uint32_t size : {16u, 67u, 1100u}) {
    const DepthMap map = random_map(size);
    for (const double width : {1.0, 5.0, 14.0, 64.0}) {
      const auto table = converted<uint32_t>("savsm", map, 2, {{"width", width}});
      const auto side = static_cast<uint32_t>(width) + 2;
      const int bits = 32 - static_cast<int>(std::ceil(std::log2(double(side) * side)));
      const auto sum_before = [&](uint32_t x, uint32_t y, uint32_t channel) {
        return x && y ? table[2 * ((y - 1) * size + x - 1) + channel] : 0u;
      };
      size_t wrong = 0;
      for (int trial = 0; trial < 2000; ++trial) {
        const uint32_t w = 1 + static_cast<uint32_t>(random()) % std::min(side, size),
                       h = 1 + static_cast<uint32_t>(random()) % std::min(side, size);
        const uint32_t x = static_cast<uint32_t>(random()) % (size - w + 1),
                       y = static_cast<uint32_t>(random()) % (size - h + 1);
        uint64_t sums[2] = {};
        for (uint32_t j = 0; j < h; ++j) {
          for (uint32_t i = 0; i < w; ++i) {
            const auto [depth, square] = fixed_of(map.texels[(y + j) * size + x + i], bits);
            sums[0] += depth, sums[1] += square;
          }
        }
        for (uint32_t channel = 0; channel < 2; ++channel) {
          const uint32_t found = sum_before(x + w, y + h, channel) - sum_before(x, y + h, channel) -
                                 sum_before(x + w, y, channel) + sum_before(x, y, channel);
          wrong += found != sums[channel];
        }
      }
      EXPECT_EQ(wrong, 0u) << "size " << size << ", width " << width;
    }
  }
}

// Depths of the courtyard as its sun sees them.
DepthMap courtyard_map(uint32_t size) {
  View& view = test::kept_view("courtyard", [] { return load_scene("courtyard"); }, {160, 120});
  view.draw();
  const ProjectionInfo& info = by_id(projections(), "single");
  ParamBlock block(info.params);
  block.set_number("size", size, "size");
  const auto views = info.make(block)->views(view.frame(), view.scene().lights[0]);
  const Buffer light(device(), "view", sizeof(ShadowView), BufferMemory::upload), result(device(), "depths", size * size * 4);
  std::memcpy(light.mapped(), &views[0], sizeof(ShadowView));
  light.flush();
  ImageInfo image;
  image.name = "map";
  image.width = image.height = size;
  image.array = true;
  image.format = VK_FORMAT_D32_SFLOAT;
  image.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  const Image depth(device(), image);
  CasterDraws draws(device(), view.gpu_scene(), "light", {});
  test::run_passes([&](Recorder& recorder) {
    draws.record(recorder, "light", {&light, 0, sizeof(ShadowView), 1}, CasterCulling::clusters, false, depth);
    recorder.pass("copy", PassStage::other, {{depth, Use::copy_read}, {result, Use::copy_write}},
                  [&](Commands& commands) { copy_image(commands, depth, result, false); });
  });
  return {size, read_back_as<float>(device(), result, size * size)};
}

// Upper bounds of light may not lie below the weighted share of texels that are lit, for any receiver over any texel.
TEST(MomentIdentity, BoundsHoldAgainstBruteForceOverTheSameWindow) {
  const DepthMap map = courtyard_map(160);
  constexpr int radius = 2;
  const auto weights = weights_of(radius);
  const auto vsm = converted<float>("vsm", map, 2, {{"blur", radius}, {"slope_term", 0.0}, {"mips", 0.0}});
  const auto evsm = converted<float>("evsm", map, 4, {{"blur", radius}});
  const auto msm = converted<float>("msm", map, 4, {{"blur", radius}, {"format", 1.0}});
  const auto log_esm = converted<float>("esm", map, 1, {{"unit", 0.0}, {"blur", radius}, {"c", 80.0}});
  const vec2 exponents(40.0f, 5.0f);
  double worst[4] = {}, excess[4] = {};
  size_t count = 0;
  for (size_t i = 0; i < map.texels.size(); ++i) {
    const int x = static_cast<int>(i % map.size), y = static_cast<int>(i / map.size);
    for (int k = 0; k < 25; ++k) {
      // Receivers just before and just behind each depth of the window.
      for (const float side : {-1e-3f, 1e-3f}) {
        const float d = std::clamp(map.at(x + k % 5 - 2, y + k / 5 - 2) + side, 0.0f, 1.0f);
        const double pcf = blurred(map, x, y, radius, weights, [&](double z) { return z >= double(d) ? 1.0 : 0.0; });
        const vec2 w = evsm_warp(d, exponents);
        const double bounds[4] = {
            double(chebyshev(vsm[2 * i], vsm[2 * i + 1], d, 1e-12f)),
            double(std::min(evsm_bound(evsm[4 * i], evsm[4 * i + 1], w.x, exponents.x, 1e-4f),
                            evsm_bound(evsm[4 * i + 2], evsm[4 * i + 3], w.y, exponents.y, 1e-4f))),
            double(1.0f - msm_shadow(vec4(msm[4 * i], msm[4 * i + 1], msm[4 * i + 2], msm[4 * i + 3]), 2.0f * d - 1.0f, 3e-7f)),
            std::exp(std::min(double(log_esm[i]) - 80.0 * (double(d) - 0.5), 0.0))};
        for (int b = 0; b < 4; ++b) worst[b] = std::max(worst[b], pcf - bounds[b]), excess[b] += bounds[b] - pcf;
        ++count;
      }
    }
  }
  constexpr const char* k_names[] = {"vsm", "evsm", "msm", "esm"};
  // Rounding of the moments against a gap of 1e-3: (1e-7 / 1e-3) for one, squared gaps for the others.
  constexpr double k_tolerance[] = {0.05, 0.02, 0.05, 1e-4};
  for (int b = 0; b < 4; ++b) {
    fmt::print("{:>4}: below brute force by at most {:.5f}; above it by {:.4f} on average\n", k_names[b], worst[b],
               excess[b] / static_cast<double>(count));
    EXPECT_LT(worst[b], k_tolerance[b]) << k_names[b];
  }
  // The point of each successor.
  EXPECT_LT(excess[1], excess[0]);
  EXPECT_LT(excess[2], excess[0]);
}

// Moments of n random depths, in doubles.
struct Sample {
  std::vector<double> depths, weights;
  vec4 moments = vec4(0.0f);
  double shadow(double z) const {
    double sum = 0.0;
    for (size_t i = 0; i < depths.size(); ++i) sum += depths[i] < z ? weights[i] : 0.0;
    return sum;
  }
};

Sample random_sample(std::mt19937& random, int n) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Sample sample;
  double total = 0.0;
  for (int i = 0; i < n; ++i)
    sample.depths.push_back(2.0 * uniform(random) - 1.0), sample.weights.push_back(0.05 + uniform(random)),
        total += sample.weights.back();
  for (int m = 0; m < 4; ++m) {
    double sum = 0.0;
    for (size_t i = 0; i < sample.depths.size(); ++i) sum += sample.weights[i] / total * std::pow(sample.depths[i], m + 1);
    sample.moments[m] = static_cast<float>(sum);
  }
  for (double& w : sample.weights) w /= total;
  return sample;
}

TEST(MomentIdentity, FourMomentsOfTwoDepthsAreExact) {
  std::mt19937 random(11);
  double worst = 0.0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Sample sample = random_sample(random, 2);
    const double low = std::min(sample.depths[0], sample.depths[1]), high = std::max(sample.depths[0], sample.depths[1]);
    if (high - low < 0.5) continue;
    for (const double z : {low - 0.2, 0.5 * (low + high), high + 0.2}) {
      worst = std::max(worst, std::abs(double(msm_shadow(sample.moments, static_cast<float>(z), 3e-7f)) - sample.shadow(z)));
    }
  }
  fmt::print("msm, two depths, off by at most {:.5f}\n", worst);
  EXPECT_LT(worst, 0.02);
}

TEST(MomentIdentity, FourMomentsBoundTheShadowFromBelow) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  double worst = 0.0;
  for (int trial = 0; trial < 50000; ++trial) {
    const Sample sample = random_sample(random, 3 + trial % 20);
    const double z = uniform(random);
    worst = std::max(worst, double(msm_shadow(sample.moments, static_cast<float>(z), 3e-7f)) - sample.shadow(z));
  }
  fmt::print("msm, above the true shadow by at most {:.5f}\n", worst);
  EXPECT_LT(worst, 1e-4);
}

TEST(MomentIdentity, NoMomentsWhateverGiveAnythingButVisibility) {
  std::mt19937 random(13);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  size_t wrong = 0;
  const auto check = [&](float v) { wrong += !(v >= 0.0f && v <= 1.0f); };
  const std::vector<float> edges = {-1.0f, 0.0f, 1.0f, 0.5f, 1e-30f, -1e-7f, 1.0f / 3.0f};
  for (int trial = 0; trial < 300000; ++trial) {
    const auto pick = [&] { return random() % 4 == 0 ? edges[random() % edges.size()] : uniform(random); };
    // Of no distribution at all, mostly.
    vec4 moments(pick(), pick(), pick(), pick());
    if (trial % 3 == 0) moments = msm_moments(moments.x);
    const float z = trial % 7 == 0 ? moments.x : pick();
    for (const float bias : {0.0f, 3e-7f, 6e-5f, 0.5f}) check(msm_shadow(moments, z, bias));
    check(chebyshev(moments.x, moments.y, z, 1e-12f));
    const vec2 exponents(42.0f, trial % 2 ? 42.0f : 0.05f);
    const vec2 receiver = evsm_warp(0.5f + 0.5f * z, exponents), warped = evsm_warp(0.5f + 0.5f * moments.x, exponents);
    const vec2 other = evsm_warp(0.5f + 0.5f * moments.y, exponents);
    const float t = 0.5f + 0.5f * moments.z;
    for (const float least : {0.0f, 1e-4f, 1e20f}) {
      check(evsm_bound(glm::mix(warped.x, other.x, t), glm::mix(warped.x * warped.x, other.x * other.x, t), receiver.x,
                       exponents.x, least));
      check(evsm_bound(glm::mix(warped.y, other.y, t), glm::mix(warped.y * warped.y, other.y * other.y, t), receiver.y,
                       exponents.y, least));
      check(evsm_bound(warped.x, 0.0f, receiver.x, exponents.x, least));
    }
  }
  EXPECT_EQ(wrong, 0u);
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::abs(double(a[i]) - double(b[i]));
  return sum / static_cast<double>(a.size());
}

std::vector<float> courtyard_mask(const char* technique, std::initializer_list<std::string_view> assignments) {
  View& view = test::kept_view("courtyard", [] { return load_scene("courtyard"); }, {160, 120});
  const auto& spec = find_technique(technique);
  return test::run_technique(view, spec, test::settings_of(spec, assignments)).mask;
}

TEST(MomentIdentity, EvsmBecomesVsmAsItsExponentsVanish) {
  const auto vsm =
      courtyard_mask("single/vsm", {"single.size=1024", "vsm.slope_term=false", "vsm.min_variance=10", "vsm.bleeding=0.1"});
  double last = 1.0;
  for (const char* exponent : {"8", "2", "0.5", "0.1"}) {
    const std::string positive = fmt::format("evsm.positive={}", exponent),
                      negative = fmt::format("evsm.negative={}", exponent);
    const double difference = mean_difference(vsm, courtyard_mask("single/evsm", {"single.size=1024", "evsm.min_variance=10",
                                                                                  "evsm.bleeding=0.1", positive, negative}));
    fmt::print("evsm with exponents {:>3}: {:.5f} from vsm\n", exponent, difference);
    EXPECT_LT(difference, std::max(last, 5e-4));
    last = difference;
  }
  EXPECT_LT(last, 0.002);
}

// Chebyshev's bound under a plate, whose own depth does not vary: s^2 / (s^2 + gap^2), s the least deviation in centimetres.
TEST(MomentIdentity, LeastVarianceIsInCentimetres) {
  constexpr float k_gap = 0.1f;
  Scene scene = test::scene_with({test::floor_part(3.0f), test::box_part({-2, k_gap, -2}, {2, k_gap + 1.0f, 2})});
  scene.cameras.push_back(look_at("under", {0, 0.05f, 5}, {0, 0, 0}, 20.0));
  scene.lights.push_back(test::make_sun({0, -1, 0}));
  // The caster's top is what a map holds: as thin as a sheet.
  scene.objects[1].world_from_object = glm::translate(mat4(1.0f), vec3(0, k_gap, 0)) *
                                       glm::scale(mat4(1.0f), vec3(1, 1e-4f, 1)) *
                                       glm::translate(mat4(1.0f), vec3(0, -k_gap, 0));
  View view(std::move(scene), {64, 48});
  for (const double deviation_cm : {2.0, 5.0, 10.0}) {
    const double s = 0.01 * deviation_cm, expected = s * s / (s * s + double(k_gap) * double(k_gap));
    const std::pair<std::string, std::string> techniques[] = {{"vsm", "blur=0"}, {"savsm", "width=1"}};
    for (const auto& [filter, width] : techniques) {
      std::vector<std::string> settings = {filter + "." + width, filter + ".bleeding=0",
                                           fmt::format("{}.min_variance={}", filter, deviation_cm)};
      if (filter == "vsm") settings.insert(settings.end(), {"vsm.slope_term=false", "vsm.mips=false"});
      const auto& spec = find_technique("single/" + filter);
      SettingsMap map = test::settings_of(spec, {"bias.constant=0", "bias.slope=0", "bias.normal_offset=0", "single.size=256"});
      for (const std::string& text : settings) {
        const size_t equals = text.find('=');
        map.find(filter)->second.set(text.substr(filter.size() + 1, equals - filter.size() - 1), text.substr(equals + 1), text);
      }
      const auto mask = test::run_technique(view, spec, map).mask;
      const auto points = view.frame().read_points();
      size_t under = 0;
      for (size_t i = 0; i < mask.size(); ++i) {
        const vec3 at = points[i].position_ws;
        if (points[i].object != 0 || std::abs(at.x) > 1.5f || std::abs(at.z) > 1.5f) continue;
        ++under;
        EXPECT_NEAR(double(mask[i]), expected, 0.02 + 0.05 * expected) << filter << ", " << deviation_cm << " cm";
      }
      EXPECT_GT(under, 20u);
    }
  }
}

TEST(MomentIdentity, SummedAreaOfOneTexelIsAnUnblurredVsm) {
  const auto vsm = courtyard_mask(
      "single/vsm", {"single.size=1024", "vsm.slope_term=false", "vsm.mips=false", "vsm.blur=0", "vsm.min_variance=5"});
  const auto same = courtyard_mask("single/savsm", {"single.size=1024", "savsm.width=1", "savsm.min_variance=5"});
  const auto wide = courtyard_mask("single/savsm", {"single.size=1024", "savsm.width=9", "savsm.min_variance=5"});
  fmt::print("savsm, width 1: {:.5f} from vsm; width 9: {:.5f}\n", mean_difference(vsm, same), mean_difference(vsm, wide));
  EXPECT_LT(mean_difference(vsm, same), 0.01);
  EXPECT_LT(mean_difference(vsm, same), 0.3 * mean_difference(vsm, wide));
}

}  // namespace
}  // namespace gnomon
