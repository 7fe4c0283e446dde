#include "scene/material_variants.h"

#include <algorithm>

#include "base/log.h"
#include "scene/lost_pictures.h"

namespace gnomon {

int MaterialVariants::add(Material material) {
  scene_.materials.push_back(std::move(material));
  return static_cast<int>(scene_.materials.size()) - 1;
}

int MaterialVariants::without_uvs(int material, const std::string& part) {
  const Material& whole = at(material);
  if (whole.base_colour_texture == k_no_texture && whole.normal_texture == k_no_texture) return material;
  if (whole.masked) {
    const std::string lost = whole.name == part ? whole.name : whole.name + " (in " + part + ")";
    if (std::find(lost_.begin(), lost_.end(), lost) == lost_.end()) lost_.push_back(lost);
  }
  const auto [entry, is_new] = without_uvs_.try_emplace(material, material);
  if (is_new) {
    Material plain = whole;
    plain.base_colour_texture = plain.normal_texture = k_no_texture;
    // Without a picture a test is of one alpha, and blending has no holes.
    plain.masked = whole.masked && !whole.blended && whole.base_colour.w < whole.alpha_cutoff;
    entry->second = add(std::move(plain));
  }
  return entry->second;
}

int MaterialVariants::with_alpha(int material, float alpha, bool tested) {
  if (alpha == 1.0f) return material;
  const auto [entry, is_new] = with_alpha_.try_emplace({material, alpha}, material);
  if (is_new) {
    Material faded = at(material);
    faded.base_colour.w *= alpha;
    if (tested && faded.base_colour.w < faded.alpha_cutoff) faded.masked = true;
    entry->second = add(std::move(faded));
  }
  return entry->second;
}

void MaterialVariants::say(const std::string& source) const {
  if (lost_.empty()) return;
  log_warning(
      "{}: faces without texture coordinates: {}; their materials keep their plain colour there, and their cut-outs are lost: "
      "they cast as solid sheets",
      source, first_names(lost_));
}

}  // namespace gnomon
