// Scene: bounds, counts, content hash, invariants, framing camera, texture transforms.
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/error.h"
#include "base/file.h"
#include "base/temporary_folder.h"
#include "scene/load.h"

namespace gnomon {
namespace {

MeshPart triangle_part() {
  MeshPart part;
  part.positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  part.normals.assign(3, vec3(0, 0, 1));
  part.tangents.assign(3, vec4(1, 0, 0, 1));
  part.uvs = {{0, 1}, {1, 1}, {0, 0}};
  part.colours.assign(3, vec4(1.0f));
  part.indices = {0, 1, 2};
  return part;
}

Scene small_scene() {
  Scene scene;
  scene.name = "small";
  scene.textures.push_back({.name = "t", .image = Image8(2, 2), .srgb = true, .wrap_u = Wrap::repeat, .wrap_v = Wrap::clamp});
  Material material;
  material.base_colour_texture = 0;
  scene.materials.push_back(material);
  scene.meshes.push_back({"mesh", {triangle_part()}});
  Object object;
  scene.objects.push_back(object);
  object.world_from_object = glm::translate(mat4(1.0f), vec3(10, 20, 30));
  scene.objects.push_back(object);
  scene.lights.emplace_back();
  scene.cameras.emplace_back();
  return scene;
}

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Scene, BoundsAndTrianglesCountInstances) {
  const Scene scene = small_scene();
  EXPECT_EQ(scene.triangle_count(), 2u);
  const Box box = scene.bounds();
  EXPECT_EQ(box.min, vec3(0, 0, 0));
  EXPECT_EQ(box.max, vec3(12, 21, 30));
  EXPECT_TRUE(Scene().bounds().empty());
}

TEST(Scene, ContentHashSeesWhatChangesAPictureAndNothingElse) {
  const std::string hash = small_scene().content_hash();
  EXPECT_EQ(hash.size(), 16u);
  EXPECT_EQ(hash, small_scene().content_hash());

  const auto hash_with = [](const std::function<void(Scene&)>& change) {
    Scene scene = small_scene();
    change(scene);
    return scene.content_hash();
  };
  EXPECT_EQ(hash, hash_with([](Scene& s) { s.name = "other", s.objects[0].name = "renamed"; }));
  const std::vector<std::function<void(Scene&)>> changes = {
      [](Scene& s) { s.meshes[0].parts[0].positions[1].x = 3; },
      [](Scene& s) { s.meshes[0].parts[0].normals[1].x = 0.1f; },
      [](Scene& s) { s.meshes[0].parts[0].uvs[1].x = 3; },
      [](Scene& s) { std::swap(s.meshes[0].parts[0].indices[0], s.meshes[0].parts[0].indices[1]); },
      [](Scene& s) { s.textures[0].image.rgba[5] = 1; },
      [](Scene& s) { s.textures[0].wrap_u = Wrap::mirror; },
      [](Scene& s) { s.materials[0].masked = true; },
      [](Scene& s) { s.materials[0].double_sided = true; },
      [](Scene& s) { s.materials[0].normal_uv.row_u.z = 0.5f; },
      [](Scene& s) { s.objects[1].world_from_object[3].x += 1e-3f; },
      [](Scene& s) { s.objects[1].casts = false; },
      [](Scene& s) { s.objects.pop_back(); },
      [](Scene& s) { s.lights[0].radius = 0.1f; },
      [](Scene& s) { s.cameras[0].far = 10.0f; },
  };
  for (size_t i = 0; i < changes.size(); ++i) EXPECT_NE(hash, hash_with(changes[i])) << "change " << i;
}

TEST(Scene, CheckNamesThePlace) {
  EXPECT_NO_THROW(check_scene(small_scene()));
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> breaks = {
      {"materials", [](Scene& s) { s.materials.clear(); }},
      {"textures[0].image", [](Scene& s) { s.textures[0].image.rgba.pop_back(); }},
      {"materials[0].base_colour_texture", [](Scene& s) { s.materials[0].base_colour_texture = 1; }},
      {"materials[0].normal_texture", [](Scene& s) { s.materials[0].normal_texture = -2; }},
      {"meshes[0].parts[0].indices[2]", [](Scene& s) { s.meshes[0].parts[0].indices[2] = 3; }},
      {"meshes[0].parts[0].indices", [](Scene& s) { s.meshes[0].parts[0].indices.pop_back(); }},
      {"meshes[0].parts[0]", [](Scene& s) { s.meshes[0].parts[0].uvs.pop_back(); }},
      {"meshes[0].parts[0].material", [](Scene& s) { s.meshes[0].parts[0].material = 1; }},
      {"meshes[0].parts[0].positions[1]", [=](Scene& s) { s.meshes[0].parts[0].positions[1].y = nan; }},
      {"meshes[0].parts[0].uvs[2]", [=](Scene& s) { s.meshes[0].parts[0].uvs[2].y = inf; }},
      {"meshes[0].parts[0].normals[0]", [](Scene& s) { s.meshes[0].parts[0].normals[0] = vec3(0.0f); }},
      {"meshes[0].parts[0].normals[0]", [=](Scene& s) { s.meshes[0].parts[0].normals[0].x = nan; }},
      {"meshes[0].parts[0].tangents[1].w", [](Scene& s) { s.meshes[0].parts[0].tangents[1].w = 0; }},
      {"objects[1].mesh", [](Scene& s) { s.objects[1].mesh = 1; }},
      {"objects[0].world_from_object", [=](Scene& s) { s.objects[0].world_from_object[2].y = -inf; }},
      {"objects[0].world_from_object", [](Scene& s) { s.objects[0].world_from_object[3].w = 2; }},
      {"lights[0].direction", [](Scene& s) { s.lights[0].direction = vec3(1.0f); }},
      {"lights[0].intensity", [](Scene& s) { s.lights[0].intensity = -1; }},
      {"lights[0].inner_cone", [](Scene& s) { s.lights[0].inner_cone = 1.5f; }},
      {"cameras[0].vertical_fov", [](Scene& s) { s.cameras[0].vertical_fov = 4.0f; }},
      {"cameras[0].near", [](Scene& s) { s.cameras[0].near = 0.0f; }},
      {"cameras[0].far", [](Scene& s) { s.cameras[0].far = 0.05f; }},
  };
  for (const auto& [place, damage] : breaks) {
    Scene scene = small_scene();
    damage(scene);
    const std::string message = error_of([&] { check_scene(scene); });
    EXPECT_TRUE(message.starts_with("small: " + place + ":")) << place << " -> " << message;
  }
}

TEST(Scene, FramingCameraShowsEveryCorner) {
  for (const float size : {1e-3f, 1.0f, 5e4f}) {
    for (const float aspect : {0.5f, 1.0f, 2.4f}) {
      Scene scene = small_scene();
      for (Object& object : scene.objects)
        object.world_from_object = glm::scale(mat4(1.0f), vec3(size)) * object.world_from_object;
      const Camera camera = framing_camera(scene, aspect);
      const mat4 view_from_world = glm::inverse(camera.world_from_view);
      float widest = 0.0f;
      for (const Object& object : scene.objects) {
        for (const vec3& position : scene.meshes[static_cast<size_t>(object.mesh)].parts[0].positions) {
          const vec3 p = vec3(view_from_world * object.world_from_object * vec4(position, 1.0f));
          EXPECT_GT(-p.z, camera.near);
          EXPECT_LT(-p.z, camera.far);
          const float y = std::abs(p.y / p.z) / std::tan(camera.vertical_fov / 2),
                      x = std::abs(p.x / p.z) / std::tan(camera.vertical_fov / 2) / aspect;
          widest = std::max({widest, x, y});
        }
      }
      EXPECT_LE(widest, 1.0f);
      EXPECT_GE(widest, 0.85f) << "the scene should fill the view";
      const vec3 back = vec3(camera.world_from_view[2]);
      EXPECT_NEAR(std::asin(back.y), k_pi / 6, 1e-4f);
      EXPECT_LT(camera.far / camera.near, 1e4f);
      scene.cameras = {camera};
      EXPECT_NO_THROW(check_scene(scene));
    }
  }
}

// The share of the picture between the outermost vertices, across and up; 1: from edge to edge.
vec2 framed_share(const vec3& size, const vec3& place) {
  Scene scene;
  scene.materials.emplace_back();
  MeshPart part;
  for (int i = 0; i < 8; ++i) part.positions.push_back(place + Box{-0.5f * size, 0.5f * size}.corner(i));
  scene.meshes.resize(1);
  scene.meshes[0].parts.push_back(part);
  scene.objects.emplace_back();
  const Camera camera = framing_camera(scene, 4.0f / 3.0f);
  const mat4 view_from_world = glm::inverse(camera.world_from_view);
  vec2 low(2.0f), high(-2.0f);
  for (const vec3& position : part.positions) {
    const vec3 p(view_from_world * vec4(position, 1.0f));
    EXPECT_GT(-p.z, camera.near);
    const vec2 seen = vec2(p) / -p.z / std::tan(camera.vertical_fov / 2) / vec2(4.0f / 3.0f, 1.0f);
    low = glm::min(low, seen), high = glm::max(high, seen);
  }
  EXPECT_TRUE(glm::all(glm::greaterThan(low, vec2(-1.0f))) && glm::all(glm::lessThan(high, vec2(1.0f))));
  return 0.5f * (high - low);
}

TEST(Scene, FramingCameraFillsThePicture) {
  const vec3 town(1000, 10, 700), strip(1000, 10, 20), deep_strip(20, 10, 1000), tower(10, 100, 10), cube(1),
      sheet(4000, 0, 3000);
  for (const vec3& size : {town, strip, deep_strip, tower, cube, sheet, 1e-6f * town, 1e-6f * cube, 1e6f * town}) {
    const vec2 share = framed_share(size, {0, 0, 0});
    EXPECT_GT(std::max(share.x, share.y), 0.93f) << size.x << " " << size.y << " " << size.z;
    EXPECT_GT(std::min(share.x, share.y), 0.1f) << size.x << " " << size.y << " " << size.z;
  }
  EXPECT_GT(framed_share(town, {0, 0, 0}).y, 0.4f) << "a flat town";
  EXPECT_GT(framed_share(cube, {500, 3, -200}).y, 0.9f) << "and far away";
}

// A box, closed, or of no height: a sheet.
MeshPart box_part(const vec3& centre, const vec3& size) {
  MeshPart part;
  for (int i = 0; i < 8; ++i) part.positions.push_back(centre + Box{-0.5f * size, 0.5f * size}.corner(i));
  part.indices = {0, 5, 4, 0, 1, 5, 2, 6, 7, 2, 7, 3};  // below and above
  if (size.y > 0.0f)
    part.indices.insert(part.indices.end(), {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6});
  return part;
}

// Each part an object of its own, or all in one mesh.
Scene scene_of(const std::vector<MeshPart>& parts, bool apart = true) {
  Scene scene;
  scene.materials.emplace_back();
  for (const MeshPart& part : parts) {
    if (apart || scene.meshes.empty()) {
      scene.meshes.emplace_back();
      scene.objects.emplace_back().mesh = static_cast<int>(scene.meshes.size()) - 1;
    }
    scene.meshes.back().parts.push_back(part);
  }
  return scene;
}

// How much of a square picture they take, across or up, whichever is more; 0 where the picture cuts them.
float share_of(const std::vector<MeshPart>& parts, const Camera& camera) {
  std::vector<vec3> positions;
  for (const MeshPart& part : parts) positions.insert(positions.end(), part.positions.begin(), part.positions.end());
  const mat4 view_from_world = glm::inverse(camera.world_from_view);
  vec2 low(2.0f), high(-2.0f);
  for (const vec3& position : positions) {
    const vec3 p(view_from_world * vec4(position, 1.0f));
    if (-p.z <= camera.near || -p.z >= camera.far) return 0.0f;
    const vec2 seen = vec2(p) / -p.z / std::tan(camera.vertical_fov / 2);
    low = glm::min(low, seen), high = glm::max(high, seen);
  }
  if (low.x < -1.0f || low.y < -1.0f || high.x > 1.0f || high.y > 1.0f) return 0.0f;
  return 0.5f * std::max(high.x - low.x, high.y - low.y);
}

// What stands on a ground that goes on to a horizon is seen, however few its vertices are beside those of the ground.
TEST(Scene, FramingCameraLeavesOutAFarHorizon) {
  std::vector<MeshPart> town;
  for (int x = -5; x <= 5; ++x) {
    for (int z = -5; z <= 5; ++z)
      town.push_back(box_part({20.0f * static_cast<float>(x) + 300.0f, 5, 20.0f * static_cast<float>(z)}, vec3(10)));
  }
  const std::vector<MeshPart> house = {box_part({300, 5, 20}, vec3(10))};
  const std::vector<MeshPart> sunk = {box_part({300, 3, 20}, vec3(10))};
  std::vector<MeshPart> tiles;  // smaller than the house, and no corner shared
  for (int x = 0; x < 80; ++x) {
    for (int z = 0; z < 80; ++z)
      tiles.push_back(
          box_part({300.0f + 5.0f * static_cast<float>(x - 40), 0, 5.0f * static_cast<float>(z - 40)}, vec3(4.9f, 0, 4.9f)));
  }
  MeshPart grid;  // many vertices, a little uneven
  for (int x = 0; x <= 100; ++x) {
    for (int z = 0; z <= 100; ++z)
      grid.positions.emplace_back(40.0f * static_cast<float>(x - 50), -static_cast<float>((x * 7 + z * 3) % 5) * 0.2f,
                                  40.0f * static_cast<float>(z - 50));
  }
  for (uint32_t x = 0; x < 100; ++x) {
    for (uint32_t z = 0; z < 100; ++z) {
      const uint32_t i = x * 101 + z;
      for (const uint32_t k : {i, i + 1, i + 102, i, i + 102, i + 101}) grid.indices.push_back(k);
    }
  }
  const std::vector<std::vector<MeshPart>> grounds = {
      {box_part({0, 0, 0}, {4000, 0, 4000})},
      {box_part({0, -5, 0}, {4000, 10, 4000})},
      {box_part({0, 0, 0}, {1e5f, 0, 1e5f})},
      {grid},
      tiles,
      {box_part({0, 0, 0}, {1e5f, 0, 1e5f}), box_part({0, -0.1f, 0}, {3000, 0.2f, 3000})}};
  for (const bool apart : {true, false}) {
    for (size_t g = 0; g < grounds.size(); ++g) {
      for (const auto& standing : {town, house, sunk}) {
        if (&grounds[g] == &grounds[4] && standing.size() > 1) continue;  // the town is as wide as half of its tiles
        std::vector<MeshPart> parts = grounds[g];
        parts.insert(parts.end(), standing.begin(), standing.end());
        const Camera camera = framing_camera(scene_of(parts, apart), 1.0f);
        EXPECT_GT(share_of(standing, camera), 0.25f) << apart << " ground " << g << ", " << standing.size();
        EXPECT_GT(camera.far, g == 4 ? 250.0f : 2000.0f) << "the ground is still there";
      }
    }
  }
}

TEST(Scene, FramingCameraKeepsWhatIsNoGround) {
  const MeshPart floor = box_part({0, 0, 0}, {10, 0, 10}), crate = box_part({0, 1, 0}, vec3(2));
  const MeshPart table = box_part({0, 1, 0}, {40, 0, 40}), leg = box_part({0, 0.5f, 0}, vec3(0.2f, 1, 0.2f));
  const MeshPart above = box_part({0, 3, 0}, vec3(4, 0, 4)), highest = box_part({0, 5, 0}, vec3(0.4f, 0, 0.4f));
  const MeshPart hill = box_part({0, 200, 0}, {4000, 400, 4000});
  const std::vector<std::vector<MeshPart>> scenes = {
      {floor},         // nothing stands on it
      {floor, crate},  // seen well enough, and its shadow
      {table, leg},    // the wide one is above
      {floor, above, highest},
      {hill, box_part({0, 405, 0}, vec3(10))},
  };
  for (size_t i = 0; i < scenes.size(); ++i)
    EXPECT_GT(share_of(scenes[i], framing_camera(scene_of(scenes[i]), 1.0f)), 0.85f) << "scene " << i;
}

TEST(Scene, FramingCameraLeavesOutStrays) {
  const std::vector<MeshPart> rest = {box_part({0, 0, 0}, {10, 0, 10}), box_part({0, 1, 0}, vec3(2)),
                                      box_part({3, 1, 0}, vec3(2))};
  for (const vec3& place : {vec3(2e6f, 0, 0), vec3(0, 0, -3000), vec3(0, 1e5f, 0)}) {
    MeshPart sliver;  // from a corner of the floor
    sliver.positions = {{5, 0, 5}, {5, 0, -5}, place};
    sliver.indices = {0, 1, 2};
    for (const MeshPart& stray : {sliver, box_part(place, vec3(2))}) {
      for (const bool apart : {true, false}) {
        std::vector<MeshPart> parts = rest;
        parts.push_back(stray);
        EXPECT_GT(share_of(rest, framing_camera(scene_of(parts, apart), 1.0f)), 0.5f)
            << place.x << " " << place.y << " " << apart;
      }
    }
  }
  const MeshPart panel = box_part({2e6f, 1, 0}, vec3(2, 2, 1e-3f));
  EXPECT_GT(share_of({rest[0]}, framing_camera(scene_of({rest[0], rest[0], rest[0], panel}), 1.0f)), 0.5f) << "ground alone";
  // Half of a scene far away: what lies at the origin.
  EXPECT_GT(share_of({rest[1]}, framing_camera(scene_of({box_part({2e6f, 1, 0}, vec3(2)), rest[1]}), 1.0f)), 0.5f);
}

TEST(Scene, FramingCameraOfNothingIsValid) {
  Scene scene;
  scene.materials.emplace_back();
  scene.cameras = {framing_camera(scene, 1.5f)};
  EXPECT_NO_THROW(check_scene(scene));
}

TEST(UvTransform, ScaleThenRotationThenOffset) {
  const UvTransform t = UvTransform::from({0.0f, 1.0f}, k_pi / 2, {0.5f, 0.5f});
  // The example of KHR_texture_transform: the lower left quadrant of the picture, turned.
  const auto expect = [&](vec2 in, vec2 out) {
    EXPECT_NEAR(t.apply(in).x, out.x, 1e-6f);
    EXPECT_NEAR(t.apply(in).y, out.y, 1e-6f);
  };
  expect({0, 0}, {0.0f, 1.0f});
  expect({1, 0}, {0.0f, 0.5f});
  expect({0, 1}, {0.5f, 1.0f});
  expect({1, 1}, {0.5f, 0.5f});
  const UvTransform uneven = UvTransform::from({0, 0}, k_pi / 2, {2.0f, 3.0f});
  EXPECT_NEAR(uneven.apply({1, 0}).y, -2.0f, 1e-6f);
  EXPECT_NEAR(uneven.apply({0, 1}).x, 3.0f, 1e-6f);
}

TEST(LoadScene, UnknownNameIsAUsageErrorThatListsWhatIsValid) {
  try {
    load_scene("no_such_scene");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("no_such_scene:"));
    EXPECT_NE(message.find(".glb"), std::string::npos);
    for (const BuiltinScene& scene : builtin_scenes()) EXPECT_NE(message.find(scene.name), std::string::npos);
  }
}

