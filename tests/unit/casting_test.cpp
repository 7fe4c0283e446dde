// Casting by name: which rule counts, what is refused, and that rays leave out what it switches off.
#include "scene/casting.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "hand_made_scene.h"
#include "reference/cpu/embree_reference.h"

namespace gnomon {
namespace {

// Above the floor hang two tables, left and right, each of a part "wood" (x from -1 to 0 of it) and one "glass" (0 to 1).
Scene two_tables() {
  Scene scene = test::empty_scene();
  scene.materials.resize(3);
  scene.materials[0].name = "stone", scene.materials[1].name = "wood", scene.materials[2].name = "glass";
  test::add(scene, test::floor_quad(10.0f)).name = "floor";
  Mesh table;
  table.parts = {test::quad({-0.5f, 1, 0}, {0, 0, 1}, {0.5f, 0, 0}), test::quad({0.5f, 1, 0}, {0, 0, 1}, {0.5f, 0, 0})};
  table.parts[0].material = 1, table.parts[1].material = 2;
  scene.meshes.push_back(table);
  for (const float x : {-3.0f, 3.0f}) {
    Object object;
    object.name = x < 0 ? "table left" : "table right";
    object.mesh = 1;
    object.world_from_object = glm::translate(mat4(1.0f), vec3(x, 0, 0));
    scene.objects.push_back(object);
  }
  return scene;
}

// Which of the four parts cast: wood and glass of the left table, then of the right one. Traced.
// Something far below always casts: a reference without casters is refused.
std::string casting(Scene scene) {
  scene.materials.emplace_back();
  MeshPart below = test::floor_quad(1.0f, -9.0f);
  below.material = static_cast<int>(scene.materials.size()) - 1;
  test::add(scene, below);
  std::vector<SurfacePoint> points;
  for (const float x : {-3.5f, -2.5f, 2.5f, 3.5f}) points.push_back(test::floor_point(x, 0));
  const auto visibility = EmbreeReference(scene).trace(points, {0, 10, 0}, test::sun({0, -1, 0}), false, 1, 0).visibility;
  std::string text;
  for (const float v : visibility) text += v == 0.0f ? '#' : '.';
  return text;
}

std::string casting_with(const std::vector<std::string>& rules) {
  Scene scene = two_tables();
  apply_casting(scene, rules);
  return casting(scene);
}

TEST(Casting, ObjectsAndMaterialsByName) {
  EXPECT_EQ(casting_with({}), "####");
  EXPECT_EQ(casting_with({"table left=off"}), "..##");
  EXPECT_EQ(casting_with({"glass=off"}), "#.#.");
  EXPECT_EQ(casting_with({"table*=off"}), "....");
  EXPECT_EQ(casting_with({"table ?e*=off"}), "..##");
  EXPECT_EQ(casting_with({"w[aeiou]od=off", "table right=off"}), ".#..");
}

TEST(Casting, TheLastRuleThatFitsCounts) {
  EXPECT_EQ(casting_with({"*=off", "table left=on"}), "##..") << "of objects over materials";
  EXPECT_EQ(casting_with({"*=off", "glass=on"}), ".#.#") << "and of materials over objects";
  EXPECT_EQ(casting_with({"table left=on", "*=off"}), "....");
  EXPECT_EQ(casting_with({"table left=off", "glass=on"}), ".###");
}

TEST(Casting, RulesOutrankTheSceneAndReplaceEarlierOnes) {
  Scene scene = two_tables();
  scene.objects[1].casts = false, scene.materials[2].casts = false;
  EXPECT_EQ(casting(scene), "..#.");
  apply_casting(scene, std::vector<std::string>{"table left=on", "glass=on"});
  EXPECT_EQ(casting(scene), "####");
  const std::string named = scene.content_hash();
  apply_casting(scene, {});
  EXPECT_EQ(casting(scene), "..#.");
  EXPECT_NE(scene.content_hash(), named);
}

TEST(Casting, WhatIsWrongIsAUsageErrorAndChangesNothing) {
  for (const char* rule : {"", "glass", "glass=", "glass=yes", "=on", "glass=off=1"}) {
    Scene scene = two_tables();
    try {
      apply_casting(scene, std::vector<std::string>{"wood=off", rule});
      ADD_FAILURE() << "accepted: " << rule;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::usage);
      EXPECT_NE(std::string(error.what()).find("GLOB=on or GLOB=off"), std::string::npos) << error.what();
    }
    EXPECT_EQ(casting(scene), "####");
  }
  Scene scene = two_tables();
  try {
    apply_casting(scene, std::vector<std::string>{"wood=off", "chair*=off"});
    ADD_FAILURE() << "nothing is called chair";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    for (const char* name : {"chair*", "'table left'", "'glass'"})
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
  EXPECT_EQ(casting(scene), "####");
}

TEST(Casting, NamesWithTheLettersOfPatterns) {
  Scene scene = two_tables();
  scene.objects[1].name = "nodes[3]", scene.objects[2].name = "nodes3";
  const auto off = [&](const char* rule) {
    apply_casting(scene, std::vector<std::string>{rule});
    return std::string(object_casts(scene, scene.objects[1]) ? "on" : "off") +
           (object_casts(scene, scene.objects[2]) ? " on" : " off");
  };
  EXPECT_EQ(off("nodes[3]=off"), "off on") << "the name itself";
  EXPECT_EQ(off("nodes[0-9]=off"), "on off") << "no name: a pattern";
  EXPECT_EQ(off("nodes*=off"), "off off");
}

TEST(Casting, ARuleOfAFileIsRefusedByThatFile) {
  Scene scene = two_tables();
  for (const char* rule : {"chair=off", "chair"}) {
    try {
      apply_casting(scene, std::vector<std::string>{rule}, {{rule, "mine.json"}});
      ADD_FAILURE() << "accepted: " << rule;
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("mine.json: 'casts': chair")) << error.what();
    }
  }
}

TEST(Casting, AListSwitchesOneNameWhateverItsLetters) {
  Scene scene = two_tables();
  scene.objects[1].name = "a*[b]\\?";
  std::vector<std::string> rules = {"wood=off"};
  for (const bool on : {false, true, false}) {
    set_cast(rules, scene.objects[1].name, on);
    apply_casting(scene, rules);
    EXPECT_EQ(object_casts(scene, scene.objects[1]), on);
    EXPECT_TRUE(object_casts(scene, scene.objects[2]));
    EXPECT_EQ(rules.size(), 2u);
  }
}

}  // namespace
}  // namespace gnomon
