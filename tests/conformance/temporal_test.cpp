// temporal.history: what it calms, what it smears, and that it arrives at the map it would have without.
#include <algorithm>
#include <cmath>
#include <map>

#include "measure/visibility_error.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::View;

View& hexworld() {
  return test::kept_view("hexworld", [] { return load_scene("hexworld"); }, {96, 72});
}

// The scene's first light turned about the vertical.
void turn_sun(View& view, float degrees) {
  std::vector<Light> lights = view.scene().lights;
  const vec3 d = lights[0].direction;
  const float c = std::cos(degrees * k_pi / 180.0f), s = std::sin(degrees * k_pi / 180.0f);
  lights[0].direction = {c * d.x + s * d.z, d.y, c * d.z - s * d.x};
  view.frame().set_lights(lights);
  view.frame().set_camera(view.scene().cameras.at(0));
}

FrameResult draw(View& view, Technique& technique) {
  return test::run_passes([&](Recorder& recorder) {
    view.frame().record_surface(recorder);
    technique.record(recorder, view.frame(), 0);
  });
}

std::unique_ptr<Technique> make(View& view, const std::string& name, std::initializer_list<std::string_view> assignments) {
  const auto& spec = find_technique(name);
  return spec.make(view.context(), test::settings_of(spec, assignments));
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::abs(double(a[i]) - double(b[i]));
  return sum / static_cast<double>(a.size());
}

bool has_pass(const FrameResult& frame, std::string_view end) {
  return std::any_of(frame.passes.begin(), frame.passes.end(),
                     [&](const PassResult& pass) { return pass.name.ends_with(end); });
}

// Over frames in which the sun turns, after those that fill the history.
struct Motion {
  double flicker = 0.0;  // mean change of a receiver's visibility from frame to frame where the truth does not change
  double error = 0.0;    // mean absolute, against the truth of the same frame
};

constexpr int k_warm = 8, k_frames = 12;

// The truth of each frame of a motion, once for all techniques.
const std::vector<ReferenceResult>& truth_of(View& view, float degrees_a_frame) {
  static std::map<float, std::vector<ReferenceResult>> kept;
  auto& frames = kept[degrees_a_frame];
  if (!frames.empty()) return frames;
  static const EmbreeReference rays(view.scene());
  for (int i = 0; i < k_frames; ++i) {
    turn_sun(view, degrees_a_frame * static_cast<float>(i));
    view.draw();
    frames.push_back(
        rays.trace(view.frame().read_points(), view.frame().camera().eye_ws, view.frame().lights()[0], false, 1, 1));
  }
  return frames;
}

Motion motion_of(View& view, const std::string& name, float degrees_a_frame, std::string_view history) {
  const auto technique = make(view, name, {"single.size=512", history});
  const auto& truth = truth_of(view, degrees_a_frame);
  Motion motion;
  std::vector<float> last;
  double changes = 0.0, steady = 0.0;
  for (int i = -k_warm; i < k_frames; ++i) {
    turn_sun(view, degrees_a_frame * static_cast<float>(i));
    draw(view, *technique);
    if (i < 0) continue;
    const auto mask = view.frame().read_mask(0);
    const ReferenceResult& now = truth[static_cast<size_t>(i)];
    motion.error += visibility_error(mask, now.visibility, now.receiver).mae / k_frames;
    if (i > 0) {
      const ReferenceResult& before = truth[static_cast<size_t>(i - 1)];
      for (size_t s = 0; s < mask.size(); ++s) {
        if (!now.receiver[s] || !before.receiver[s] || now.visibility[s] != before.visibility[s]) continue;
        changes += std::abs(double(mask[s]) - double(last[s]));
        ++steady;
      }
    }
    last = mask;
  }
  motion.flicker = changes / steady;
  turn_sun(view, 0.0f);
  return motion;
}

TEST(Temporal, HistoryCalmsASlowSunAndSmearsAFastOne) {
  View& view = hexworld();
  for (const std::string name : {"single/vsm", "single/pcf"}) {
    std::map<float, Motion> off, on;
    for (const float degrees : {0.05f, 3.0f}) {
      off[degrees] = motion_of(view, name, degrees, "temporal.history=0");
      on[degrees] = motion_of(view, name, degrees, "temporal.history=0.95");
      fmt::print("{}, hexworld, {:4} degrees a frame, history 0 -> 0.95: flicker {:.5f} -> {:.5f}, mae {:.5f} -> {:.5f}\n",
                 name, degrees, off[degrees].flicker, on[degrees].flicker, off[degrees].error, on[degrees].error);
    }
    EXPECT_LT(on[0.05f].flicker, (name == "single/vsm" ? 0.25 : 0.8) * off[0.05f].flicker) << name;
    const double slow_smear = on[0.05f].error - off[0.05f].error, fast_smear = on[3.0f].error - off[3.0f].error;
    EXPECT_GT(fast_smear, 1.3 * slow_smear) << name << ": shadows that trail behind the sun must be seen in the error";
  }
}

