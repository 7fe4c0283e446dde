// Every parameter of every technique: its ends are safe, it does something, and `live` ones do it without a rebuild.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "stage.h"

namespace gnomon {
namespace {

using test::TechniqueRun;
using test::View;

constexpr double k_mib = 1024.0 * 1024.0, k_most_mib = 256.0;
constexpr uvec2 k_size = {64, 48};
constexpr double k_map_size = 256.0;  // texels: maps of their usual size cost a CPU driver seconds
constexpr int k_frames = 3;           // enough for what shows only over time

struct Parameter {
  std::string id, name;
  ParamInfo info;
};

void PrintTo(const Parameter& parameter, std::ostream* stream) { *stream << parameter.id << "." << parameter.name; }

std::vector<Parameter> all_parameters() {
  std::map<std::string, Parameter> unique;
  for (const auto& spec : all_techniques()) {
    for (const auto& [id, table] : spec.tables) {
      for (const ParamInfo& info : table) {
        unique.try_emplace(fmt::format("{}.{}", id, info.name), Parameter{id, std::string(info.name), info});
      }
    }
  }
  std::vector<Parameter> list;
  for (auto& [key, parameter] : unique) list.push_back(parameter);
  return list;
}

std::vector<const TechniqueSpec*> techniques_with(const std::string& id) {
  std::vector<const TechniqueSpec*> list;
  for (const auto& spec : all_techniques()) {
    for (const auto& [table_id, table] : spec.tables) {
      if (table_id == id) list.push_back(&spec);
    }
  }
  return list;
}

std::string part(const TechniqueSpec& spec, bool filter) {
  const size_t slash = spec.name.find('/');
  return slash == std::string::npos ? spec.name : filter ? spec.name.substr(slash + 1) : spec.name.substr(0, slash);
}

// Of those, enough that every projection and every filter is among them: what many pairs share need not be tried in all.
std::vector<const TechniqueSpec*> representatives(const std::string& id) {
  std::set<std::string> seen;
  std::vector<const TechniqueSpec*> list;
  for (const TechniqueSpec* spec : techniques_with(id)) {
    const bool new_projection = seen.insert("projection " + part(*spec, false)).second;
    const bool new_filter = seen.insert("filter " + part(*spec, true)).second;
    if (new_projection || new_filter) list.push_back(spec);
  }
  return list;
}

// A table that many pairs share is tried with the first and the last of them.
std::vector<const TechniqueSpec*> two_techniques_with(const std::string& id) {
  const auto all = techniques_with(id);
  if (all.size() < 2) return all;
  return {all.front(), all.back()};
}

View& busy_view(const TechniqueSpec& spec) {
  const LightKind kind = test::preferred_light(spec);
  return test::kept_view(
      fmt::format("busy {}", light_kind_name(kind)),
      [=] {
        Scene scene = test::busy(kind);
        if (kind == LightKind::directional)
          scene.lights[0].angular_diameter = 0.05f;
        else
          scene.lights[0].radius = 0.2f;
        return scene;
      },
      k_size);
}

SettingsMap with(SettingsMap settings, const std::string& id, std::string_view name, double value) {
  settings.find(id)->second.set_number(name, value, fmt::format("{}.{}", id, name));
  return settings;
}

// The defaults, with a smaller map.
SettingsMap base_settings(const TechniqueSpec& spec) {
  SettingsMap settings = spec.default_settings();
  for (const auto& [id, table] : spec.tables) {
    for (const ParamInfo& info : table) {
      if (info.name == "size" && info.update == ParamUpdate::rebuild) settings = with(settings, id, info.name, k_map_size);
    }
  }
  return settings;
}

// Values worth trying, none of them the default.
std::vector<double> values_of(const ParamInfo& info) {
  std::vector<double> values;
  if (info.type == ParamType::bool_ || info.type == ParamType::choice) {
    for (double v = info.min; v <= info.max; ++v) values.push_back(v);
  } else {
    values = {info.min, 0.5 * (info.min + info.default_value), 2.0 * info.default_value, info.max};
    if (info.type == ParamType::int_) {
      for (double& v : values) v = std::floor(v);
    }
  }
  std::erase_if(values, [&](double v) { return v == info.default_value || v < info.min || v > info.max; });
  return values;
}

void expect_sound(const std::vector<float>& mask, const std::string& what) {
  size_t unsound = 0;
  for (const float v : mask) unsound += !(v >= 0.0f && v <= 1.0f);
  EXPECT_EQ(unsound, 0u) << what << ": samples that are NaN or outside [0, 1], of " << mask.size();
}

// What a parameter can change: the answer, the work, the memory.
std::string work_of(const TechniqueRun& run) {
  std::string text = fmt::format("{} bytes;", run.bytes);
  for (const PassResult& pass : run.frame.passes) {
    text += fmt::format(" {} {} {} {};", pass.name, pass.draws, pass.dispatches, pass.triangles);
  }
  return text;
}
bool differ(const TechniqueRun& a, const TechniqueRun& b) { return a.mask != b.mask || work_of(a) != work_of(b); }

// The last of several frames: the light stands still, then moves. The passes of all frames are in `frame`.
TechniqueRun run_frames(View& view, const TechniqueSpec& spec, const SettingsMap& settings) {
  TechniqueRun run;
  const auto technique = spec.make(view.context(), settings);
  for (int frame = 0; frame < k_frames; ++frame) {
    std::vector<Light> lights = view.scene().lights;
    if (frame == k_frames - 1)
      lights[0].position.x += 0.1f, lights[0].direction = glm::normalize(lights[0].direction + vec3(0.05f, 0, 0));
    view.frame().set_lights(lights);
    view.frame().set_camera(view.scene().cameras.at(0));
    const FrameResult result = test::run_passes([&](Recorder& recorder) {
      view.frame().record_surface(recorder);
      technique->record(recorder, view.frame(), 0);
    });
    run.frame.passes.insert(run.frame.passes.end(), result.passes.begin(), result.passes.end());
  }
  run.mask = view.frame().read_mask(0);
  view.frame().set_lights(view.scene().lights);
  view.frame().set_camera(view.scene().cameras.at(0));
  return run;
}

// Nothing where the device lacks what the settings need (sample counts of a map, say), or where they cannot work together (a
// history of objects): that is refused with a reason, as it must be.
template <class Run>
std::optional<TechniqueRun> run_or_refusal(const Run& run) {
  try {
    return run();
  } catch (const Error& error) {
    if (error.code() != ExitCode::device && error.code() != ExitCode::usage) throw;
    fmt::print("refused: {}\n", error.what());
    return std::nullopt;
  }
}

// A new technique's answer. Kept for all tests, since the same inputs give the same bits (EveryTechnique): making a technique
// takes a CPU driver far longer than a frame.
const std::optional<TechniqueRun>& new_run(const TechniqueSpec& spec, const SettingsMap& settings) {
  static std::map<std::pair<std::string, std::vector<uint32_t>>, std::optional<TechniqueRun>> runs;
  std::vector<uint32_t> words;
  for (const auto& [id, block] : settings) words.insert(words.end(), block.words().begin(), block.words().end());
  const auto [found, inserted] = runs.try_emplace({spec.name, words});
  if (inserted) found->second = run_or_refusal([&] { return test::run_technique(busy_view(spec), spec, settings); });
  return found->second;
}

// A technique whose live parameters are changed and changed back.
class LiveTechnique {
 public:
  explicit LiveTechnique(const TechniqueSpec& spec)
      : view_(busy_view(spec)), technique_(spec.make(view_.context(), base_settings(spec))) {}

