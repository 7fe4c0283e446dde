// Materials as values: nothing is shared but texture indices.
#include "scene/builtin/parts/materials.h"

#include "scene/builtin/parts/shapes.h"

namespace gnomon {

Material textured_material(Scene& scene, const std::string& name, SurfaceTexture texture, const vec3& tint) {
  Material material;
  material.name = name;
  material.base_colour = vec4(tint, 1.0f);
  material.base_colour_texture = add_texture(scene, name, std::move(texture.colour), true);
  material.normal_texture = add_texture(scene, name + "_normal", std::move(texture.normal), false);
  return material;
}

Material cut_out_material(Scene& scene, const std::string& name, Image8 image, Wrap wrap_u) {
  Material material;
  material.name = name;
  material.base_colour_texture = add_texture(scene, name, std::move(image), true, Wrap::clamp);
  scene.textures.back().wrap_u = wrap_u;
  material.masked = true, material.double_sided = true;
  return material;
}

Material plain_material(const std::string& name, const vec3& colour) {
  Material material;
  material.name = name, material.base_colour = vec4(colour, 1.0f);
  return material;
}

Material tinted(Material material, const std::string& name, const vec3& tint) {
  material.name = name, material.base_colour = vec4(tint, 1.0f);
  return material;
}

Material shiny(Material material, float specular, float shininess) {
  material.specular = vec3(specular), material.shininess = shininess;
  return material;
}

}  // namespace gnomon
