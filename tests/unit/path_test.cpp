// Paths of viewers and suns.
#include "scene/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon {
namespace {

const CameraPath k_path = {
    "p",
    {{0.0, {0, 0, 0}, {0, 0, -1}}, {1.0, {1, 0, 0}, {5, 1, 0}}, {4.0, {3, 2, 1}, {5, 3, 9}}, {4.5, {3, 2, 8}, {-5, 3, 9}}}};

TEST(camera_path, passes_through_its_keys) {
  for (const CameraKey& key : k_path.keys) {
    EXPECT_LT(glm::length(pose_at(k_path, key.time_s).eye - key.eye), 1e-5f);
    EXPECT_LT(glm::length(pose_at(k_path, key.time_s).target - key.target), 1e-5f);
  }
  EXPECT_EQ(duration_s(k_path), 4.5);
  EXPECT_EQ(pose_at(k_path, -1.0).eye, k_path.keys.front().eye);
  EXPECT_EQ(pose_at(k_path, 9.0).eye, k_path.keys.back().eye);
  EXPECT_EQ(pose_at({"one", {{0.0, {1, 2, 3}, {4, 5, 6}}}}, 0.5).target, vec3(4, 5, 6));
}

TEST(camera_path, place_and_velocity_are_continuous) {
  constexpr double k_step = 1e-3;
  const auto velocity = [](double t) {
    return (pose_at(k_path, t + k_step).eye - pose_at(k_path, t).eye) / static_cast<float>(k_step);
  };
  for (double t = 0.01; t < 4.48; t += 0.005) {
    EXPECT_LT(glm::length(pose_at(k_path, t + 1e-4).eye - pose_at(k_path, t).eye), 0.01f) << t;
    EXPECT_LT(glm::length(velocity(t + 2 * k_step) - velocity(t)), 0.6f) << t;
  }
}

TEST(camera_path, keeps_the_lens_and_looks_at_the_target) {
  Camera like;
  like.near = 0.3f, like.vertical_fov = 0.7f;
  const Camera camera = camera_at(k_path, 2.0, like);
  const CameraPose pose = pose_at(k_path, 2.0);
  EXPECT_EQ(camera.near, 0.3f);
  EXPECT_EQ(camera.vertical_fov, 0.7f);
  EXPECT_LT(glm::length(vec3(camera.world_from_view[3]) - pose.eye), 1e-6f);
  EXPECT_NEAR(glm::dot(-vec3(camera.world_from_view[2]), glm::normalize(pose.target - pose.eye)), 1.0f, 1e-6f);
  EXPECT_NEAR(glm::determinant(mat3(camera.world_from_view)), 1.0f, 1e-5f);
}

TEST(camera_path, made_from_places_has_an_even_pace_and_turns_come_full_circle) {
  const std::array<CameraPose, 3> poses = {CameraPose{{0, 0, 0}, {0, 0, -9}}, CameraPose{{1, 0, 0}, {1, 0, -9}},
                                           CameraPose{{4, 0, 0}, {4, 0, -9}}};
  const CameraPath path = camera_path("walk", 8.0, poses);
  EXPECT_NEAR(path.keys[1].time_s, 2.0, 1e-9);
  EXPECT_EQ(duration_s(path), 8.0);
  Camera camera;
  const CameraPath turn = turn_path("turn", 10.0, camera, 5.0f);
  EXPECT_LT(glm::length(pose_at(turn, 0.0).target - pose_at(turn, 10.0).target), 1e-5f);
  EXPECT_LT(glm::length(pose_at(turn, 5.0).target - vec3(0, 0, 5)), 1e-5f);
  for (double t = 0; t < 10; t += 0.1) EXPECT_NEAR(glm::length(pose_at(turn, t).target), 5.0f, 0.02f);
  const CameraPath orbit = orbit_path("fly", 10.0, {3, 2, 0}, {1, 0, 0});
  EXPECT_LT(glm::length(pose_at(orbit, 5.0).eye - vec3(-1, 2, 0)), 1e-5f);
}

Light sun_toward(const vec3& direction) {
  Light sun;
  sun.direction = glm::normalize(direction), sun.colour = vec3(1.0f, 0.9f, 0.7f), sun.intensity = 2.5f;
  return sun;
}

TEST(sun_path, passes_through_the_sun_that_it_was_made_for) {
  for (const vec3& direction :
       {vec3(0.6f, -0.5f, 0.6f), vec3(-0.3f, -0.9f, 0.1f), vec3(0.1f, -0.03f, -1.0f), vec3(0, -1, 0), vec3(0.2f, -0.99f, 0)}) {
    const Light sun = sun_toward(direction);
    const SunPath day = day_through("day", sun);
    const SunState state = sun_at(day, day.colour_hour);
    EXPECT_LT(glm::length(state.direction - sun.direction), 2e-4f) << direction.x << ' ' << direction.y;
    EXPECT_LT(glm::length(state.colour - sun.colour), 1e-4f);
    EXPECT_NEAR(state.intensity, sun.intensity, 1e-4f);
    EXPECT_GE(day.colour_hour, day.first_hour);
    EXPECT_LE(day.colour_hour, day.last_hour + 1e-9);
  }
}

TEST(sun_path, climbs_until_noon_and_reddens_toward_evening) {
  const SunPath day = day_through("day", sun_toward({0.6f, -0.5f, 0.6f}));
  float before = -1.0f;
  for (double hour = day.first_hour; hour <= 12.0; hour += 0.25) {
    const SunState state = sun_at(day, hour);
    EXPECT_NEAR(glm::length(state.direction), 1.0f, 1e-6f);
    EXPECT_GT(-state.direction.y, before);
    before = -state.direction.y;
  }
  EXPECT_GT(-sun_at(day, day.first_hour).direction.y, 0.04f);  // never below the horizon
  const SunState noon = sun_at(day, 12.0), evening = sun_at(day, day.last_hour);
  EXPECT_LT(evening.colour.z / evening.colour.x, noon.colour.z / noon.colour.x);
  EXPECT_LT(evening.intensity, noon.intensity);
}

TEST(sun_path, moves_without_jumps_and_time_runs_through_the_day) {
  const SunPath day = day_through("day", sun_toward({0.6f, -0.5f, 0.6f}));
  EXPECT_EQ(hour_at(day, 0.0), day.first_hour);
  EXPECT_EQ(hour_at(day, day.duration_s), day.last_hour);
  EXPECT_EQ(hour_at(day, 1e9), day.last_hour);
  for (double t = 0; t < day.duration_s; t += 0.1) {
    const Light a = light_at(day, t, sun_toward({0, -1, 0})), b = light_at(day, t + 0.1, sun_toward({0, -1, 0}));
    EXPECT_LT(glm::length(a.direction - b.direction), 0.01f);
    EXPECT_LT(std::abs(a.intensity - b.intensity), 0.15f);
    EXPECT_EQ(light_at(day, t, sun_toward({0, -1, 0})).direction, a.direction);
  }
}

TEST(sun_path, knows_the_hour_of_its_own_suns_and_how_far_others_are_off) {
  const SunPath day = day_through("day", sun_toward({0.6f, -0.5f, 0.6f}));
  for (double hour = day.first_hour; hour <= day.last_hour; hour += 0.37) {
    const NearestHour nearest = nearest_hour(day, sun_at(day, hour).direction);
    EXPECT_NEAR(nearest.hour, hour, 0.05);
    EXPECT_LT(nearest.off, 0.5f * k_pi / 180.0f);
  }
  EXPECT_GT(nearest_hour(day, {0, 1, 0}).off, 1.5f);  // from below
}

TEST(recorded_sun, passes_through_its_keys_and_turns_evenly_between) {
  const RecordedSun path{"mine", {{0.0, {{0, -1, 0}, vec3(1.0f), 4.0f}}, {2.0, {{1, 0, 0}, vec3(0.5f), 2.0f}}}};
  EXPECT_EQ(duration_s(path), 2.0);
  EXPECT_EQ(name_of(path), "mine");
  const Light half = light_at(path, 1.0, sun_toward({0, 0, 1}));
  EXPECT_LT(glm::length(half.direction - glm::normalize(vec3(1, -1, 0))), 1e-6f);
  EXPECT_FLOAT_EQ(half.intensity, 3.0f);
  EXPECT_FLOAT_EQ(half.colour.x, 0.75f);
  EXPECT_EQ(light_at(path, -1.0, half).direction, path.keys[0].state.direction);
  EXPECT_EQ(light_at(path, 9.0, half).direction, path.keys[1].state.direction);
  const float third = glm::dot(light_at(path, 2.0 / 3.0, half).direction, vec3(0, -1, 0));
  EXPECT_NEAR(third, std::cos(k_pi / 6.0f), 1e-6f);
}

TEST(default_paths, frame_any_scene) {
  Scene empty;
  add_default_paths(empty);
  EXPECT_EQ(empty.camera_paths.size(), 3u);
  EXPECT_EQ(empty.sun_paths.size(), 1u);
  for (const CameraPath& path : empty.camera_paths) {
    for (double t = 0; t <= duration_s(path); t += 0.5) {
      const CameraPose pose = pose_at(path, t);
      EXPECT_TRUE(std::isfinite(pose.eye.x + pose.target.y)) << path.name;
    }
  }
}

}  // namespace
}  // namespace gnomon