// In the frame after a step of the sun a map is mostly the last one: a mask that is the one without history shows that the
// filter keeps none, which the tests of a still or a slow sun cannot see.
TEST(Temporal, EveryFilterBlendsAfterAStepOfTheSun) {
  View& view = hexworld();
  const size_t receivers = test::count(test::receivers((view.draw(), view)));
  const auto differing = [&](const std::vector<float>& a, const std::vector<float>& b) {
    size_t count = 0;
    for (size_t i = 0; i < a.size(); ++i) count += std::abs(a[i] - b[i]) > 0.02f;
    return static_cast<double>(count) / static_cast<double>(receivers);
  };
  size_t filters = 0;
  for (const auto& spec : all_techniques()) {
    if (!spec.name.starts_with("single/") || spec.name.ends_with("/object_id")) continue;  // object ids refuse a history
    ++filters;
    const auto plain = make(view, spec.name, {"single.size=256"});
    const auto blended = make(view, spec.name, {"single.size=256", "temporal.history=0.9"});
    const auto little = make(view, spec.name, {"single.size=256", "temporal.history=0.2"});
    draw(view, *little);
    draw(view, *plain);
    const auto before = view.frame().read_mask(0);
    draw(view, *blended);
    EXPECT_LT(mean_difference(view.frame().read_mask(0), before), 1e-3) << spec.name << ": a first frame blends nothing";
    turn_sun(view, 3.0f);
    draw(view, *plain);
    const auto after = view.frame().read_mask(0);
    draw(view, *blended);
    const auto mask = view.frame().read_mask(0);
    const double share = differing(mask, after);
    fmt::print("{:14}, hexworld, a step of 3 degrees: {:.3f} of receivers differ from without history\n", spec.name, share);
    EXPECT_GT(share, 0.02) << spec.name;
    draw(view, *little);
    EXPECT_LT(mean_difference(view.frame().read_mask(0), after), mean_difference(mask, after)) << spec.name;
    turn_sun(view, 0.0f);
  }
  EXPECT_GE(filters, 8u);
}

// The last map's depths are turned into this one's: where one surface alone is seen, and lit or dark in both frames, the blend
// of both frames is so too. The views' depths differ in origin and scale.
TEST(Temporal, WhatBothFramesSayTheBlendSays) {
  View view(test::box_on_floor(LightKind::directional), {64, 48});
  for (const auto& spec : all_techniques()) {
    if (!spec.name.starts_with("single/") || spec.name.ends_with("/object_id")) continue;
    const auto plain = make(view, spec.name, {"single.size=256"});
    const auto blended = make(view, spec.name, {"single.size=256", "temporal.history=0.9"});
    draw(view, *plain);
    const auto before = view.frame().read_mask(0);
    draw(view, *blended);
    turn_sun(view, 40.0f);
    draw(view, *plain);
    const auto after = view.frame().read_mask(0);
    const auto receiver = test::receivers(view);
    draw(view, *blended);
    const auto mask = view.frame().read_mask(0);
    turn_sun(view, 0.0f);
    size_t agreed = 0, other = 0;
    for (size_t i = 0; i < mask.size(); ++i) {
      if (!receiver[i] || std::abs(before[i] - after[i]) > 0.01f || std::abs(after[i] - 0.5f) < 0.48f) continue;
      ++agreed;
      other += std::abs(mask[i] - after[i]) > 0.1f;
    }
    fmt::print("{}: of {} samples on which both frames agree {} are blended to something else\n", spec.name, agreed, other);
    ASSERT_GT(agreed, 1000u) << spec.name;
    EXPECT_LT(other, agreed / 100) << spec.name;
  }
}

