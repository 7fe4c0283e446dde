// Turning upright, blended materials, invariants.
#include "scene/finish_file_scene.h"

#include <algorithm>

#include "base/log.h"
#include "scene/blended.h"
#include "scene/cut_away.h"

namespace gnomon {
namespace {

using namespace scene_file_params;  // up_y, up_z, ...

// The rotation that brings an axis of the file to +Y.
mat4 upright(uint32_t up) {
  const vec4 x(1, 0, 0, 0), y(0, 1, 0, 0), z(0, 0, 1, 0), origin(0, 0, 0, 1);
  if (up == up_z) return {x, -z, y, origin};
  if (up == up_minus_z) return {x, z, -y, origin};
  if (up == up_x) return {y, -x, z, origin};
  return mat4(1.0f);
}

void turn(Scene& scene, const mat4& turned_from_file) {
  const auto turned = [&](const vec3& v) { return mat3(turned_from_file) * v; };
  for (Object& object : scene.objects) object.world_from_object = turned_from_file * object.world_from_object;
  for (Light& light : scene.lights) {
    light.position = turned(light.position);
    light.direction = turned(light.direction);
  }
  for (Camera& camera : scene.cameras) camera.world_from_view = turned_from_file * camera.world_from_view;
}

// A model whose up is another axis lies on its back: high and wide, and thin along its own up. So is a wall, and nothing in
// the file tells them apart. A figure that stands upright with its arms out is thin, too: a fifth of its height.
void hint_at_other_up(const Scene& scene) {
  constexpr float k_thin = 0.15f, k_wide = 0.8f;
  const vec3 extent = scene.bounds().extent();
  // A sheet has no inside that could stand on its back: it is a wall, or a test.
  const bool thin_z = extent.z > 0.0f && extent.z < k_thin * extent.y && extent.x > k_wide * extent.y;
  const bool thin_x = extent.x > 0.0f && extent.x < k_thin * extent.y && extent.z > k_wide * extent.y;
  if (!thin_z && !thin_x) return;
  log_info("{}: {:.3g} m high and only {:.3g} m {}: a wall, or a model whose {} axis points up; for that: --up {}",
           scene.source, extent.y, thin_z ? extent.z : extent.x, thin_z ? "deep" : "wide", thin_z ? "z" : "x",
           thin_z ? "z (or -z)" : "x");
}

}  // namespace

void finish_file_scene(Scene& scene, const SceneFileOptions& options) {
  if (options.params.up != up_y) turn(scene, upright(options.params.up));
  settle_blended(scene, options);
  check_scene(scene);
  warn_of_cut_away(scene);
  const bool chosen = std::find(options.given.begin(), options.given.end(), "up") != options.given.end();
  if (!chosen) hint_at_other_up(scene);
}

}  // namespace gnomon
