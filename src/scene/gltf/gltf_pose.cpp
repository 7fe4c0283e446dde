// The shapes that nodes give to meshes.
#include "scene/gltf/gltf_pose.h"

#include <algorithm>

#include "base/interrupt.h"
#include "base/log.h"
#include "scene/finish_part.h"
#include "scene/parallel.h"

namespace gnomon {
namespace {

void bend(const GltfDocument& document, const GltfPart& source, const GltfPose& pose, MeshPart& part) {
  morph(part, source.targets, pose.weights);
  if (pose.skin >= 0) {
    if (const auto vertex = apply_skin(part, source.influences, pose.world_from_bind)) {
      fail("{}: {}.attributes.JOINTS_n: a joint of vertex {} is not among the {} of its skin", document.name(), source.place,
           source.file_vertices[*vertex], pose.world_from_bind.size());
    }
  }
  for (size_t i = 0; i < part.positions.size(); ++i) {
    const vec3& p = part.positions[i];
    if (!std::isfinite(p.x + p.y + p.z))
      fail("{}: {}: the pose moves vertex {} beyond what a number can hold", document.name(), source.place,
           source.file_vertices[i]);
  }
}

}  // namespace

std::vector<Mesh> posed_meshes(GltfDocument& document, std::vector<GltfMesh> meshes, const std::vector<GltfPose>& poses) {
  std::vector<size_t> last_pose(meshes.size(), poses.size());
  for (size_t i = 0; i < poses.size(); ++i) last_pose[static_cast<size_t>(poses[i].mesh)] = i;

  struct Work {
    const GltfPart* source;
    const GltfPose* pose;
    MeshPart* part;
  };
  std::vector<Mesh> result(poses.size());
  std::vector<Work> work;
  for (size_t i = 0; i < poses.size(); ++i) {
    GltfMesh& mesh = meshes[static_cast<size_t>(poses[i].mesh)];
    result[i].name = mesh.name;
    result[i].parts.resize(mesh.parts.size());
    for (size_t k = 0; k < mesh.parts.size(); ++k) {
      check_cancelled();
      GltfPart& source = mesh.parts[k];
      const bool is_last = last_pose[static_cast<size_t>(poses[i].mesh)] == i;
      if (!is_last) document.budget().take(source.part.positions.size() + source.part.indices.size(), source.place);
      MeshPart& part = result[i].parts[k];
      if (is_last) {
        part = std::move(source.part);
      } else {
        part = source.part;
      }
      work.push_back({&source, &poses[i], &part});
    }
  }
  Progress progress("preparing " + document.name(), work.size());
  parallel_for(work.size(), progress, [&](size_t i) {
    bend(document, *work[i].source, *work[i].pose, *work[i].part);
    finish_part(*work[i].part);
  });
  return result;
}

}  // namespace gnomon