// Cascades that follow the viewer in whole texels find each surface again, so that a still sun's map stays what it is.
TEST(Temporal, MapsThatFollowTheViewerAreFoundAgain) {
  View& view = test::kept_view("courtyard", [] { return load_scene("courtyard"); }, {96, 72});
  const Camera start = view.scene().cameras.at(0);
  for (const std::string name : {"cascaded/hard", "cascaded/vsm", "cascaded/esm", "cascaded/evsm", "cascaded/msm"}) {
    const auto plain = make(view, name, {"cascaded.size=512", "cascaded.adapt=false"});
    const auto blended = make(view, name, {"cascaded.size=512", "cascaded.adapt=false", "temporal.history=0.9"});
    double difference = 0.0, last_difference = 0.0;
    std::vector<float> last;
    for (int i = 0; i < 8; ++i) {
      Camera camera = start;
      camera.world_from_view[3] -= 0.15f * static_cast<float>(i) * start.world_from_view[2];
      view.frame().set_camera(camera);
      draw(view, *plain);
      const auto expected = view.frame().read_mask(0);
      draw(view, *blended);
      difference = mean_difference(view.frame().read_mask(0), expected);
      if (i > 0) last_difference += mean_difference(expected, last) / 7.0;
      last = expected;
    }
    fmt::print(
        "{}: after 8 frames of walking the mask differs by {:.5f} from the one without history; from frame to frame by "
        "{:.5f}\n",
        name, difference, last_difference);
    EXPECT_LT(difference, 0.004) << name;
  }
  view.frame().set_camera(start);
}

TEST(Temporal, ACachedMapArrivesAndIsThenKept) {
  View& view = test::kept_view("courtyard", [] { return load_scene("courtyard"); }, {96, 72});
  for (const std::string name : {"single/hard", "single/vsm", "single/msm"}) {
    const auto technique = make(view, name, {"single.size=256", "temporal.history=0.5", "submission.cache=true"});
    EXPECT_EQ(has_pass(draw(view, *technique), "/temporal"), name == "single/hard")
        << "the first frame has nothing to blend with";
    EXPECT_FALSE(has_pass(draw(view, *technique), "/temporal")) << "nothing moved, nothing to wait for";
    turn_sun(view, 5.0f);
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(has_pass(draw(view, *technique), "/temporal")) << name << " " << i;
    EXPECT_FALSE(has_pass(draw(view, *technique), "/temporal")) << name;
    const auto arrived = view.frame().read_mask(0);
    draw(view, *make(view, name, {"single.size=256"}));
    EXPECT_LT(mean_difference(arrived, view.frame().read_mask(0)), 0.003) << name;
    turn_sun(view, 0.0f);
  }
}

// Each filter with one projection and each projection with one filter; a light that stands still changes nothing.
TEST(Temporal, AStillMapStaysItself) {
  for (const auto& spec : all_techniques()) {
    if (!spec.name.starts_with("cascaded/") && !spec.name.ends_with("/pcf") && !spec.name.ends_with("/vsm")) continue;
    if (spec.name.ends_with("/object_id")) {
      EXPECT_THROW(make(hexworld(), spec.name, {"temporal.history=0.5"}), Error);
      continue;
    }
    const std::string size = fmt::format("{}.size=256", spec.name.substr(0, spec.name.find('/')));
    const LightKind kind = test::preferred_light(spec);
    View& view = test::kept_view(fmt::format("busy {}", light_kind_name(kind)), [=] { return test::busy(kind); }, {64, 48});
    draw(view, *make(view, spec.name, {size}));
    const auto expected = view.frame().read_mask(0);
    const auto technique = make(view, spec.name, {size, "temporal.history=0.9"});
    for (int i = 0; i < 3; ++i) draw(view, *technique);
    EXPECT_LT(mean_difference(view.frame().read_mask(0), expected), 1e-3) << spec.name;
    // A view that moves otherwise than in a plane begins anew or is found again: sound in either case.
    std::vector<Light> lights = view.scene().lights;
    lights[0].position += vec3(0.1f, 0.0f, 0.05f);
    lights[0].direction = glm::normalize(lights[0].direction + vec3(0.02f, 0.0f, 0.01f));
    view.frame().set_lights(lights);
    view.frame().set_camera(view.scene().cameras.at(0));
    draw(view, *technique);
    for (const float v : view.frame().read_mask(0)) ASSERT_TRUE(v >= 0.0f && v <= 1.0f) << spec.name;
    view.frame().set_lights(view.scene().lights);
    view.frame().set_camera(view.scene().cameras.at(0));
  }
}

}  // namespace
}  // namespace gnomon
