// Objects whose transform mirrors or flattens: the picture and the rays must be those of the mesh with the transform in its
// vertices.
#include <algorithm>

#include "reference/pipeline_reference.h"
#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using test::device;
using test::View;

// The same triangles with the object's transform applied to them, fronts kept.
Scene baked(Scene scene) {
  for (Object& object : scene.objects) {
    Mesh mesh = scene.meshes[static_cast<size_t>(object.mesh)];
    const glm::mat3 m(object.world_from_object);
    const bool mirrors = glm::determinant(m) < 0.0f;
    for (MeshPart& part : mesh.parts) {
      for (vec3& p : part.positions) p = vec3(object.world_from_object * vec4(p, 1.0f));
      if (mirrors) {
        for (size_t i = 0; i < part.indices.size(); i += 3) std::swap(part.indices[i + 1], part.indices[i + 2]);
      }
    }
    object.mesh = static_cast<int>(scene.meshes.size());
    object.world_from_object = mat4(1.0f);
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

// A lopsided box over a floor, placed by `transform`; seen and lit from the side.
Scene placed_box(const mat4& transform) {
  Scene scene = test::scene_with({test::floor_part(4.0f), test::box_part({0.2f, 0.3f, -0.5f}, {1.5f, 1.1f, 0.4f})});
  scene.objects[1].world_from_object = transform;
  scene.lights.push_back(test::make_sun({-0.5f, -0.8f, 0.3f}));
  Camera camera;
  camera.world_from_view = glm::inverse(glm::lookAt(vec3(3.0f, 4.0f, 5.0f), vec3(0.0f), vec3(0, 1, 0)));
  scene.cameras.push_back(camera);
  return scene;
}

struct Seen {
  std::vector<float> view_z, embree, pipeline;
};

Seen look_at(Scene scene) {
  View view(std::move(scene), {96, 72});
  view.draw();
  const Light& sun = view.scene().lights[0];
  return {
      test::read_surface<float>(view, "surface view_z"),
      EmbreeReference(view.scene())
          .trace(view.frame().read_points(), view.frame().camera().eye_ws, sun, false, 1, 1)
          .visibility,
      PipelineReference(device(), view.context().acceleration_structure()).trace(view.frame(), sun, false, 1, 1).visibility};
}

void expect_same_as_baked(const std::string& name, const mat4& transform) {
  const Seen placed = look_at(placed_box(transform)), fixed = look_at(baked(placed_box(transform)));
  const size_t count = placed.view_z.size();
  size_t depth_differs = 0, pipeline_differs = 0, embree_differs = 0, tracers_differ = 0, shadowed = 0;
  for (size_t i = 0; i < count; ++i) {
    depth_differs += std::abs(placed.view_z[i] - fixed.view_z[i]) > 1e-3f;
    pipeline_differs += placed.pipeline[i] != fixed.pipeline[i];
    embree_differs += placed.embree[i] != fixed.embree[i];
    tracers_differ += placed.embree[i] != placed.pipeline[i];
    shadowed += fixed.pipeline[i] == 0.0f;
  }
  // Rounding may move a pixel of an outline.
  EXPECT_LE(depth_differs, count / 500) << name;
  EXPECT_LE(pipeline_differs, count / 500) << name;
  EXPECT_LE(embree_differs, count / 500) << name;
  EXPECT_LE(tracers_differ, count / 500) << name;
  EXPECT_GT(shadowed, count / 100) << name << ": there is something to see";
}

TEST(Placement, MirroredObjects) {
  expect_same_as_baked("across x", glm::scale(mat4(1.0f), vec3(-1, 1, 1)));
  expect_same_as_baked("across z, turned",
                       glm::rotate(mat4(1.0f), 0.7f, vec3(0, 1, 0)) * glm::scale(mat4(1.0f), vec3(1, 1, -1.3f)));
}

TEST(Placement, FlattenedObjectsCast) {
  const mat4 lift = glm::translate(mat4(1.0f), vec3(0.0f, 0.8f, 0.0f));
  expect_same_as_baked("flat", lift * glm::scale(mat4(1.0f), vec3(1.5f, 0.0f, 1.5f)));
}

}  // namespace
}  // namespace gnomon