TEST(LoadScene, MissingFileIsAFailureThatNamesThePath) {
  for (const std::string path : {"/nowhere/scene.obj", "/nowhere/scene.GLB", "/nowhere/scene.gltf"}) {
    try {
      load_scene(path);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::failure);
      EXPECT_TRUE(std::string(error.what()).starts_with(path + ": ")) << error.what();
    }
  }
}

TEST(LoadScene, WhatOnlyGltfHasIsRefusedForObj) {
  SceneFileOptions scenes, animation, time;
  scenes.gltf_scene = "0", animation.animation = "run", time.params.time = 1.5f;
  for (const auto& [options, says] :
       {std::pair(scenes, "--gltf-scene 0"), {animation, "--animation run"}, {time, "--time 1.5"}}) {
    const std::string message = error_of([&, given = options] { load_scene("/nowhere/scene.obj", {}, given); });
    EXPECT_NE(message.find(says), std::string::npos) << message;
  }
}

TEST(LoadScene, WhatOnlyObjHasIsRefusedForGltf) {
  SceneFileOptions options;
  options.params.alpha_from_colour = scene_file_params::alpha_from_colour_on;
  const std::string message = error_of([&] { load_scene("/nowhere/scene.gltf", {}, options); });
  EXPECT_NE(message.find("scene.alpha_from_colour"), std::string::npos) << message;
}