  TechniqueRun run(const SettingsMap& settings) {
    TechniqueRun run;
    technique_->set(settings);
    run.frame = test::run_passes([&](Recorder& recorder) {
      view_.frame().record_surface(recorder);
      technique_->record(recorder, view_.frame(), 0);
    });
    run.mask = view_.frame().read_mask(0);
    return run;
  }

 private:
  View& view_;
  std::unique_ptr<Technique> technique_;
};

LiveTechnique& live_technique(const TechniqueSpec& spec) {
  static std::map<std::string, LiveTechnique> kept;
  auto found = kept.find(spec.name);
  if (found == kept.end()) {
    found = kept.try_emplace(spec.name, spec).first;
    if (kept.size() == 1) test::at_exit([] { kept.clear(); });  // before its view goes
  }
  return found->second;
}

// Whether settings differ from the base in live parameters alone.
bool only_live_differ(const TechniqueSpec& spec, const SettingsMap& settings) {
  const SettingsMap base = base_settings(spec);
  for (const auto& [id, table] : spec.tables) {
    for (const ParamInfo& info : table) {
      if (info.update == ParamUpdate::rebuild && settings.at(id).number(info.name) != base.at(id).number(info.name))
        return false;
    }
  }
  return true;
}

class EveryParameter : public testing::TestWithParam<Parameter> {};

// The largest value of a parameter that decides about memory is reached by doubling, and left out where it would need more
// than k_most_mib.
void try_large_values(const TechniqueSpec& spec, const Parameter& parameter) {
  double value = std::max(std::min(parameter.info.default_value, k_map_size), 1.0), bytes = 0.0, growth = 1.0;
  const double first = value;
  while (true) {
    const auto& run = new_run(spec, with(base_settings(spec), parameter.id, parameter.name, value));
    ASSERT_TRUE(run);
    expect_sound(run->mask, fmt::format("{}, {}.{}={}", spec.name, parameter.id, parameter.name, value));
    if (bytes > 0.0) growth = static_cast<double>(run->bytes) / bytes;
    bytes = static_cast<double>(run->bytes);
    if (value == parameter.info.max) return;
    const double next = std::min(2.0 * value, parameter.info.max);
    const double predicted = bytes * std::max(growth, value == first ? 4.0 : 1.0);
    if (predicted > 1.01 * k_most_mib * k_mib) {
      fmt::print("{}: {}.{}={} and more is left out: it would need some {:.0f} MiB\n", spec.name, parameter.id, parameter.name,
                 next, predicted / k_mib);
      return;
    }
    value = next;
  }
}

TEST_P(EveryParameter, IsSoundAtBothEnds) {
  const Parameter& parameter = GetParam();
  for (const TechniqueSpec* spec : two_techniques_with(parameter.id)) {
    const bool grows = parameter.info.update == ParamUpdate::rebuild && parameter.info.type == gnomon::ParamType::int_;
    const auto run_at = [&](double value) {
      const auto& run = new_run(*spec, with(base_settings(*spec), parameter.id, parameter.name, value));
      if (run) expect_sound(run->mask, fmt::format("{}, {}.{}={}", spec->name, parameter.id, parameter.name, value));
    };
    run_at(parameter.info.min);
    if (grows) {
      try_large_values(*spec, parameter);
    } else {
      run_at(parameter.info.max);
    }
  }
}

// True when some value changes something, with the other settings as given. A live one is changed on a technique that is there.
bool changes_something(const TechniqueSpec& spec, const Parameter& parameter, const SettingsMap& others,
                       bool over_frames = false) {
  const bool live = only_live_differ(spec, others);
  const auto run = [&](const SettingsMap& settings) {
    if (over_frames) return run_or_refusal([&] { return run_frames(busy_view(spec), spec, settings); });
    if (live && parameter.info.update == ParamUpdate::live)
      return run_or_refusal([&] { return live_technique(spec).run(settings); });
    return new_run(spec, settings);
  };
  const auto before = run(others);
  if (!before) return false;
  for (const double value : values_of(parameter.info)) {
    if (parameter.info.update == ParamUpdate::rebuild && value > 2.0 * std::max(parameter.info.default_value, 1.0)) continue;
    const auto after = run(with(others, parameter.id, parameter.name, value));
    if (after && differ(*before, *after)) return true;
  }
  return false;
}

// A parameter may depend on another one (a limit, a choice of mode): each other is tried at its own values too.
bool acts_beside_another(const TechniqueSpec& spec, const Parameter& parameter) {
  const SettingsMap defaults = base_settings(spec);
  struct Other {
    std::string id;
    const ParamInfo* info;
  };
  std::vector<Other> others;
  for (const auto& [id, table] : spec.tables) {
    for (const ParamInfo& info : table) {
      if (id != parameter.id || info.name != parameter.name) others.push_back({id, &info});
    }
  }
  // Modes of its own table first, then the rest of it: that is where the other one is most often.
  const auto own =
      std::stable_partition(others.begin(), others.end(), [&](const Other& other) { return other.id == parameter.id; });
  const auto is_mode = [](const Other& other) {
    return other.info->type == ParamType::choice || other.info->type == ParamType::bool_;
  };
  std::stable_partition(others.begin(), own, is_mode);
  for (const Other& other : others) {
    for (const double value : values_of(*other.info)) {
      if (other.info->update == ParamUpdate::rebuild && value > other.info->default_value &&
          other.info->type == ParamType::int_)
        continue;
      if (!changes_something(spec, parameter, with(defaults, other.id, other.info->name, value))) continue;
      fmt::print("{}: {}.{} acts only with {}.{}={}\n", spec.name, parameter.id, parameter.name, other.id, other.info->name,
                 value);
      return true;
    }
  }
  return false;
}

TEST_P(EveryParameter, IsAlive) {
  const Parameter& parameter = GetParam();
  // By itself first, then over frames: trying it beside every other parameter takes long.
  for (const TechniqueSpec* spec : representatives(parameter.id)) {
    if (changes_something(*spec, parameter, base_settings(*spec))) return;
  }
  for (const TechniqueSpec* spec : two_techniques_with(parameter.id)) {
    if (changes_something(*spec, parameter, base_settings(*spec), true)) return;
  }
  for (const TechniqueSpec* spec : two_techniques_with(parameter.id)) {
    if (acts_beside_another(*spec, parameter)) return;
  }
  ADD_FAILURE() << parameter.id << "." << parameter.name << " changes neither mask nor work nor memory of any technique";
}

TEST_P(EveryParameter, TakesEffectAsItsTableSays) {
  const Parameter& parameter = GetParam();
  if (parameter.info.update == ParamUpdate::rebuild) return;
  for (const TechniqueSpec* spec : two_techniques_with(parameter.id)) {
    const auto defaults = base_settings(*spec);
    for (const double value : values_of(parameter.info)) {
      const auto changed = with(defaults, parameter.id, parameter.name, value);
      const auto &before = new_run(*spec, defaults), &after = new_run(*spec, changed);
      ASSERT_TRUE(before && after) << spec->name;
      const std::string what = fmt::format("{}: {}.{}={}", spec->name, parameter.id, parameter.name, value);
      // A frame with the old value first: what that frame made (pipelines, maps, a cache) must not outlive the change.
      EXPECT_EQ(live_technique(*spec).run(defaults).mask, before->mask) << what << ": what was set before is not taken back";
      EXPECT_EQ(live_technique(*spec).run(changed).mask, after->mask)
          << what << " is called live, but a new technique gives another mask";
    }
  }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(EveryParameter);
INSTANTIATE_TEST_SUITE_P(All, EveryParameter, testing::ValuesIn(all_parameters()),
                         [](const auto& instance) { return test::test_name(instance.param.id + "_" + instance.param.name); });

}  // namespace
}  // namespace gnomon
