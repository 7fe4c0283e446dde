// Materials, textures, samplers and pictures of a glTF file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/gltf/gltf_document.h"
#include "scene/scene.h"

namespace gnomon {

// Adds the file's materials to the scene, in its order, and the textures that they use. A picture that is not there is a
// warning (the material keeps its colour); one that cannot be decoded is an error.
class GltfMaterials {
 public:
  GltfMaterials(GltfDocument& document, Scene& scene);

  // Which TEXCOORD_n a material's textures use. -1: the default material.
  int uv_set(int material) const { return material < 0 ? 0 : uv_sets_[static_cast<size_t>(material)]; }
  // The material of primitives that name none; added when first asked for.
  int default_material();

 private:
  struct Picture {
    std::string place, name;
    std::vector<std::byte> encoded;
    Image8 image;
  };

  void read_picture(const GltfValue& json);
  void read_texture(const GltfValue& json, const std::vector<GltfValue>& samplers);
  void read_material(const GltfValue& json);
  void read_specular_glossiness(const GltfValue& json, Material& material, int& uv_set);
  void read_metallic_roughness(const GltfValue& json, Material& material, int& uv_set);
  void read_normal_map(const GltfValue& json, Material& material, int& uv_set);
  // The scene's texture for a textureInfo object; k_no_texture where its picture is missing.
  int texture(const GltfValue& info, bool srgb, UvTransform& transform, int& uv_set);
  void load_picture(Picture& picture, const GltfValue& json);
  void decode_pictures();
  void settle_coverage();
  void warn_of_lost_cutouts() const;

  struct Sampled {
    int image = -1;
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  };

  GltfDocument& document_;
  Scene& scene_;
  std::vector<GltfValue> images_;
  std::vector<Sampled> textures_;
  std::map<int, Picture> pictures_;      // by image, those that are used
  std::vector<int> picture_of_texture_;  // scene texture -> image
  std::map<std::tuple<int, Wrap, Wrap, bool>, int> made_;
  std::vector<int> uv_sets_;
  std::vector<std::string> without_cutouts_;  // masked or blended materials whose texture is not there
  int default_material_ = -1;
};

}  // namespace gnomon
