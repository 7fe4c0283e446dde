// One rule for the loaders of all formats.
#include "scene/blended.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "base/log.h"
#include "scene/lost_pictures.h"
#include "scene/texture_tools.h"

namespace gnomon {
namespace {

using namespace scene_file_params;  // blend_casts_opaque, _mask, _none

class Settler {
 public:
  Settler(Scene& scene, uint32_t rule) : scene_(scene), rule_(rule) {}

  void settle(Material& material) {
    const int picture = material.base_colour_texture;
    const bool holes = material.masked;
    if (holes) see_through_clear_texels(material);
    if (rule_ == blend_casts_none) material.casts = false;
    if (rule_ == blend_casts_mask) {
      const float most = holes ? static_cast<float>(greatest_alpha(image(picture))) / 255.0f : 1.0f;
      material.casts = material.base_colour.w * most >= 0.5f;
      material.half_casts = material.casts && holes;
      if (material.half_casts) material.half_texture = picture;
    }
    // What the camera sees goes by the texture alone, and so does what casts, unless half opacity decides.
    if (holes && !material.half_casts) material.base_colour.w = 1.0f;
    material.alpha_cutoff = 0.5f * material.base_colour.w;
  }

 private:
  const Image8& image(int texture) const { return scene_.textures[static_cast<size_t>(texture)].image; }

  // By a picture of its own whose alpha is all or nothing: half of that between two texels, and in mipmaps half of the texels,
  // keeps outlines where they are at any distance. A cutoff just above 0 would make leaves as large as their sheets.
  void see_through_clear_texels(Material& material) {
    const auto [entry, is_new] = seen_.try_emplace(material.base_colour_texture, k_no_texture);
    if (is_new && least_alpha(image(entry->first)) <= k_clear_alpha) entry->second = all_or_nothing(entry->first);
    material.masked = entry->second != k_no_texture;
    if (material.masked) material.base_colour_texture = entry->second;
  }

  int all_or_nothing(int texture) {
    Texture seen = scene_.textures[static_cast<size_t>(texture)];
    bool is_it_already = true;
    for (size_t i = 3; i < seen.image.rgba.size(); i += 4) {
      uint8_t& alpha = seen.image.rgba[i];
      const uint8_t whole = alpha <= k_clear_alpha ? 0 : 255;
      is_it_already = is_it_already && alpha == whole;
      alpha = whole;
    }
    if (is_it_already) return texture;
    scene_.textures.push_back(std::move(seen));
    return static_cast<int>(scene_.textures.size()) - 1;
  }

  Scene& scene_;
  uint32_t rule_;
  std::map<int, int> seen_;  // picture -> what the camera sees of it; none: all of it
};

std::string_view outcome(uint32_t rule) {
  if (rule == blend_casts_opaque) return "and so they cast";
  return rule == blend_casts_none ? "but they cast no shadow" : "but what of them is below half its opacity casts no shadow";
}

}  // namespace

void settle_blended(Scene& scene, const SceneFileOptions& options) {
  const uint32_t rule = options.params.blend_casts;
  std::vector<std::string> names;
  Settler settler(scene, rule);
  for (Material& material : scene.materials) {
    if (!material.blended) continue;
    const bool shines_through = material.masked || material.base_colour.w < 1.0f;
    if (shines_through && std::find(names.begin(), names.end(), material.name) == names.end()) names.push_back(material.name);
    settler.settle(material);
  }
  if (names.empty()) return;
  log_warning(
      "{}: blended materials: {}; the camera sees them as solid wherever their texture is not clear, {} (scene.blend_casts, "
      "or --cast NAME=on|off)",
      scene.file_or_name(), first_names(names), outcome(rule));
}

}  // namespace gnomon