TEST(LoadScene, WhatHasNoNameGetsOne) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "nameless.obj";
  write_file(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Scene scene = load_scene(path.string());
  for (const Object& object : scene.objects) EXPECT_FALSE(object.name.empty());
  const auto gltf = folder.path() / "nameless.gltf";
  write_file(
      gltf,
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"","mesh":0}],"materials":[{"name":""}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],"accessors":[{"bufferView":0,"componentType":5126,)"
      R"("type":"VEC3","count":3}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
      R"("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  scene = load_scene(gltf.string());
  EXPECT_EQ(scene.objects.at(0).name, "objects[0]");
  for (const Material& material : scene.materials) EXPECT_FALSE(material.name.empty());
}

TEST(LoadScene, OptionsAreChecked) {
  EXPECT_THROW(load_scene("/nowhere/scene.obj", {{"gap", 1.0}}), Error);
  for (const BuiltinScene& scene : builtin_scenes()) {
    const std::string message = error_of([&] { load_scene(scene.name, {{"no_such_option", 1.0}}); });
    EXPECT_TRUE(message.starts_with("scene.no_such_option:")) << message;
    for (const BuiltinOption& option : scene.options) {
      EXPECT_THROW(load_scene(scene.name, {{option.name, option.max + 1.0}}), Error);
      EXPECT_NO_THROW(load_scene(scene.name, {{option.name, option.default_value}}));
      EXPECT_NE(message.find(option.name), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace gnomon
