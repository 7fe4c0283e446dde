// What every registered technique must do. The list is read from the registry: a new folder is tested without an edit here.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "measure/visibility_error.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::View;

constexpr uvec2 k_size = {96, 72};

// A technique and a kind of light that it claims.
struct Pair {
  std::string name;
  LightKind kind;
};
void PrintTo(const Pair& pair, std::ostream* stream) {
  *stream << pair.name << " under a " << light_kind_name(pair.kind) << " light";
}

class EveryTechnique : public testing::TestWithParam<Pair> {
 protected:
  void SetUp() override {
    kind_ = GetParam().kind;
    // A device that lacks what a technique needs is no defect of the technique: that is what exit code 3 is for.
    if (!test::device().info().ray_tracing) {
      try {
        test::run_technique(view("box", test::box_on_floor), spec(), spec().default_settings());
      } catch (const Error& error) {
        if (error.code() != ExitCode::device) throw;
        GTEST_SKIP() << error.what();
      }
    }
  }

  const TechniqueSpec& spec() const { return find_technique(GetParam().name); }
  View& view(const std::string& name, Scene (*make)(LightKind), uint32_t samples = 1) const {
    const LightKind kind = kind_;
    return test::kept_view(
        fmt::format("{} {}", name, light_kind_name(kind)), [=] { return make(kind); }, k_size, samples);
  }
  // A new technique's, once for all tests.
  const std::vector<float>& mask(View& on) const {
    static std::map<std::pair<std::string, const View*>, std::vector<float>> masks;
    auto& mask = masks[{spec().name, &on}];
    if (mask.empty()) mask = test::run_technique(on, spec(), spec().default_settings()).mask;
    return mask;
  }

  // Filters that estimate a distribution from moments have a parameter against bleeding.
  bool bleeds() const {
    return std::any_of(spec().tables.begin(), spec().tables.end(), [](const auto& table) {
      return std::any_of(table.second.begin(), table.second.end(),
                         [](const ParamInfo& info) { return info.name == "bleeding"; });
    });
  }

  LightKind kind_ = LightKind::directional;
};

TEST_P(EveryTechnique, SaysWhatItIs) {
  EXPECT_FALSE(spec().manual.empty());
  EXPECT_FALSE(spec().summary.empty());
  EXPECT_FALSE(spec().light_kinds.empty());
  EXPECT_TRUE(spec().refused.empty());
  for (const auto& [id, table] : spec().tables) {
    EXPECT_FALSE(id.empty());
    for (const ParamInfo& param : table) {
      EXPECT_FALSE(param.help.empty()) << id << "." << param.name;
      EXPECT_LE(param.min, param.default_value) << id << "." << param.name;
      EXPECT_GE(param.max, param.default_value) << id << "." << param.name;
    }
  }
}

TEST_P(EveryTechnique, LitSceneIsOne) {
  View& scene = view("open floor", test::open_floor);
  const auto& found = mask(scene);
  const auto receiver = test::receivers(scene);
  ASSERT_GT(test::count(receiver), receiver.size() * 9 / 10);
  size_t darkened = 0;
  float darkest = 1.0f;
  for (size_t i = 0; i < found.size(); ++i) {
    if (!receiver[i]) continue;
    darkest = std::min(darkest, found[i]);
    // Over a wide footprint of a tilted floor the filtered mean is off by a fraction of the spread.
    darkened += found[i] < 1.0f - (bleeds() ? 0.05f : 1e-3f);
  }
  EXPECT_EQ(darkened, 0u) << "of " << test::count(receiver) << " lit samples; the darkest is " << darkest;
}

// Metres to the nearest line along which two walls of the room meet.
float to_contact(const vec3& p) {
  std::array<float, 3> to_wall = {2.0f - std::abs(p.x), std::min(p.y, 3.0f - p.y), 2.0f - std::abs(p.z)};
  std::sort(to_wall.begin(), to_wall.end());
  return std::hypot(std::max(to_wall[0], 0.0f), std::max(to_wall[1], 0.0f));
}

// `reach`: how far from where caster and receiver touch light may be found. Walls without thickness touch what they shadow, and
// a kernel on the outline of the room reaches beyond it: theory allows a few texels (of 3 mm) there.
void expect_dark(View& scene, const std::vector<float>& found, float threshold, float reach, double mean) {
  const auto receiver = test::receivers(scene);
  const auto points = scene.frame().read_points();
  ASSERT_GT(test::count(receiver), receiver.size() / 4);
  size_t light = 0;
  double sum = 0.0;
  for (size_t i = 0; i < found.size(); ++i) {
    if (!receiver[i]) continue;
    light += found[i] > threshold && to_contact(points[i].position_ws) >= reach;
    sum += double(found[i]);
  }
  const auto n = static_cast<double>(test::count(receiver));
  EXPECT_EQ(light, 0u) << "samples with light in a closed room, of " << n;
  EXPECT_LT(sum / n, mean);
}

