// Built-in scenes: valid, the same on every run and machine, of the promised sizes; charts are what their closed forms assume.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "base/file.h"
#include "scene/builtin/parts/noise.h"
#include "scene/load.h"

namespace gnomon {
namespace {

using glm::dvec3;

std::map<std::string, double> defaults_of(const BuiltinScene& scene) {
  std::map<std::string, double> options;
  for (const BuiltinOption& option : scene.options) options[option.name] = option.default_value;
  return options;
}

Scene built(const std::string& name, const std::map<std::string, double>& changes = {}) {
  for (const BuiltinScene& scene : builtin_scenes()) {
    if (scene.name != name) continue;
    auto options = defaults_of(scene);
    for (const auto& [option, value] : changes) options.at(option) = value;
    return scene.make(options);
  }
  ADD_FAILURE() << "no scene " << name;
  return {};
}

// Made once: half a second each in an optimised build.
const Scene& courtyard() {
  static const Scene scene = built("courtyard");
  return scene;
}
const Scene& small_terrain() {
  static const Scene scene = built("terrain", {{"detail", 0.01}});
  return scene;
}

std::vector<Scene> all_small() {
  return {courtyard(), small_terrain(), built("chart/sphere"), built("chart/slab"), built("chart/fence")};
}

const MeshPart& only_part(const Scene& scene, const std::string& object) {
  for (const Object& o : scene.objects) {
    if (o.name == object) return scene.meshes[static_cast<size_t>(o.mesh)].parts.at(0);
  }
  throw std::runtime_error("no object " + object);
}

// Every edge of every triangle is met by exactly one triangle that runs it the other way, by position.
bool closed(const MeshPart& part) {
  using Point = std::tuple<float, float, float>;
  std::map<std::pair<Point, Point>, int> edges;
  const auto point = [&](uint32_t index) {
    return Point{part.positions[index].x + 0.0f, part.positions[index].y + 0.0f, part.positions[index].z + 0.0f};
  };
  for (size_t i = 0; i < part.indices.size(); i += 3) {
    for (size_t k = 0; k < 3; ++k) ++edges[{point(part.indices[i + k]), point(part.indices[i + (k + 1) % 3])}];
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const auto back = edges.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != edges.end() && back->second == 1;
  });
}

TEST(builtin, scenes_are_listed_by_name_with_sensible_options) {
  const auto scenes = builtin_scenes();
  EXPECT_TRUE(std::is_sorted(scenes.begin(), scenes.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
  std::set<std::string> names;
  for (const BuiltinScene& scene : scenes) {
    names.insert(scene.name);
    EXPECT_FALSE(scene.summary.empty());
    for (const BuiltinOption& option : scene.options) {
      EXPECT_LE(option.min, option.default_value) << scene.name << ' ' << option.name;
      EXPECT_GE(option.max, option.default_value) << scene.name << ' ' << option.name;
      EXPECT_FALSE(option.help.empty());
    }
  }
  EXPECT_EQ(names, (std::set<std::string>{"chart/fence", "chart/slab", "chart/sphere", "courtyard", "hexworld", "lamps",
                                          "landscape", "terrain", "town"}));
}

TEST(builtin, scenes_pass_the_check_and_have_a_sun_and_a_default_camera) {
  for (const Scene& scene : all_small()) {
    EXPECT_NO_THROW(check_scene(scene)) << scene.name;
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].name, "sun");
    EXPECT_NEAR(glm::length(scene.lights[0].direction), 1.0f, 1e-6f);
    ASSERT_FALSE(scene.cameras.empty());
    EXPECT_EQ(scene.cameras[0].name, "default");
    EXPECT_TRUE(scene.source.empty());
  }
}

TEST(builtin, option_ends_are_valid_scenes) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    for (const BuiltinOption& option : builtin.options) {
      for (const double value : {option.min, option.max}) {
        auto options = defaults_of(builtin);
        const bool huge = option.name == "detail" && value == option.max && builtin.name != "hexworld";
        if (huge) continue;  // millions of vertices
        options[option.name] = value;
        EXPECT_NO_THROW(check_scene(builtin.make(options))) << builtin.name << ' ' << option.name << ' ' << value;
      }
    }
  }
}

