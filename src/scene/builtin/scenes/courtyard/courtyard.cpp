// courtyard: the default scene. A Mediterranean court in the late afternoon with everything that strains a shadow technique:
// thin bars, alpha-tested iron and leaves, contact at all angles, a hanging lantern, a tower whose shadow crosses the court.
#include "scene/builtin/builtin.h"
#include "scene/builtin/parts/materials.h"
#include "scene/builtin/parts/noise.h"
#include "scene/builtin/parts/procedural_textures.h"
#include "scene/builtin/scenes/courtyard/courtyard_parts.h"
#include "scene/path.h"

namespace gnomon {
CourtyardMaterials add_courtyard_materials(Scene& scene) {
  CourtyardMaterials m;
  m.paving = add_material(scene, shiny(textured_material(scene, "paving", paving_texture(512)), 0.06f, 24.0f));
  m.masonry = add_material(scene, textured_material(scene, "masonry", masonry_texture(512)));
  m.plaster = add_material(scene, textured_material(scene, "plaster", plaster_texture(512)));
  m.limestone = add_material(scene, textured_material(scene, "limestone", limestone_texture(256)));
  Material tiles = textured_material(scene, "terracotta", terracotta_texture(256));
  tiles.double_sided = true;  // the roof's tiles are sheets
  m.terracotta = add_material(scene, tiles);
  m.wood = add_material(scene, textured_material(scene, "wood", wood_texture(256)));
  m.bark = add_material(scene, textured_material(scene, "bark", bark_texture(256)));
  m.iron = add_material(scene, shiny(plain_material("iron", {0.03f, 0.027f, 0.025f}), 0.25f, 40.0f));
  m.iron_panel =
      add_material(scene, shiny(cut_out_material(scene, "iron_panel", iron_panel_texture(512), Wrap::repeat), 0.2f, 40.0f));
  const TwigStyle olive{8, 0.44f, 0.085f, 0.85f, {0.52f, 0.56f, 0.40f}, {0.09f, 0.08f, 0.07f}, 21};
  m.olive = add_material(scene, cut_out_material(scene, "olive", twig_texture(256, olive), Wrap::clamp));
  const TwigStyle cypress{14, 0.40f, 0.055f, 0.45f, {0.25f, 0.35f, 0.19f}, {0.07f, 0.08f, 0.05f}, 22};
  m.cypress = add_material(scene, cut_out_material(scene, "cypress", twig_texture(256, cypress), Wrap::clamp));
  const TwigStyle shrub{5, 0.42f, 0.17f, 0.95f, {0.33f, 0.46f, 0.20f}, {0.08f, 0.09f, 0.05f}, 23};
  m.shrub = add_material(scene, cut_out_material(scene, "shrub", twig_texture(256, shrub), Wrap::clamp));
  Material glass = plain_material("lantern_glass", {0.8f, 0.6f, 0.3f});
  glass.emissive = vec3(0.9f, 0.5f, 0.16f);
  m.glass = add_material(scene, glass);
  return m;
}

static Scene make_courtyard(const BuiltinOptions&) {
  Scene scene;
  scene.name = "courtyard";
  const CourtyardMaterials materials = add_courtyard_materials(scene);
  for (const auto add :
       {add_paving, add_colonnade, add_gate_wall, add_stairs, add_tower, add_garden_wall, add_fence, add_fountain, add_ball,
        add_crate_and_plank, add_lantern, add_amphora, add_olive_tree, add_cypresses, add_potted_shrubs}) {
    add(scene, materials);
  }
  scene.lights.push_back(sun_light("sun", vec3(0.62f, -0.48f, 0.62f), vec3(1.0f, 0.84f, 0.62f), 3.0f));
  scene.cameras.push_back(look_at("default", {-4.6f, 1.65f, 8.8f}, {0.9f, 1.75f, -2.0f}, 50.0));
  scene.cameras.push_back(look_at("detail", {3.2f, 1.15f, 4.5f}, {5.75f, 0.5f, 1.3f}, 45.0));
  const std::vector<CameraPose> walk = {{{-4.6f, 1.65f, 8.8f}, {0.9f, 1.75f, -2.0f}},
                                        {{-1.5f, 1.65f, 6.5f}, {1.5f, 1.5f, -1.0f}},
                                        {{0.2f, 1.65f, 3.4f}, {5.7f, 1.2f, 0.0f}},
                                        {{-1.2f, 1.65f, 1.2f}, {-5.5f, 1.8f, -0.5f}}};
  const std::vector<CameraPose> fly = {{{-8.0f, 6.0f, 10.0f}, {0.0f, 1.0f, -2.0f}},
                                       {{0.0f, 9.0f, 11.0f}, {0.0f, 1.0f, -2.0f}},
                                       {{8.0f, 7.0f, 8.0f}, {0.0f, 1.0f, -2.0f}},
                                       {{9.0f, 5.0f, 0.0f}, {0.0f, 1.0f, -3.0f}}};
  add_paths(scene, walk, fly);
  return scene;
}

BuiltinScene builtin_scene_courtyard() {
  return {
      "courtyard",
      "A Mediterranean courtyard in the late afternoon: columns, iron fence, foliage, stairs and everything else that strains "
      "shadows.",
      {},
      make_courtyard};
}

}  // namespace gnomon
