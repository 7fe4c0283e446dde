// What loaders say about pictures and materials that are not there.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace gnomon {

enum class PictureUse { colour, normals };

// Which of the materials had holes only the missing picture of a colour knows; one of normals has none.
constexpr std::string_view consequence_without(PictureUse use) {
  if (use == PictureUse::normals) return "their materials look smoother; shadows are the same";
  return "their materials keep their plain colour; cut-outs in them are lost, so a leaf or a fence casts as a solid sheet";
}

// One line however many are missing: a map without its game lacks hundreds.
inline std::string first_names(std::span<const std::string> names) {
  constexpr size_t k_shown = 3;
  std::string list;
  for (size_t i = 0; i < std::min(names.size(), k_shown); ++i) list += (i ? ", " : "") + names[i];
  if (names.size() > k_shown) list += " and " + std::to_string(names.size() - k_shown) + " more";
  return list;
}

}  // namespace gnomon
