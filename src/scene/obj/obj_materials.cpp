// Materials of OBJ files: from MTL to the scene's.
#include "scene/obj/obj_materials.h"

#include <algorithm>
#include <map>

#include "base/log.h"
#include "scene/obj/alpha_decision.h"
#include "scene/obj/obj_libraries.h"
#include "scene/obj/obj_pictures.h"
#include "scene/texture_tools.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

// Rise over run for a height map from black to white within one texel at bump multiplier 1: MTL gives heights no unit.
constexpr float k_bump_slope = 4.0f;

// -o and -s act on a v that runs upward.
UvTransform uv_transform(const MtlPicture& option) {
  return UvTransform::from({option.offset.x, 1.0f - option.offset.y - option.scale.y}, 0.0f, option.scale);
}

class MaterialMaker {
 public:
  MaterialMaker(Scene& scene, const ObjPictures& pictures, AlphaDecision& alpha)
      : scene_(scene), pictures_(pictures), alpha_(alpha) {}

  Material make(const ObjLibraries::Entry& entry, bool has_uvs) {
    const MtlMaterial& mtl = entry.material;
    Material material;
    material.name = mtl.name;
    material.base_colour = vec4(mtl.diffuse, mtl.dissolve);
    material.specular = mtl.specular;
    material.shininess = mtl.shininess;
    material.emissive = mtl.emission;
    set_base_colour(material, entry, has_uvs);
    set_normal_map(material, entry);
    return material;
  }

 private:
  using Picture = ObjPictures::Picture;

  void set_base_colour(Material& material, const ObjLibraries::Entry& entry, bool has_uvs) {
    const MtlMaterial& mtl = entry.material;
    const Picture* picture = pictures_.find(mtl.colour.name, entry.folder);
    const Picture* mask = pictures_.find(mtl.alpha.name, entry.folder);
    if (!picture && !mask) return;
    if (picture && vec3(material.base_colour) == vec3(0.0f)) {
      // Exporters write a black colour beside a picture and mean the picture.
      material.base_colour = vec4(vec3(1.0f), material.base_colour.w);
    }
    const MtlPicture& option = picture ? mtl.colour : mtl.alpha;
    const std::string key = fmt::format("{}|{}|{}|{}", picture ? picture->path.string() : "", mask ? mask->path.string() : "",
                                        mtl.alpha.inverted, option.clamp);
    material.base_colour_texture = texture(key, option, true, [&] {
      Image8 image = picture ? picture->image : white(mask->image);
      if (mask) set_alpha(image, mask->image, mtl.alpha.inverted);
      return image;
    });
    material.base_colour_uv = uv_transform(option);
    // A map_d that is not there would have been the answer: the picture's own alpha is a guess then as it is without map_d.
    material.masked = mask || alpha_.cuts(picture->image, material.name, has_uvs);
  }

  // A grey picture under a bump statement is a height map; a coloured one is a normal map in the wrong statement.
  void set_normal_map(Material& material, const ObjLibraries::Entry& entry) {
    const Picture* normals = pictures_.find(entry.material.normal.name, entry.folder);
    const MtlPicture& option = normals ? entry.material.normal : entry.material.bump;
    const Picture* picture = normals ? normals : pictures_.find(option.name, entry.folder);
    if (!picture) return;
    const float slope = k_bump_slope * std::clamp(option.bump_multiplier, 0.0f, 1e3f);
    const bool is_height = !normals && is_grey(picture->image);
    const std::string key = fmt::format("{}|{}|{}", picture->path.string(), is_height ? slope : -1.0f, option.clamp);
    material.normal_texture = texture(
        key, option, false, [&] { return is_height ? normal_map_from_heights(heights_of(*picture), slope) : picture->image; });
    material.normal_uv = uv_transform(option);
  }

  template <class MakeImage>
  int texture(const std::string& key, const MtlPicture& option, bool srgb, const MakeImage& make_image) {
    const auto [entry, is_new] = textures_.try_emplace(key, static_cast<int>(scene_.textures.size()));
    if (is_new) {
      const Wrap wrap = option.clamp ? Wrap::clamp : Wrap::repeat;
      scene_.textures.push_back({.name = option.name, .image = make_image(), .srgb = srgb, .wrap_u = wrap, .wrap_v = wrap});
    }
    return entry->second;
  }

  static Image8 white(const Image8& like) {
    Image8 image(like.width, like.height);
    std::fill(image.rgba.begin(), image.rgba.end(), uint8_t{255});
    return image;
  }

  Scene& scene_;
  const ObjPictures& pictures_;
  AlphaDecision& alpha_;
  std::map<std::string, int> textures_;
};

void name_pictures(ObjPictures& pictures, const ObjLibraries::Entry& entry) {
  pictures.add(entry.material.colour.name, entry.folder, PictureUse::colour, entry.material.name);
  pictures.add(entry.material.alpha.name, entry.folder, PictureUse::colour, entry.material.name);
  pictures.add(entry.material.normal.name, entry.folder, PictureUse::normals, entry.material.name);
  pictures.add(entry.material.bump.name, entry.folder, PictureUse::normals, entry.material.name);
}

}  // namespace

void add_obj_materials(Scene& scene, const ObjSource& source, const std::vector<std::string>& libraries,
                       const std::vector<ObjMaterialUse>& uses) {
  FileFinder finder(source.name);
  const ObjLibraries library(source.name, source.folder, libraries, finder);
  ObjPictures pictures(source.name, source.folder, finder);
  std::vector<std::string> missing, solid;
  for (const auto& [name, has_uvs] : uses) {
    if (const auto* entry = library.find(name)) {
      name_pictures(pictures, *entry);
    } else if (!name.empty()) {
      missing.push_back(name);
    }
  }
  if (!missing.empty()) {
    log_warning("{}: {}: {}; they are plain white", source.name,
                libraries.empty() ? "materials without a library (mtllib)" : "materials that no library has",
                first_names(missing));
  }
  pictures.load();
  AlphaDecision alpha(source.options);
  MaterialMaker maker(scene, pictures, alpha);
  for (const auto& [name, has_uvs] : uses) {
    const auto* entry = name.empty() ? nullptr : library.find(name);
    Material material = entry ? maker.make(*entry, has_uvs) : Material{};
    material.name = name.empty() ? "default" : name;
    material.double_sided = true;  // the format knows no culling, and files wind their faces as they like
    material.blended = material.base_colour.w < 1.0f;
    if (entry && !entry->material.alpha.name.empty() && !material.masked) solid.push_back(material.name);
    scene.materials.push_back(std::move(material));
  }
  alpha.say(source.name);
  if (!solid.empty()) {
    log_warning("{}: alpha-tested materials without their texture: {}; their cut-outs are lost: they cast as solid sheets",
                source.name, first_names(solid));
  }
}

}  // namespace gnomon
