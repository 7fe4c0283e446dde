// Materials of OBJ files: MTL text, read by tinyobjloader, and the pictures that it names.
#include "scene/obj/obj_materials.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "scene/obj/obj_text.h"
#include "scene/parallel.h"
#include "scene/texture_tools.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop

namespace gnomon {
namespace {

namespace fs = std::filesystem;

// Rise over run for a height map from black to white within one texel at bump multiplier 1: MTL gives heights no unit.
constexpr float k_bump_slope = 4.0f;

// A regular file below the folder (a device such as /dev/zero would be read for ever); nullopt where there is none.
std::optional<fs::path> find_file(const fs::path& folder, std::string name) {
  if (folder.empty() || name.empty()) return std::nullopt;
  std::replace(name.begin(), name.end(), '\\', '/');
  // Absolute paths of the author's machine: the picture often lies beside the model.
  for (const fs::path& candidate : {folder / name, folder / fs::path(name).filename()}) {
    std::error_code error;
    if (fs::is_regular_file(candidate, error)) return candidate;
  }
  return std::nullopt;
}

// "a.mtl b\\ c.mtl" -> "a.mtl", "b c.mtl"
std::vector<std::string> split_names(std::string_view text) {
  std::vector<std::string> names;
  for (std::string_view word; !(word = next_word(text)).empty();) {
    std::string name(word);
    while (name.ends_with('\\') && !text.empty()) {
      name.back() = ' ';
      name += next_word(text);
    }
    names.push_back(std::move(name));
  }
  return names;
}

// One line however many are missing: a map without its game lacks hundreds.
void warn_missing(const std::string& source, std::string_view what, const std::vector<std::string>& names,
                  std::string_view consequence) {
  if (names.empty()) return;
  constexpr size_t k_shown = 3;
  std::string list;
  for (size_t i = 0; i < std::min(names.size(), k_shown); ++i) list += (i ? ", " : "") + names[i];
  if (names.size() > k_shown) list += fmt::format(" and {} more", names.size() - k_shown);
  log_warning("{}: {}: {}; {}", source, what, list, consequence);
}

// --- material libraries ----------------------------------------------------------------------------------------------

class Libraries {
 public:
  Libraries(const std::string& source, const fs::path& folder, const std::vector<std::string>& libraries) {
    for (const std::string& library : libraries) {
      // A name with blanks, or several names.
      if (const auto whole = find_file(folder, library)) {
        read(*whole);
        continue;
      }
      for (const std::string& name : split_names(library)) {
        if (const auto file = find_file(folder, name)) {
          read(*file);
        } else {
          log_warning("{}: the material library {} is not there; its materials are plain white", source, name);
        }
      }
    }
  }

  const tinyobj::material_t* find(const std::string& name) const {
    const auto found = index_.find(name);
    return found == index_.end() ? nullptr : &materials_[static_cast<size_t>(found->second)];
  }

 private:
  void read(const fs::path& path) {
    std::istringstream stream(read_text_file(path));
    std::string warning, error;
    tinyobj::LoadMtl(&index_, &materials_, &stream, &warning, &error);
    if (!warning.empty()) log_debug("{}: {}", path.string(), warning);
  }

  std::map<std::string, int> index_;
  std::vector<tinyobj::material_t> materials_;
};

// Which of them had holes only the missing picture knows.
constexpr std::string_view k_without_picture =
    "their materials keep their plain colour; cut-outs in them are lost, so a leaf or a fence casts as a solid sheet";

// --- pictures --------------------------------------------------------------------------------------------------------

// Every picture that the materials name, read once and on all cores.
class Pictures {
 public:
  Pictures(const std::string& source, const fs::path& folder, const std::set<std::string>& names) {
    std::vector<std::pair<const std::string*, Entry*>> work;
    std::vector<std::string> missing;
    for (const std::string& name : names) {
      if (const auto path = find_file(folder, name)) {
        Entry& entry = entries_[name];
        entry.path = *path;
        work.emplace_back(&name, &entry);
      } else {
        missing.push_back(name);
      }
    }
    warn_missing(source, "missing textures", missing, k_without_picture);
    Progress progress("reading textures", work.size());
    parallel_for(work.size(), progress, [&](size_t i) {
      Entry& entry = *work[i].second;
      try {
        entry.encoded = read_file(entry.path);
        entry.image = decode_image(entry.encoded, entry.path.string());
      } catch (const Interrupted&) {
        throw;
      } catch (const Error& error) {
        entry.problem = error.what();
      }
    });
    for (const auto& [name, entry] : work) {
      if (entry->problem.empty()) continue;
      log_warning("{}; {}", entry->problem, k_without_picture);
      entries_.erase(*name);
    }
  }

  const Image8* find(const std::string& name) const {
    const auto found = entries_.find(name);
    return found == entries_.end() ? nullptr : &found->second.image;
  }
  ImageF heights(const std::string& name) const {
    const Entry& entry = entries_.at(name);
    return decode_height_map(entry.encoded, entry.path.string());
  }

 private:
  struct Entry {
    fs::path path;
    std::vector<std::byte> encoded;
    Image8 image;
    std::string problem;
  };
  std::map<std::string, Entry> entries_;
};

// --- materials -------------------------------------------------------------------------------------------------------

vec3 colour(const tinyobj::real_t* rgb) {
  vec3 result;
  for (int i = 0; i < 3; ++i) result[i] = std::isfinite(rgb[i]) ? std::clamp(rgb[i], 0.0f, 1e6f) : 0.0f;
  return result;
}

float in_range(float value, float low, float high) { return std::isfinite(value) ? std::clamp(value, low, high) : low; }

// -o and -s act on a v that runs upward.
UvTransform uv_transform(const tinyobj::texture_option_t& option) {
  const auto finite = [](float value, float otherwise) { return std::isfinite(value) ? value : otherwise; };
  const vec2 offset(finite(option.origin_offset[0], 0), finite(option.origin_offset[1], 0));
  const vec2 scale(finite(option.scale[0], 1), finite(option.scale[1], 1));
  return UvTransform::from({offset.x, 1.0f - offset.y - scale.y}, 0.0f, scale);
}

class MaterialMaker {
 public:
  MaterialMaker(Scene& scene, const Pictures& pictures) : scene_(scene), pictures_(pictures) {}