TEST_P(EveryTechnique, ClosedRoomIsDark) {
  View& thick = view("thick room", [](LightKind kind) { return test::closed_room(kind, false); });
  // An exponential of the gap between two depths never quite reaches 0.
  const float threshold = bleeds() ? 0.02f : 0.0f;
  expect_dark(thick, mask(thick), threshold, 0.0f, bleeds() ? 0.01 : 1e-6);
  View& thin = view("thin room", [](LightKind kind) { return test::closed_room(kind, true); });
  // A filter that bleeds says so by offering to reduce it: in this small picture its footprints are decimetres wide, and every
  // outline of the room is a contact.
  expect_dark(thin, mask(thin), threshold, bleeds() ? 0.8f : 0.1f, bleeds() ? 0.2 : 0.02);
}

// What many pairs share need not be tried with a busy picture in all of them: the first pair of each projection and filter.
bool first_of_its_parts(const Pair& pair) {
  static const std::set<std::string> firsts = [] {
    std::set<std::string> seen, names;
    for (const auto& spec : all_techniques()) {
      const size_t slash = spec.name.find('/');
      const bool projection = seen.insert(spec.name.substr(0, slash)).second;
      const bool filter = slash != std::string::npos && seen.insert(spec.name.substr(slash)).second;
      if (projection || filter) names.insert(spec.name);
    }
    return names;
  }();
  return firsts.count(pair.name) && pair.kind == test::preferred_light(find_technique(pair.name));
}

TEST_P(EveryTechnique, SameInputsGiveTheSameBits) {
  View& scene = first_of_its_parts(GetParam()) ? view("busy", test::busy) : view("box", test::box_on_floor);
  const auto& first = mask(scene);
  const auto technique = spec().make(scene.context(), spec().default_settings());
  const auto again = [&](TimingMode mode, bool isolate) {
    test::run_passes(
        [&](Recorder& recorder) {
          scene.frame().record_surface(recorder);
          technique->record(recorder, scene.frame(), 0);
        },
        mode, isolate);
    return scene.frame().read_mask(0);
  };
  EXPECT_EQ(again(TimingMode::play, false), first) << "another technique";
  EXPECT_EQ(again(TimingMode::play, true), first) << "another frame of one technique";
  EXPECT_EQ(again(TimingMode::measure, false), first) << "barriers change the result";
}

TEST_P(EveryTechnique, IsNearerToTheTruthThanNoShadowsAtAll) {
  for (const uint32_t samples : {1u, 4u}) {
    const auto& counts = test::device().info().sample_counts;
    if (std::find(counts.begin(), counts.end(), static_cast<int>(samples)) == counts.end()) continue;
    View& scene = view("box", test::box_on_floor, samples);
    const auto& found = mask(scene);
    const ReferenceResult& truth = test::hard_reference(scene);
    const std::vector<float> lit(found.size(), 1.0f);
    // Throws for NaN and for values outside [0, 1].
    const double error = visibility_error(found, truth.visibility, truth.receiver).mae;
    const double of_nothing = visibility_error(lit, truth.visibility, truth.receiver).mae;
    EXPECT_LT(error, 0.5 * of_nothing) << samples << " samples";
    EXPECT_LT(error, 0.05) << samples << " samples";
  }
}

TEST_P(EveryTechnique, FillsEverySampleOfSeveralLights) {
  View& scene = test::kept_view(fmt::format("two lights {}", light_kind_name(kind_)),
                                [&] {
                                  Scene two = test::box_on_floor(kind_);
                                  two.lights.push_back(test::make_light(kind_, {-0.6f, -1, -0.4f}, {0, 0, 0}, 7.0f));
                                  return two;
                                },
                                {48, 36});
  std::vector<std::vector<float>> together, alone;
  const auto settings = spec().default_settings();
  std::vector<std::unique_ptr<Technique>> techniques;
  for (size_t light = 0; light < 2; ++light) {
    scene.frame().write_mask(light, std::vector<float>(scene.frame().sample_count(), -1.0f));
    techniques.push_back(spec().make(scene.context(), settings));
  }
  test::run_passes([&](Recorder& recorder) {
    scene.frame().record_surface(recorder);
    for (size_t light = 0; light < 2; ++light) techniques[light]->record(recorder, scene.frame(), light);
  });
  for (size_t light = 0; light < 2; ++light) {
    together.push_back(scene.frame().read_mask(light));
    for (const float v : together.back()) ASSERT_TRUE(v >= 0.0f && v <= 1.0f) << "light " << light;
  }
  EXPECT_NE(together[0], together[1]);
  for (size_t light = 0; light < 2; ++light) {
    test::run_passes([&](Recorder& recorder) {
      scene.frame().record_surface(recorder);
      techniques[light]->record(recorder, scene.frame(), light);
    });
    EXPECT_EQ(scene.frame().read_mask(light), together[light]) << "light " << light << " depends on the other";
  }
}

std::vector<Pair> pairs() {
  std::vector<Pair> list;
  for (const auto& spec : all_techniques()) {
    for (const LightKind kind : spec.light_kinds) list.push_back({spec.name, kind});
  }
  return list;
}

INSTANTIATE_TEST_SUITE_P(All, EveryTechnique, testing::ValuesIn(pairs()), [](const auto& instance) {
  return test::test_name(fmt::format("{} {}", instance.param.name, light_kind_name(instance.param.kind)));
});

}  // namespace
}  // namespace gnomon
