// Materials, textures, samplers and pictures of a glTF file.
#include "scene/gltf/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include "base/interrupt.h"
#include "base/log.h"
#include "scene/lost_pictures.h"
#include "scene/parallel.h"
#include "scene/texture_tools.h"

namespace gnomon {
namespace {

Wrap read_wrap(const GltfValue& sampler, std::string_view key) {
  switch (sampler.integer(key, 10497, 0, 0xffff)) {
    case 10497:
      return Wrap::repeat;
    case 33071:
      return Wrap::clamp;
    case 33648:
      return Wrap::mirror;
    default:
      sampler.fail_in(key, "valid: 10497 (repeat), 33071 (clamp), 33648 (mirror)");
  }
}

// The Blinn-Phong exponent whose highlight is as wide as GGX's of the same roughness (Karis 2013).
float shininess_of(float roughness) {
  const float alpha = std::max(roughness * roughness, 0.03f);
  return std::clamp(2.0f / (alpha * alpha) - 2.0f, 1.0f, 2048.0f);
}

bool names_base_colour_texture(const GltfValue& material) {
  const auto pbr = material.object("pbrMetallicRoughness"),
             glossiness = material.extension("KHR_materials_pbrSpecularGlossiness");
  return glossiness ? glossiness->object("diffuseTexture").has_value() : pbr && pbr->object("baseColorTexture");
}

}  // namespace

GltfMaterials::GltfMaterials(GltfDocument& document, const std::vector<bool>& shown_meshes, Scene& scene)
    : document_(document), scene_(scene), variants_(scene) {
  const GltfValue root = document.root();
  images_ = root.objects("images");
  samplers_ = root.objects("samplers");
  textures_ = root.objects("textures");
  const std::vector<bool> used = used_materials(shown_meshes);
  for (const GltfValue& material : root.objects("materials")) {
    is_used_ = used[scene_.materials.size()];
    read_material(material);
  }
  decode_pictures();
  drop_pictures_that_cannot_be_read();
  settle_coverage();
  warn_of_lost_cutouts();
}

int GltfMaterials::default_material() {
  if (default_material_ < 0) {
    default_material_ = static_cast<int>(scene_.materials.size());
    scene_.materials.emplace_back().name = "default";
  }
  return default_material_;
}

int GltfMaterials::of_part(int material, const MeshPart& part, const std::string& mesh) {
  if (material < 0) return default_material();
  const auto index = static_cast<size_t>(material);
  const bool tested = is_tested_[index];
  int result = material;
  if ((tested || scene_.materials[index].blended) && !part.colours.empty()) {
    const auto [least, greatest] =
        std::minmax_element(part.colours.begin(), part.colours.end(), [](const vec4& a, const vec4& b) { return a.w < b.w; });
    const std::string name = fmt::format("{} (in {})", scene_.materials[index].name, mesh);
    if (least->w == greatest->w) {
      result = variants_.with_alpha(result, std::clamp(least->w, 0.0f, 1.0f), tested);
    } else if (std::find(uneven_alpha_.begin(), uneven_alpha_.end(), name) == uneven_alpha_.end()) {
      uneven_alpha_.push_back(name);
    }
  }
  return part.uvs.empty() ? variants_.without_uvs(result, mesh) : result;
}

void GltfMaterials::say_what_is_lost() const {
  variants_.say(document_.name());
  if (uneven_alpha_.empty()) return;
  log_warning(
      "{}: the alpha of the vertices' colours (COLOR_0) differs within a part of a mesh and is not read: {}; what is seen and "
      "casts goes by the alpha of material and texture alone",
      document_.name(), first_names(uneven_alpha_));
}

// --- pictures --------------------------------------------------------------------------------------------------------

std::vector<bool> GltfMaterials::used_materials(const std::vector<bool>& shown_meshes) const {
  std::vector<bool> used(document_.root().count("materials"), false);
  const std::vector<GltfValue> meshes = document_.root().objects("meshes");
  for (size_t i = 0; i < meshes.size(); ++i) {
    if (!shown_meshes[i]) continue;
    for (const GltfValue& primitive : meshes[i].objects("primitives")) {
      const int material = primitive.index("material", used.size(), "materials");
      if (material >= 0) used[static_cast<size_t>(material)] = true;
    }
  }
  return used;
}

GltfMaterials::Sampled GltfMaterials::read_texture(const GltfValue& json) const {
  Sampled texture;
  texture.image = json.index("source", images_.size(), "images");
  if (const auto webp = json.extension("EXT_texture_webp"); webp && texture.image < 0)
    texture.image = webp->index("source", images_.size(), "images");
  const int sampler = json.index("sampler", samplers_.size(), "samplers");
  if (sampler >= 0) {
    texture.wrap_u = read_wrap(samplers_[static_cast<size_t>(sampler)], "wrapS");
    texture.wrap_v = read_wrap(samplers_[static_cast<size_t>(sampler)], "wrapT");
  }
  return texture;
}

void GltfMaterials::load_picture(Picture& picture, const GltfValue& json) {
  picture.place = json.place();
  const int view = json.index("bufferView", document_.view_count(), "bufferViews");
  const std::string uri = json.text("uri", "");
  if ((view < 0) == uri.empty()) json.fail_here("valid: either uri or bufferView");
  picture.name = json.text("name", uri.starts_with("data:") || uri.empty() ? json.place() : uri);
  try {
    if (view >= 0) {
      const Bytes bytes = document_.view(view, json.where("bufferView"));
      picture.encoded.assign(bytes.begin(), bytes.end());
    } else if (uri.starts_with("data:") || document_.find_file(uri)) {
      picture.encoded = document_.read_uri(uri, json.where("uri"));
    } else {
      picture.problem = fmt::format("{}: {}.uri: {} is not there", document_.name(), json.place(), uri);
    }
  } catch (const Interrupted&) {
    throw;
  } catch (const Error& error) {
    picture.problem = error.what();
    if (!picture.problem.starts_with(document_.name()))  // of a file beside it
      picture.problem = fmt::format("{}: {}.uri: {}", document_.name(), json.place(), picture.problem);
  }
}

void GltfMaterials::decode_pictures() {
  std::vector<Picture*> work;
  for (auto& [image, picture] : pictures_) {
    if (picture.problem.empty()) work.push_back(&picture);
  }
  Progress progress("reading textures of " + document_.name(), work.size());
  parallel_for(work.size(), progress, [&](size_t i) {
    const std::string own = work[i]->name == work[i]->place ? "" : fmt::format(" ({})", work[i]->name);
    const std::string name = fmt::format("{}: {}{}", document_.name(), work[i]->place, own);
    try {
      work[i]->image = decode_image(work[i]->encoded, name);
    } catch (const Interrupted&) {
      throw;
    } catch (const Error& error) {
      work[i]->problem = error.what();
    }
    work[i]->encoded = {};
  });
  for (size_t i = 0; i < scene_.textures.size(); ++i) scene_.textures[i].image = pictures_.at(picture_of_texture_[i]).image;
}

// Which cut-outs are lost with them is said by material.
void GltfMaterials::drop_pictures_that_cannot_be_read() {
  for (const auto& [image, picture] : pictures_) {
    if (!picture.problem.empty()) log_warning("{}; its materials keep their plain colour", picture.problem);
  }
  std::vector<int> kept(scene_.textures.size(), k_no_texture);  // texture -> where it goes
  std::vector<Texture> textures;
  for (size_t i = 0; i < kept.size(); ++i) {
    if (!pictures_.at(picture_of_texture_[i]).problem.empty()) continue;
    kept[i] = static_cast<int>(textures.size());
    textures.push_back(std::move(scene_.textures[i]));
  }
  scene_.textures = std::move(textures);
  const auto settle = [&](int& texture) {
    const bool was_there = texture != k_no_texture;
    if (was_there) texture = kept[static_cast<size_t>(texture)];
    return was_there && texture == k_no_texture;
  };
  for (size_t i = 0; i < scene_.materials.size(); ++i) {
    Material& material = scene_.materials[i];
    if (settle(material.base_colour_texture) && (is_tested_[i] || material.blended)) without_cutouts_.push_back(material.name);
    settle(material.normal_texture);
  }
}

int GltfMaterials::texture(const GltfValue& info, bool srgb, UvTransform& transform, int& uv_set) {
  if (!is_used_) return k_no_texture;
  const GltfValue& json = textures_[static_cast<size_t>(info.required_index("index", textures_.size(), "textures"))];
  const Sampled sampled = read_texture(json);
  uv_set = static_cast<int>(info.integer("texCoord", 0, 0, 255));
  if (const auto extension = info.extension("KHR_texture_transform")) {
    transform =
        UvTransform::from(extension->vector<2>("offset", vec2(0.0f)), static_cast<float>(extension->number("rotation", 0.0)),
                          extension->vector<2>("scale", vec2(1.0f)));
    uv_set = static_cast<int>(extension->integer("texCoord", static_cast<uint64_t>(uv_set), 0, 255));
  }
  if (sampled.image < 0) {
    log_warning("{}: {}: has no picture in a format that is read (PNG, JPEG, WebP; KTX2 and DDS are not)", document_.name(),
                json.place());
    return k_no_texture;
  }
  const auto [picture, is_new_picture] = pictures_.try_emplace(sampled.image);
  if (is_new_picture) load_picture(picture->second, images_[static_cast<size_t>(sampled.image)]);
  const auto [made, is_new] =
      made_.try_emplace({sampled.image, sampled.wrap_u, sampled.wrap_v, srgb}, static_cast<int>(scene_.textures.size()));
  if (is_new) {
    scene_.textures.push_back(
        {.name = picture->second.name, .image = {}, .srgb = srgb, .wrap_u = sampled.wrap_u, .wrap_v = sampled.wrap_v});
    picture_of_texture_.push_back(sampled.image);
  }
  return made->second;
}

// --- materials -------------------------------------------------------------------------------------------------------

void GltfMaterials::read_material(const GltfValue& json) {
  Material material;
  int uv_set = 0;
  material.name = json.text("name", json.place());
  read_metallic_roughness(json, material, uv_set);
  if (const auto extension = json.extension("KHR_materials_pbrSpecularGlossiness"))
    read_specular_glossiness(*extension, material, uv_set);
  read_normal_map(json, material, uv_set);

  material.double_sided = json.flag("doubleSided", false);
  material.alpha_cutoff = static_cast<float>(json.number("alphaCutoff", 0.5, 0.0));
  const std::string mode = json.text("alphaMode", "OPAQUE");
  is_tested_.push_back(mode == "MASK");
  if (mode == "MASK") {
    material.masked = true;
  } else if (mode == "BLEND") {
    material.blended = true;
  } else if (mode != "OPAQUE") {
    json.fail_in("alphaMode", "is \"{}\"; valid: OPAQUE, MASK, BLEND", mode);
  }
  if (is_used_ && mode != "OPAQUE" && material.base_colour_texture == k_no_texture && names_base_colour_texture(json))
    without_cutouts_.push_back(material.name);

  material.emissive = json.vector<3>("emissiveFactor", vec3(0.0f));
  if (const auto strength = json.extension("KHR_materials_emissive_strength")) {
    material.emissive *= static_cast<float>(strength->number("emissiveStrength", 1.0, 0.0, 1e9));
  }
  // Emission is one colour here; that of a whole surface would drown what its picture confines to a few lamps.
  if (json.object("emissiveTexture")) material.emissive = vec3(0.0f);
  if (json.extension("KHR_materials_unlit")) log_debug("{}: {}: unlit; shaded like any other", document_.name(), json.place());
  scene_.materials.push_back(std::move(material));
  uv_sets_.push_back(uv_set);
}

void GltfMaterials::read_metallic_roughness(const GltfValue& json, Material& material, int& uv_set) {
  // Metals keep their colour as a diffuse one: the metalness of a texel is not read, and a black scene shows no shadow.
  material.specular = vec3(0.04f);
  material.shininess = shininess_of(1.0f);
  const auto pbr = json.object("pbrMetallicRoughness");
  if (!pbr) return;
  material.base_colour = pbr->vector<4>("baseColorFactor", vec4(1.0f));
  material.shininess = shininess_of(static_cast<float>(pbr->number("roughnessFactor", 1.0, 0.0, 1.0)));
  pbr->number("metallicFactor", 1.0, 0.0, 1.0);
  if (const auto info = pbr->object("baseColorTexture"))
    material.base_colour_texture = texture(*info, true, material.base_colour_uv, uv_set);
}

void GltfMaterials::read_specular_glossiness(const GltfValue& json, Material& material, int& uv_set) {
  material.base_colour = json.vector<4>("diffuseFactor", vec4(1.0f));
  material.specular = json.vector<3>("specularFactor", vec3(1.0f));
  material.shininess = shininess_of(1.0f - static_cast<float>(json.number("glossinessFactor", 1.0, 0.0, 1.0)));
  material.base_colour_texture = k_no_texture;
  material.base_colour_uv = {};
  if (const auto info = json.object("diffuseTexture"))
    material.base_colour_texture = texture(*info, true, material.base_colour_uv, uv_set);
}

void GltfMaterials::read_normal_map(const GltfValue& json, Material& material, int& uv_set) {
  const auto info = json.object("normalTexture");
  if (!info) return;
  int own_set = 0;
  material.normal_texture = texture(*info, false, material.normal_uv, own_set);
  material.normal_scale = static_cast<float>(info->number("scale", 1.0));
  if (material.base_colour_texture == k_no_texture) {
    uv_set = own_set;
  } else if (material.normal_texture != k_no_texture && own_set != uv_set) {
    log_warning(
        "{}: {}.texCoord: is {} where the base colour has {}; one set of coordinates per material is supported, the normal map "
        "is left out",
        document_.name(), info->place(), own_set, uv_set);
    material.normal_texture = k_no_texture;
  }
}

// What only the pixels tell: whether a material has holes at all.
void GltfMaterials::settle_coverage() {
  const auto texture_has_holes = [&](const Material& m) {
    return m.base_colour_texture != k_no_texture &&
           has_transparency(scene_.textures[static_cast<size_t>(m.base_colour_texture)].image);
  };
  for (Material& material : scene_.materials) {
    if (material.blended) material.masked = texture_has_holes(material);
    if (material.masked && !texture_has_holes(material) && material.base_colour.w >= material.alpha_cutoff)
      material.masked = false;
  }
}

// A lost colour is no matter for shadows; a lost alpha channel is.
void GltfMaterials::warn_of_lost_cutouts() const {
  if (without_cutouts_.empty()) return;
  log_warning("{}: alpha-tested materials without their texture: {}; their cut-outs are lost: they cast as solid sheets",
              document_.name(), first_names(without_cutouts_));
}

}  // namespace gnomon
