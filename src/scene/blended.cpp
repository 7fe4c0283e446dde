// One rule for the loaders of all formats.
#include "scene/blended.h"

#include <string_view>

#include "base/log.h"
#include "scene/lost_pictures.h"

namespace gnomon {
namespace {

using namespace scene_file_params;  // blend_casts_opaque, _mask, _none

void settle(Material& material, uint32_t rule) {
  const float alpha = material.base_colour.w;
  const bool holes = material.masked;
  if (rule == blend_casts_none) material.casts = false;
  if (rule == blend_casts_mask) material.casts = alpha >= 0.5f, material.half_casts = holes;
  // To the camera the texture alone says where there is something: as a share of the material's own alpha.
  material.alpha_cutoff = 0.5f * alpha;
  // As the camera sees it, so it casts; the material's own alpha may be 0.
  if (rule == blend_casts_opaque && holes) material.base_colour.w = 1.0f, material.alpha_cutoff = 0.5f;
}

std::string_view outcome(uint32_t rule) {
  if (rule == blend_casts_opaque) return "they cast as if they were solid";
  return rule == blend_casts_none ? "they cast no shadow" : "what of them is below half its opacity casts no shadow";
}

}  // namespace

void settle_blended(Scene& scene, const SceneFileOptions& options) {
  const uint32_t rule = options.params.blend_casts;
  std::vector<std::string> names;
  for (Material& material : scene.materials) {
    if (!material.blended) continue;
    if (material.masked || material.base_colour.w < 1.0f) names.push_back(material.name);
    settle(material, rule);
  }
  if (names.empty()) return;
  log_warning("{}: blended materials: {}; {} (scene.blend_casts, or --cast NAME=on|off)",
              scene.source.empty() ? scene.name : scene.source, first_names(names), outcome(rule));
}

}  // namespace gnomon
