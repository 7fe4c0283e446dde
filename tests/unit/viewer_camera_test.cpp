// Cameras of the viewer: orbit, saved ones, playback, recording.
#include <gtest/gtest.h>

#include "app/viewer/camera/camera_rig.h"
#include "app/viewer/camera/path_player.h"
#include "app/viewer/camera/path_recorder.h"
#include "app/viewer/camera/saved_cameras.h"

namespace gnomon::viewer {
namespace {

Camera camera_at_origin() { return {}; }  // looks along -Z

TEST(CameraRig, an_orbit_keeps_its_distance_and_its_centre) {
  CameraRig rig(camera_at_origin(), 10.0f);
  const vec3 centre(1, 0, -4);
  rig.focus(centre);
  rig.set_orbits(true);
  const float distance = glm::length(centre);
  for (int i = 0; i < 20; ++i) {
    CameraInput input;
    input.look_px = {30.0f, 3.0f};
    ASSERT_TRUE(rig.update(input, 0.1f));
    EXPECT_NEAR(glm::length(centre - rig.camera().eye()), distance, 1e-3f);
    EXPECT_GT(glm::dot(glm::normalize(centre - rig.camera().eye()), rig.camera().forward()), 0.9999f);
  }
  CameraInput closer;
  closer.wheel = 3.0f;
  ASSERT_TRUE(rig.update(closer, 0.1f));
  EXPECT_LT(glm::length(centre - rig.camera().eye()), 0.8f * distance);
  EXPECT_FALSE(rig.update({}, 0.1f));
}

TEST(CameraRig, flies_where_it_does_not_orbit) {
  CameraRig rig(camera_at_origin(), 10.0f);
  CameraInput input;
  input.move = {0, 0, 1};
  ASSERT_TRUE(rig.update(input, 1.0f));
  EXPECT_LT(rig.camera().eye().z, -0.5f);
  input = {};
  input.wheel = 1.0f;
  const float speed = rig.camera().speed();
  EXPECT_FALSE(rig.update(input, 1.0f));
  EXPECT_GT(rig.camera().speed(), speed);
}

TEST(CameraRig, the_first_speed_crosses_any_scene_in_twenty_seconds) {
  for (const float radius_m : {0.5f, 20.0f, 2900.0f}) {
    CameraRig rig(Camera{}, radius_m);
    const vec3 begin = rig.camera().eye();
    CameraInput input;
    input.move = {0, 0, 1};
    for (int i = 0; i < 200; ++i) rig.update(input, 0.1f);
    EXPECT_NEAR(glm::length(rig.camera().eye() - begin), 2.0f * radius_m, 1e-3f * radius_m);
  }
}

TEST(SavedCameras, bring_place_and_lens_back) {
  SavedCameras saved;
  ViewState state;
  saved.store(1, state);
  state.view.camera = "0,0,0:1,0,0";
  state.edits = {{"camera.vertical_fov", "40"}, {"pcf.size", "5"}};
  saved.store(2, state);
  EXPECT_TRUE(saved.recall(1, state));
  EXPECT_EQ(state.view.camera, "");
  EXPECT_EQ(state.edits.size(), 1u);
  EXPECT_TRUE(saved.recall(2, state));
  EXPECT_EQ(state.view.camera, "0,0,0:1,0,0");
  EXPECT_EQ(state.edits.at("camera.vertical_fov"), "40");
  EXPECT_EQ(saved.free_number(), 3);
  saved.remove(1);
  EXPECT_FALSE(saved.recall(1, state));
  EXPECT_EQ(saved.numbers(), std::vector<int>{2});
}

TEST(Playhead, loops_or_stops_at_the_end) {
  Playhead head;
  head.duration_s = 10.0;
  EXPECT_FALSE(head.advance(1.0));
  head.play();
  head.speed = 2.0f;
  EXPECT_TRUE(head.advance(4.0));
  EXPECT_DOUBLE_EQ(head.time_s, 8.0);
  EXPECT_TRUE(head.advance(2.0));
  EXPECT_DOUBLE_EQ(head.time_s, 2.0);
  head.loops = false;
  EXPECT_TRUE(head.advance(100.0));
  EXPECT_DOUBLE_EQ(head.time_s, 10.0);
  EXPECT_FALSE(head.playing);
  head.play();
  EXPECT_DOUBLE_EQ(head.time_s, 0.0);
}

Moment at(float x) { return {{{x, 0, 0}, {0, 0, -1}}, std::nullopt}; }
Moment under(float x, float intensity) { return {at(x).camera, SunState{{0, -1, 0}, vec3(1.0f), intensity}}; }

TEST(PathRecorder, a_walk_becomes_a_path) {
  PathRecorder recorder;
  recorder.start(at(0));
  for (int i = 0; i < 10; ++i) recorder.add(0.04, at(0));  // waits
  for (int i = 1; i <= 25; ++i) recorder.add(0.04, at(0.1f * static_cast<float>(i)));
  for (int i = 0; i < 10; ++i) recorder.add(0.04, at(2.5f));
  const auto recording = recorder.stop("mine");
  ASSERT_TRUE(recording && recording->camera);
  EXPECT_FALSE(recording->sun);
  const CameraPath& path = *recording->camera;
  EXPECT_EQ(path.keys.front().time_s, 0.0);
  EXPECT_EQ(path.keys.front().eye, vec3(0, 0, 0));
  EXPECT_EQ(path.keys.back().eye, vec3(2.5f, 0, 0));
  EXPECT_NEAR(duration_s(path), 1.0, 0.25);
  EXPECT_NEAR(pose_at(path, 0.5 * duration_s(path)).eye.x, 1.25f, 0.3f);
  recorder.start(under(0, 1));
  recorder.add(1.0, under(0, 1));
  EXPECT_FALSE(recorder.stop("nothing"));
}

TEST(PathRecorder, a_sun_that_moves_is_recorded_with_the_times_of_the_walk) {
  PathRecorder recorder;
  recorder.start(under(0, 1));
  recorder.add(1.0, under(1, 1));
  recorder.add(1.0, under(1, 3));
  recorder.add(1.0, under(1, 3));
  const auto both = recorder.stop("both");
  ASSERT_TRUE(both && both->camera && both->sun);
  EXPECT_EQ(duration_s(*both->camera), 2.0);
  EXPECT_EQ(duration_s(*both->sun), 2.0);
  EXPECT_FLOAT_EQ(sun_at_time(*both->sun, 1.0).intensity, 1.0f);
  EXPECT_FLOAT_EQ(sun_at_time(*both->sun, 1.5).intensity, 2.0f);
  recorder.start(under(0, 1));
  recorder.add(1.0, under(0, 2));
  const auto sun = recorder.stop("sun");
  ASSERT_TRUE(sun && sun->sun);
  EXPECT_FALSE(sun->camera);
}

TEST(PathRecorder, a_sun_that_jumps_to_the_other_side_leaves_a_file_that_can_be_read) {
  for (const vec3 way : {vec3(1, 0, 0), vec3(0, -1, 0), glm::normalize(vec3(0.3f, -0.8f, 0.2f))}) {
    PathRecorder recorder;
    Moment moment = {{{}, {0, 0, -1}}, SunState{way, vec3(1.0f), 1.0f}};
    recorder.start(moment);
    moment.sun->direction = -way;
    recorder.add(1.0, moment);
    const auto recording = recorder.stop("flip");
    ASSERT_TRUE(recording && recording->sun);
    const Recording read = parse_recording(recording_text(*recording), "flip.json");
    EXPECT_NEAR(glm::dot(sun_at_time(*read.sun, 1.0).direction, -way), 1.0f, 1e-4f);
    EXPECT_LE(sun_at_time(*read.sun, 0.5).direction.y, 1e-4f) << "not from below";
  }
}

TEST(PathRecorder, a_sun_may_come_and_go) {
  PathRecorder recorder;
  recorder.start(at(0));
  recorder.add(1.0, at(1));
  recorder.add(1.0, under(1, 2));
  recorder.add(1.0, under(1, 3));
  recorder.add(1.0, at(2));
  const auto recording = recorder.stop("mine");
  ASSERT_TRUE(recording && recording->sun);
  EXPECT_FLOAT_EQ(sun_at_time(*recording->sun, 0.0).intensity, 2.0f);
  EXPECT_FLOAT_EQ(sun_at_time(*recording->sun, 4.0).intensity, 3.0f);
}

}  // namespace
}  // namespace gnomon::viewer