TEST(builtin, two_builds_are_equal) {
  EXPECT_EQ(courtyard().content_hash(), built("courtyard").content_hash());
  EXPECT_EQ(small_terrain().content_hash(), built("terrain", {{"detail", 0.01}}).content_hash());
  for (const char* name : {"chart/sphere", "chart/slab", "chart/fence"})
    EXPECT_EQ(built(name).content_hash(), built(name).content_hash());
}

// Geometry and texels; not tangents, which are mesh_tools' own.
std::string generated_hash(const Scene& scene) {
  ContentHash hash;
  for (const Mesh& mesh : scene.meshes) {
    for (const MeshPart& part : mesh.parts) {
      hash.add_values(part.positions), hash.add_values(part.normals), hash.add_values(part.uvs), hash.add_values(part.indices);
    }
  }
  for (const Object& object : scene.objects) hash.add_value(object.world_from_object);
  for (const Texture& texture : scene.textures) hash.add_values(texture.image.rgba);
  return hash.hex();
}

// The same bits from every compiler and machine. A change here is a change of content: results from before and after it
// cannot be compared, so say so in the changelog.
TEST(builtin, content_is_the_same_everywhere) {
  EXPECT_EQ(generated_hash(courtyard()), "c536ddadad8c01a3");
  EXPECT_EQ(generated_hash(small_terrain()), "8f12649cc822cbad");
  EXPECT_EQ(generated_hash(built("town", {{"detail", 0.02}})), "df8074d0ed0d9be2");
  EXPECT_EQ(generated_hash(built("landscape", {{"detail", 0.02}})), "c3b8b6ac56a1cffe");
  EXPECT_EQ(generated_hash(built("hexworld", {{"radius", 30}})), "38972095912066c9");
  EXPECT_EQ(generated_hash(built("lamps")), "d4278ad3b4efc6b9");
  EXPECT_EQ(generated_hash(built("chart/sphere")), "98cfd48f28ee268a");
  EXPECT_EQ(generated_hash(built("chart/slab")), "8a715909a14f86d7");
  EXPECT_EQ(generated_hash(built("chart/fence")), "18c3db0fce244393");
}

TEST(builtin, trigonometry_agrees_with_the_library) {
  for (int i = -2000; i <= 2000; ++i) {
    const double x = 0.01237 * i;
    EXPECT_NEAR(sine(x), std::sin(x), 1e-15 * (1.0 + std::abs(x)));
    EXPECT_NEAR(cosine(x), std::cos(x), 1e-15 * (1.0 + std::abs(x)));
  }
}

TEST(builtin, textures_tile_without_a_seam) {
  for (const float t : {0.0f, 0.13f, 0.5f, 0.97f}) {
    EXPECT_FLOAT_EQ(tiling_fractal(0.0f, t, {5, 3}, 4, 9), tiling_fractal(1.0f, t, {5, 3}, 4, 9));
    EXPECT_FLOAT_EQ(tiling_fractal(t, 0.0f, {5, 3}, 4, 9), tiling_fractal(t, 1.0f, {5, 3}, 4, 9));
  }
}

TEST(builtin, courtyard_has_the_promised_size) {
  const Scene& scene = courtyard();
  EXPECT_GE(scene.triangle_count(), 10000u);
  EXPECT_LE(scene.triangle_count(), 14000u);
  EXPECT_GE(scene.objects.size(), 18u);
  EXPECT_LE(scene.objects.size(), 28u);
  EXPECT_TRUE(std::any_of(scene.materials.begin(), scene.materials.end(),
                          [](const Material& m) { return m.masked && m.double_sided; }));
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_EQ(scene.cameras[1].name, "detail");
  EXPECT_NEAR(scene.lights[0].angular_diameter, 0.533 * 3.14159265 / 180.0, 1e-6);
  std::set<std::string> names;
  for (const Object& object : scene.objects) EXPECT_TRUE(names.insert(object.name).second) << object.name;
}

TEST(builtin, terrain_has_the_promised_vertices) {
  const Scene scene = built("terrain");
  EXPECT_EQ(only_part(scene, "terrain").positions.size(), 135u * 135u);
  const size_t vertices = only_part(scene, "sculpture").positions.size();
  EXPECT_GE(vertices, 1200000u);
  EXPECT_LE(vertices, 1400000u);
}

TEST(builtin, closed_meshes_are_closed) {
  EXPECT_TRUE(closed(only_part(small_terrain(), "sculpture")));
  EXPECT_TRUE(closed(only_part(built("chart/slab"), "slab")));
  EXPECT_TRUE(closed(only_part(built("chart/sphere"), "sphere")));
  EXPECT_FALSE(closed(only_part(built("chart/fence"), "fence")));
}

