// What the user keeps when another scene is opened: the list to compare, cameras by scene, the second side's settings.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/viewer/compare/comparison.h"
#include "app/viewer/state/scene_work.h"
#include "app/viewer/state/start_settings.h"
#include "base/file.h"
#include "base/temporary_folder.h"
#include "scene/load.h"

namespace gnomon::viewer {
namespace {

Light light(const std::string& name, LightKind kind) {
  Light light;
  light.name = name;
  light.kind = kind;
  return light;
}

ViewState state_of(const std::string& scene, const std::string& technique, std::map<std::string, std::string> edits) {
  ViewState state;
  state.view.scene = scene;
  state.techniques = {technique};
  state.edits = std::move(edits);
  return state;
}

bool holds(const std::vector<std::string>& words, const std::string& option, const std::string& value) {
  const std::array pair = {option, value};
  return std::search(words.begin(), words.end(), pair.begin(), pair.end()) != words.end();
}

TEST(Comparison, measures_rows_of_other_scenes_in_the_one_that_is_shown) {
  Comparison comparison({});
  EXPECT_TRUE(comparison.add(state_of("courtyard", "single/pcf", {{"pcf.size", "5"}, {"light.elevation", "30"}})));
  EXPECT_FALSE(comparison.add(state_of("town", "single/pcf", {{"pcf.size", "5"}}))) << "a row belongs to no scene";
  ViewState now = state_of("town", "single/hard", {{"light.elevation", "50"}, {"frame.ambient", "0.1"}});
  now.view.camera = "1,2,3:4,5,6";
  const auto words = comparison.words(0, now, {320, 200});
  EXPECT_EQ(words.at(1), "town");
  EXPECT_TRUE(holds(words, "--camera", "1,2,3:4,5,6"));
  EXPECT_TRUE(holds(words, "--techniques", "single/pcf"));
  EXPECT_TRUE(holds(words, "--set", "pcf.size=5"));
  EXPECT_TRUE(holds(words, "--set", "light.elevation=50"));
  EXPECT_FALSE(holds(words, "--set", "light.elevation=30"));
}

TEST(Comparison, leaves_out_what_the_lights_of_this_scene_do_not_allow) {
  Comparison comparison({});
  comparison.add(state_of("courtyard", "single/pcf", {{"pcf.size", "5"}}));
  comparison.add(state_of("courtyard", "single/pcf", {{"sun@pcf.size", "7"}}));
  comparison.add(state_of("lamps", "cube/pcf", {}));
  const std::array suns = {light("sun", LightKind::directional)}, moons = {light("moon", LightKind::directional)};
  EXPECT_EQ(comparison.obstacle(0, suns), "");
  EXPECT_EQ(comparison.obstacle(1, suns), "");
  EXPECT_NE(comparison.obstacle(2, suns), "") << "no point light";
  EXPECT_EQ(comparison.measurable(suns), 2u);
  EXPECT_NE(comparison.obstacle(1, moons).find("'sun'"), std::string::npos) << comparison.obstacle(1, moons);
  const std::array both = {suns[0], light("lamp", LightKind::point)};
  EXPECT_EQ(comparison.measurable(both), 3u);
}

TEST(SceneWorks, keep_cameras_by_scene) {
  SceneWorks works;
  ViewState state;
  state.view.camera = "0,0,0:1,0,0";
  SceneWork& first = works.of("courtyard");
  first.cameras.store(1, state);
  EXPECT_TRUE(works.of("town").cameras.numbers().empty());
  EXPECT_EQ(&works.of("courtyard"), &first);
  EXPECT_EQ(works.of("courtyard").cameras.numbers(), std::vector<int>{1});
}

TEST(SceneWorks, know_a_file_by_any_path_to_it) {
  const TemporaryFolder temporary;
  const std::filesystem::path& folder = temporary.path();
  make_folder(folder / "sub");
  write_file(folder / "model.obj", "v 0 0 0\n");
  SceneWorks works;
  EXPECT_EQ(&works.of((folder / "model.obj").string()), &works.of((folder / "sub" / ".." / "model.obj").string()));
  EXPECT_NE(&works.of((folder / "model.obj").string()), &works.of((folder / "other.obj").string()));
}

TEST(SceneWorks, know_that_a_scene_is_shown_already) {
  EXPECT_TRUE(same_scene("courtyard", "courtyard"));
  EXPECT_FALSE(same_scene("courtyard", "town"));
  const TemporaryFolder temporary;
  const std::filesystem::path path = temporary.path() / "a.obj";
  write_file(path, "v 0 0 0\n");
  EXPECT_TRUE(same_scene(path.string(), std::filesystem::relative(path).string()));
  EXPECT_FALSE(same_scene(path.string(), (temporary.path() / "b.obj").string()));
}

TEST(StartSettings, are_without_what_the_panels_changed) {
  const Scene scene = load_scene("chart/slab", {});
  ViewState state = state_of("chart/slab", "single/pcf", {});
  state.base.assign("light.elevation=30");
  state.base.assign("frame.exposure=2");
  const double azimuth = start_settings(state, scene).block("light").number("azimuth");
  state.edits = {{"light.azimuth", "77"}, {"light.elevation", "20"}, {"frame.exposure", "3"}, {"camera.vertical_fov", "99"}};
  const Settings start = start_settings(state, scene);
  EXPECT_EQ(start.block("light").number("azimuth"), azimuth) << "the scene's";
  EXPECT_NEAR(start.block("light").number("elevation"), 30.0, 1e-4);
  EXPECT_EQ(start.block("frame").number("exposure"), 2.0);
  EXPECT_NE(start.block("camera").number("vertical_fov"), 99.0);
}

TEST(ViewState, goes_to_another_scene_without_what_is_of_the_old_one) {
  ViewState state = state_of("courtyard", "single/pcf",
                             {{"pcf.size", "5"}, {"sun@pcf.size", "7"}, {"light.elevation", "30"}, {"camera.near", "1"}});
  state.base.assign("single.size=512");
  state.base.assign("scene.gap=2");
  state.view.camera = "0,0,0:1,0,0";
  state.view.lights = {"all"};
  const ViewState next = state_for_scene(state, "town");
  EXPECT_EQ(next.view.scene, "town");
  EXPECT_EQ(next.view.camera, "");
  EXPECT_TRUE(next.view.lights.empty());
  EXPECT_EQ(next.techniques, state.techniques);
  EXPECT_TRUE(next.edits.empty());
  EXPECT_EQ(next.base.assignments(), (std::vector<std::string>{"single.size=512", "pcf.size=5"}));
}

}  // namespace
}  // namespace gnomon::viewer
