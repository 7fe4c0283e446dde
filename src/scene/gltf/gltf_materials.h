// Materials, textures, samplers and pictures of a glTF file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/gltf/gltf_document.h"
#include "scene/material_variants.h"
#include "scene/scene.h"

namespace gnomon {

// Adds the file's materials to the scene, in its order, and the textures of those that a shown mesh uses: others may be
// damaged. A picture that is not there or cannot be read is a warning: the material keeps its colour.
class GltfMaterials {
 public:
  GltfMaterials(GltfDocument& document, const std::vector<bool>& shown_meshes, Scene& scene);

  // Which TEXCOORD_n a material's textures use. -1: the default material.
  int uv_set(int material) const { return material < 0 ? 0 : uv_sets_[static_cast<size_t>(material)]; }
  // The material of primitives that name none; added when first asked for.
  int default_material();
  // The scene's material for a part of which coordinates and colours are read. -1: the default material. An alpha of the
  // vertices that is the same all over the part counts as the material's. `mesh`: its name, for messages.
  int of_part(int material, const MeshPart& part, const std::string& mesh);
  // Warnings that name what of_part() could not keep.
  void say_what_is_lost() const;

 private:
  struct Picture {
    std::string place, name;
    std::vector<std::byte> encoded;
    Image8 image;
    std::string problem;
  };

  struct Sampled {
    int image = -1;
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  };

  std::vector<bool> used_materials(const std::vector<bool>& shown_meshes) const;
  Sampled read_texture(const GltfValue& json) const;
  void read_material(const GltfValue& json);
  void read_specular_glossiness(const GltfValue& json, Material& material, int& uv_set);
  void read_metallic_roughness(const GltfValue& json, Material& material, int& uv_set);
  void read_normal_map(const GltfValue& json, Material& material, int& uv_set);
  // The scene's texture for a textureInfo object; k_no_texture where its picture is missing.
  int texture(const GltfValue& info, bool srgb, UvTransform& transform, int& uv_set);
  void load_picture(Picture& picture, const GltfValue& json);
  void decode_pictures();
  void drop_pictures_that_cannot_be_read();
  void settle_coverage();
  void warn_of_lost_cutouts() const;

  GltfDocument& document_;
  Scene& scene_;
  std::vector<GltfValue> images_, samplers_, textures_;
  bool is_used_ = false;                 // the material that is being read
  std::map<int, Picture> pictures_;      // by image, those that are used
  std::vector<int> picture_of_texture_;  // scene texture -> image
  std::map<std::tuple<int, Wrap, Wrap, bool>, int> made_;
  std::vector<int> uv_sets_;
  std::vector<bool> is_tested_;               // by material of the file: alphaMode MASK
  std::vector<std::string> without_cutouts_;  // masked or blended materials whose texture is not there
  std::vector<std::string> uneven_alpha_;     // "glass (in window)": whose vertices differ in alpha
  MaterialVariants variants_;
  int default_material_ = -1;
};

}  // namespace gnomon