TEST(builtin, normals_agree_with_winding_and_no_triangle_is_degenerate) {
  for (const Scene& scene : all_small()) {
    for (const Mesh& mesh : scene.meshes) {
      size_t against = 0, degenerate = 0, triangles = 0;
      for (const MeshPart& part : mesh.parts) {
        for (size_t i = 0; i < part.indices.size(); i += 3, ++triangles) {
          const auto corner = [&](size_t k) { return dvec3(part.positions[part.indices[i + k]]); };
          const dvec3 face = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
          degenerate += glm::length(face) < 1e-12 ? 1 : 0;
          for (size_t k = 0; k < 3; ++k) against += glm::dot(face, dvec3(part.normals[part.indices[i + k]])) < 0.0 ? 1 : 0;
        }
      }
      EXPECT_EQ(against, 0u) << scene.name << ' ' << mesh.name << " of " << 3 * triangles;
      EXPECT_EQ(degenerate, 0u) << scene.name << ' ' << mesh.name << " of " << triangles;
    }
  }
}

TEST(builtin, chart_sphere_vertices_lie_on_the_sphere) {
  const Scene scene = built("chart/sphere", {{"radius", 0.7}, {"height", 0.3}});
  for (const vec3& p : only_part(scene, "sphere").positions) EXPECT_NEAR(glm::length(dvec3(p) - dvec3(0, 1, 0)), 0.7, 2e-7);
}

// Bilinear alpha of the full-size level at a u of the picture.
double alpha_at(const Image8& image, double u) {
  const double x = u * image.width - 0.5, low = std::floor(x);
  const auto texel = [&](double i) { return image.at(std::clamp(static_cast<int>(i), 0, image.width - 1), 0)[3] / 255.0; };
  return texel(low) + (x - low) * (texel(low + 1) - texel(low));
}

TEST(builtin, chart_fence_edges_are_where_the_closed_form_has_them) {
  const Scene scene = built("chart/fence", {{"bars", 5}, {"gap", 0.4}});
  const Image8& image = scene.textures.at(0).image;
  Light overhead;  // along the quad's normal, so that z of a floor point is z of the quad
  overhead.direction = glm::normalize(vec3(1, -1, 0));
  int edges = 0;
  for (int i = 0; i <= 5 * 2; ++i) {
    const double u = double(i) / 11.0, z = 2.0 - 4.0 * u;
    for (const double offset : {-1e-6, 1e-6}) {
      if (i == 0 || i == 11) continue;
      const bool opaque = alpha_at(image, u + offset) >= 0.5;
      EXPECT_EQ(*scene.closed_form({1.0, 0.0, z - 4.0 * offset}, overhead), opaque ? 0.0 : 1.0) << i;
    }
    ++edges;
  }
  EXPECT_EQ(edges, 11);
  EXPECT_EQ(*scene.closed_form({0.41, 0, 0}, overhead), 0.0);  // bar in the middle, just above its lower end
  EXPECT_EQ(*scene.closed_form({0.39, 0, 0}, overhead), 1.0);
}

TEST(builtin, closed_forms_answer_on_the_floor_only) {
  for (const char* name : {"chart/sphere", "chart/slab", "chart/fence"}) {
    for (const double diameter : {0.0, 2.0}) {
      const Scene scene = built(name, {{"sun_deg", diameter}});
      int umbra = 0, lit = 0;
      for (int i = 0; i < 40 * 40; ++i) {
        const dvec3 point(-2.0 + 0.15 * (i % 40), 0.0, -3.0 + 0.15 * (i / 40));
        const auto visible = scene.closed_form(point, scene.lights[0]);
        ASSERT_TRUE(visible.has_value()) << name;
        EXPECT_TRUE(*visible >= 0.0 && *visible <= 1.0) << *visible;
        umbra += *visible < 1e-9 ? 1 : 0, lit += *visible > 1.0 - 1e-9 ? 1 : 0;
      }
      EXPECT_GT(umbra, 5) << name;
      EXPECT_GT(lit, 100) << name;
      EXPECT_FALSE(scene.closed_form({0.0, 0.5, 0.0}, scene.lights[0]).has_value()) << name;
    }
  }
  EXPECT_FALSE(courtyard().closed_form);
}

}  // namespace
}  // namespace gnomon
