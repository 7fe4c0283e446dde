#include "scene/cut_away.h"

#include <algorithm>

#include "base/log.h"
#include "scene/lost_pictures.h"
#include "scene/texture_tools.h"

namespace gnomon {
namespace {

bool is_cut_away(const Scene& scene, const Material& material) {
  if (!material.masked) return false;
  const int texture = material.base_colour_texture;
  const float most = texture == k_no_texture
                         ? 1.0f
                         : static_cast<float>(greatest_alpha(scene.textures[static_cast<size_t>(texture)].image)) / 255.0f;
  return material.base_colour.w * most < material.seen_cutoff();
}

}  // namespace

void warn_of_cut_away(const Scene& scene) {
  std::vector<bool> used(scene.materials.size(), false);
  for (const Mesh& mesh : scene.meshes) {
    for (const MeshPart& part : mesh.parts) used[static_cast<size_t>(part.material)] = true;
  }
  std::vector<std::string> names;
  for (size_t i = 0; i < used.size(); ++i) {
    const Material& material = scene.materials[i];
    if (!used[i] || !is_cut_away(scene, material)) continue;
    if (std::find(names.begin(), names.end(), material.name) == names.end()) names.push_back(material.name);
  }
  if (names.empty()) return;
  log_warning(
      "{}: alpha-tested materials that are cut away as a whole: {}; all of their alpha is below the cutoff, so that nothing of "
      "them is seen or casts",
      scene.file_or_name(), first_names(names));
}

}  // namespace gnomon
