// Kinds of material that the built-in scenes share; the caller adds them (shapes.h, add_material).
#pragma once

#include <string>

#include "scene/builtin/parts/procedural_textures.h"
#include "scene/scene.h"

namespace gnomon {

// Colour and normal map, added to the scene's textures as `name` and `name`_normal.
Material textured_material(Scene& scene, const std::string& name, SurfaceTexture texture, const vec3& tint = vec3(1.0f));
// Alpha-tested and double-sided; the picture repeats in u only, if at all.
Material cut_out_material(Scene& scene, const std::string& name, Image8 image, Wrap wrap_u = Wrap::clamp);
Material plain_material(const std::string& name, const vec3& colour);

// The same with another name and tint: the textures are shared.
Material tinted(Material material, const std::string& name, const vec3& tint);
Material shiny(Material material, float specular, float shininess);

}  // namespace gnomon