  Material make(const tinyobj::material_t& mtl) {
    Material material;
    material.base_colour = vec4(colour(mtl.diffuse), in_range(mtl.dissolve, 0.0f, 1.0f));
    material.specular = colour(mtl.specular);
    material.shininess = in_range(mtl.shininess, 1.0f, 1e4f);
    material.emissive = colour(mtl.emission);
    set_base_colour(material, mtl);
    set_normal_map(material, mtl);
    return material;
  }

 private:
  void set_base_colour(Material& material, const tinyobj::material_t& mtl) {
    const Image8* picture = pictures_.find(mtl.diffuse_texname);
    const Image8* mask = pictures_.find(mtl.alpha_texname);
    if (!picture && !mask) return;
    if (picture && vec3(material.base_colour) == vec3(0.0f)) {
      // Exporters write a black colour beside a picture and mean the picture.
      material.base_colour = vec4(vec3(1.0f), material.base_colour.w);
    }
    const auto& option = picture ? mtl.diffuse_texopt : mtl.alpha_texopt;
    const std::string key = fmt::format("{}|{}|{}", mtl.diffuse_texname, mask ? mtl.alpha_texname : "", option.clamp);
    material.base_colour_texture = texture(key, option.clamp, true, picture ? mtl.diffuse_texname : mtl.alpha_texname, [&] {
      Image8 image = picture ? *picture : white(*mask);
      if (mask) set_alpha(image, *mask);
      return image;
    });
    material.base_colour_uv = uv_transform(option);
    if (mask || has_transparency(scene_.textures[static_cast<size_t>(material.base_colour_texture)].image)) {
      material.masked = true;
      material.base_colour.w = 1.0f;  // `d` of a masked material is often 0: the picture alone says where there is something
    }
  }

  // A grey picture under a bump statement is a height map; a coloured one is a normal map in the wrong statement.
  void set_normal_map(Material& material, const tinyobj::material_t& mtl) {
    const bool is_normal = pictures_.find(mtl.normal_texname) != nullptr;
    const std::string& name = is_normal ? mtl.normal_texname : mtl.bump_texname;
    const auto& option = is_normal ? mtl.normal_texopt : mtl.bump_texopt;
    const Image8* picture = pictures_.find(name);
    if (!picture) return;
    const float slope = k_bump_slope * in_range(option.bump_multiplier, 0.0f, 1e3f);
    const bool is_height = !is_normal && is_grey(*picture);
    const std::string key = fmt::format("{}|{}|{}", name, is_height ? slope : -1.0f, option.clamp);
    material.normal_texture = texture(key, option.clamp, false, name, [&] {
      return is_height ? normal_map_from_heights(pictures_.heights(name), slope) : *picture;
    });
    material.normal_uv = uv_transform(option);
  }

  template <class MakeImage>
  int texture(const std::string& key, bool clamp, bool srgb, const std::string& name, const MakeImage& make_image) {
    const auto [entry, is_new] = textures_.try_emplace(key, static_cast<int>(scene_.textures.size()));
    if (is_new) {
      const Wrap wrap = clamp ? Wrap::clamp : Wrap::repeat;
      scene_.textures.push_back({.name = name, .image = make_image(), .srgb = srgb, .wrap_u = wrap, .wrap_v = wrap});
    }
    return entry->second;
  }

  static Image8 white(const Image8& like) {
    Image8 image(like.width, like.height);
    std::fill(image.rgba.begin(), image.rgba.end(), uint8_t{255});
    return image;
  }

  Scene& scene_;
  const Pictures& pictures_;
  std::map<std::string, int> textures_;
};

}  // namespace

void add_obj_materials(Scene& scene, const std::string& source, const fs::path& folder,
                       const std::vector<std::string>& libraries, const std::vector<std::string>& names) {
  const Libraries library(source, folder, libraries);
  std::set<std::string> pictures;
  std::vector<std::string> missing, solid;
  for (const std::string& name : names) {
    if (const auto* mtl = library.find(name)) {
      for (const std::string& picture : {mtl->diffuse_texname, mtl->alpha_texname, mtl->normal_texname, mtl->bump_texname}) {
        if (!picture.empty()) pictures.insert(picture);
      }
    } else if (!name.empty()) {
      missing.push_back(name);
    }
  }
  warn_missing(source, libraries.empty() ? "materials without a library (mtllib)" : "materials that no library has", missing,
               "they are plain white");
  const Pictures loaded(source, folder, pictures);
  MaterialMaker maker(scene, loaded);
  for (const std::string& name : names) {
    const auto* mtl = library.find(name);
    Material material = mtl && !name.empty() ? maker.make(*mtl) : Material{};
    material.name = name.empty() ? "default" : name;
    material.double_sided = true;  // the format knows no culling, and files wind their faces as they like
    material.blended = material.base_colour.w < 1.0f;
    if (mtl && !mtl->alpha_texname.empty() && !material.masked) solid.push_back(material.name);
    scene.materials.push_back(std::move(material));
  }
  warn_missing(source, "alpha-tested materials without their texture", solid,
               "their cut-outs are lost: they cast as solid sheets");
}

}  // namespace gnomon
