// glTF: EXT_meshopt_compression and KHR_draco_mesh_compression, encoded here.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cmath>

#include "base/error.h"
#include "gltf_builder.h"
#include "scene_files.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#pragma GCC diagnostic pop

namespace gnomon {
namespace {

using test_files::GltfBuilder;
using test_files::json;

// A wavy grid, so that compression has something to do.
struct Grid {
  static constexpr uint32_t k_side = 20;
  std::vector<vec3> positions;
  std::vector<uint32_t> indices;
  Grid() {
    for (uint32_t y = 0; y <= k_side; ++y) {
      for (uint32_t x = 0; x <= k_side; ++x) positions.emplace_back(x, y, std::sin(0.5f * static_cast<float>(x * y)));
    }
    for (uint32_t y = 0; y < k_side; ++y) {
      for (uint32_t x = 0; x < k_side; ++x) {
        const uint32_t a = y * (k_side + 1) + x, b = a + k_side + 1;
        indices.insert(indices.end(), {a, a + 1, b + 1, a, b + 1, b});
      }
    }
  }
  double area() const {
    MeshPart part;
    part.positions = positions, part.indices = indices;
    return test_files::area(part);
  }
};

std::vector<std::byte> as_bytes(const std::vector<unsigned char>& bytes) {
  const auto span = std::as_bytes(std::span(bytes));
  return {span.begin(), span.end()};
}

std::vector<std::byte> encoded_vertices(const void* data, size_t count, size_t stride) {
  std::vector<unsigned char> buffer(meshopt_encodeVertexBufferBound(count, stride));
  buffer.resize(meshopt_encodeVertexBuffer(buffer.data(), buffer.size(), data, count, stride));
  return as_bytes(buffer);
}

// A builder whose views are compressed; the uncompressed buffer is a fallback without data.
class MeshoptBuilder : public GltfBuilder {
 public:
  int compressed_view(const std::vector<std::byte>& encoded, size_t count, size_t stride, const std::string& mode,
                      const std::string& filter = "NONE") {
    while (data.size() % 4 != 0) data.push_back(std::byte{0});
    const json extension = {
        {"buffer", 0},  {"byteOffset", data.size()}, {"byteLength", encoded.size()}, {"byteStride", stride}, {"count", count},
        {"mode", mode}, {"filter", filter}};
    data.insert(data.end(), encoded.begin(), encoded.end());
    json v = {{"buffer", 1},
              {"byteOffset", fallback_size_},
              {"byteLength", count * stride},
              {"extensions", {{"EXT_meshopt_compression", extension}}}};
    if (mode == "ATTRIBUTES") v["byteStride"] = stride;
    fallback_size_ += (count * stride + 3) & ~size_t{3};
    root["buffers"][1] = {{"byteLength", fallback_size_}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}};
    root["extensionsRequired"] = {"EXT_meshopt_compression", "KHR_mesh_quantization"};
    return add("bufferViews", v);
  }
  int compressed_accessor(int view, const char* type, int component, size_t count, bool normalised = false) {
    return add(
        "accessors",
        {{"bufferView", view}, {"type", type}, {"componentType", component}, {"count", count}, {"normalized", normalised}});
  }
  int compressed_positions(const Grid& grid) {
    const auto encoded = encoded_vertices(grid.positions.data(), grid.positions.size(), sizeof(vec3));
    return compressed_accessor(compressed_view(encoded, grid.positions.size(), sizeof(vec3), "ATTRIBUTES"), "VEC3",
                               test_files::k_float, grid.positions.size());
  }

 private:
  size_t fallback_size_ = 0;
};

TEST(Meshopt, AttributesTrianglesAndIndexSequences) {
  const Grid grid;
  for (const bool sequence : {false, true}) {
    for (const size_t width : {size_t{2}, size_t{4}}) {
      MeshoptBuilder b;
      const int positions = b.compressed_positions(grid);
      std::vector<unsigned char> buffer;
      if (sequence) {
        buffer.resize(meshopt_encodeIndexSequenceBound(grid.indices.size(), grid.positions.size()));
        buffer.resize(meshopt_encodeIndexSequence(buffer.data(), buffer.size(), grid.indices.data(), grid.indices.size()));
      } else {
        buffer.resize(meshopt_encodeIndexBufferBound(grid.indices.size(), grid.positions.size()));
        buffer.resize(meshopt_encodeIndexBuffer(buffer.data(), buffer.size(), grid.indices.data(), grid.indices.size()));
      }
      const int view = b.compressed_view(as_bytes(buffer), grid.indices.size(), width, sequence ? "INDICES" : "TRIANGLES");
      const int indices =
          b.compressed_accessor(view, "SCALAR", width == 2 ? test_files::k_ushort : test_files::k_uint, grid.indices.size());
      b.node({{"mesh", b.mesh({{"POSITION", positions}}, indices)}});
      const Scene scene = b.load();
      EXPECT_EQ(scene.triangle_count(), 2u * Grid::k_side * Grid::k_side);
      EXPECT_NEAR(test_files::area(scene), grid.area(), 1e-3);
      EXPECT_EQ(load_gltf_from_memory(b.glb(), "x.glb", {}).content_hash(), scene.content_hash());
    }
  }
}

TEST(Meshopt, OctahedralNormals) {
  const std::vector<vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const vec3 n0 = glm::normalize(vec3(0.3f, -0.2f, 0.9f)), n1 = glm::normalize(vec3(-0.5f, 0.5f, -0.7f));
  const std::vector<vec4> normals = {vec4(n0, 0), vec4(n1, 0), vec4(0, 0, 1, 0), vec4(1, 0, 0, 0)};
  for (const size_t stride : {size_t{4}, size_t{8}}) {
    std::vector<unsigned char> filtered(4 * stride);
    meshopt_encodeFilterOct(filtered.data(), 4, stride, stride == 4 ? 8 : 16, &normals[0].x);
    MeshoptBuilder b;
    const int view = b.compressed_view(encoded_vertices(filtered.data(), 4, stride), 4, stride, "ATTRIBUTES", "OCTAHEDRAL");
    const int accessor = b.compressed_accessor(view, "VEC3", stride == 4 ? test_files::k_byte : test_files::k_short, 4, true);
    b.node({{"mesh", b.mesh({{"POSITION", b.positions(corners)}, {"NORMAL", accessor}}, b.indices({0, 1, 2, 1, 3, 2}))}});
    const Scene scene = b.load();
    const MeshPart& part = scene.meshes.at(0).parts.at(0);
    for (size_t i = 0; i < part.positions.size(); ++i) {
      const auto corner = static_cast<size_t>(part.positions[i].x + 2 * part.positions[i].y);
      EXPECT_LT(glm::distance(part.normals[i], vec3(normals[corner])), stride == 4 ? 0.02f : 1e-3f);
    }
  }
}

TEST(Meshopt, QuaternionAndExponentialFiltersInInstances) {
  const float half = std::sqrt(0.5f);
  const std::vector<vec4> rotations = {{0, 0, 0, 1}, {0, 0, half, half}, {half, 0, 0, half}, {0, half, 0, -half}};
  const std::vector<vec3> translations = {{0, 0, 0}, {10, 0, 0}, {0, -20, 0.5f}, {1000, 2000, 3000}};
  std::vector<unsigned char> quaternions(4 * 8), exponents(4 * 12);
  meshopt_encodeFilterQuat(quaternions.data(), 4, 8, 16, &rotations[0].x);
  meshopt_encodeFilterExp(exponents.data(), 4, 12, 20, &translations[0].x);
  MeshoptBuilder b;
  b.triangle();
  const int r =
      b.compressed_accessor(b.compressed_view(encoded_vertices(quaternions.data(), 4, 8), 4, 8, "ATTRIBUTES", "QUATERNION"),
                            "VEC4", test_files::k_short, 4, true);
  const int t =
      b.compressed_accessor(b.compressed_view(encoded_vertices(exponents.data(), 4, 12), 4, 12, "ATTRIBUTES", "EXPONENTIAL"),
                            "VEC3", test_files::k_float, 4);
  b.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"ROTATION", r}, {"TRANSLATION", t}};
  const Scene scene = b.load();
  ASSERT_EQ(scene.objects.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    const mat4& m = scene.objects[i].world_from_object;
    EXPECT_LT(glm::distance(vec3(m[3]), translations[i]), 0.01f);
    const mat3 expected = glm::mat3_cast(glm::quat(rotations[i].w, rotations[i].x, rotations[i].y, rotations[i].z));
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::distance(vec3(m[c]), expected[c]), 1e-3f);
  }
}

TEST(Meshopt, DamageIsReportedWithItsPlace) {
  const Grid grid;
  const auto error_with = [&](const std::function<void(MeshoptBuilder&, json&)>& damage) -> std::string {
    MeshoptBuilder b;
    const int positions = b.compressed_positions(grid);
    b.node({{"mesh", b.mesh({{"POSITION", positions}})}});
    damage(b, b.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]);
    try {
      b.load();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string place = "test.gltf: bufferViews[0].extensions.EXT_meshopt_compression";
  const std::vector<std::function<void(MeshoptBuilder&, json&)>> damages = {
      [](MeshoptBuilder& b, json&) { b.data[0] = std::byte{0}; },
      [](MeshoptBuilder&, json& e) { e["byteLength"] = 30; },
      [](MeshoptBuilder&, json& e) { e["byteLength"] = 1 << 30; },
      [](MeshoptBuilder&, json& e) { e["byteOffset"] = 1 << 30; },
      [](MeshoptBuilder&, json& e) { e["mode"] = "TRIANGLES"; },
      [](MeshoptBuilder&, json& e) { e["mode"] = "WRONG"; },
      [](MeshoptBuilder&, json& e) { e["filter"] = "WRONG"; },
      [](MeshoptBuilder&, json& e) { e["filter"] = "QUATERNION"; },
      [](MeshoptBuilder&, json& e) { e["filter"] = "OCTAHEDRAL"; },
      [](MeshoptBuilder&, json& e) { e["byteStride"] = 13; },
      [](MeshoptBuilder&, json& e) { e["byteStride"] = 0; },
      [](MeshoptBuilder&, json& e) { e["count"] = 4000000000u; },
      [](MeshoptBuilder&, json& e) { e["buffer"] = 1; },
      [](MeshoptBuilder&, json& e) { e["buffer"] = 2; },
  };
  for (size_t i = 0; i < damages.size(); ++i) {
    const std::string message = error_with(damages[i]);
    EXPECT_TRUE(message.starts_with(place)) << i << ": " << message;
  }
  // A tiny stream that claims to be gigabytes, with a fallback buffer that claims the same.
  const std::string bomb = error_with([](MeshoptBuilder& b, json& e) {
    e["count"] = 300000000u;
    b.root["buffers"][1]["byteLength"] = 3600000000u;
    b.root["bufferViews"][0]["byteLength"] = 3600000000u;
  });
  EXPECT_NE(bomb.find("cannot decode to as many"), std::string::npos) << bomb;
}

// KHR_meshopt_compression: the ratified name. Its placeholder buffers need no mark, colours have a filter.
TEST(Meshopt, TheRatifiedNameAndItsColours) {
  const Grid grid;
  MeshoptBuilder b;
  const int positions = b.compressed_positions(grid);
  // Y, Co, Cg of 7 bits, and alpha of 6 bits below a bit that is set: red 127, green 0, blue 0; alpha 63 of 63.
  std::vector<uint8_t> colours;
  for (size_t i = 0; i < grid.positions.size(); ++i) colours.insert(colours.end(), {32, 64, 0xe0, 0x7f});
  const int view = b.compressed_view(encoded_vertices(colours.data(), grid.positions.size(), 4), grid.positions.size(), 4,
                                     "ATTRIBUTES", "COLOR");
  const int accessor = b.compressed_accessor(view, "VEC4", test_files::k_ubyte, grid.positions.size(), true);
  const std::vector<uint32_t> indices = grid.indices;
  b.node({{"mesh", b.mesh({{"POSITION", positions}, {"COLOR_0", accessor}},
                          b.accessor(indices, "SCALAR", test_files::k_uint, indices.size()))}});
  const auto rename = [](json& value) {
    value["extensions"]["KHR_meshopt_compression"] = value["extensions"]["EXT_meshopt_compression"];
    value["extensions"].erase("EXT_meshopt_compression");
  };
  for (json& v : b.root["bufferViews"]) {
    if (v.contains("extensions")) rename(v);
  }
  b.root["buffers"][1].erase("extensions");
  b.root["extensionsRequired"] = {"KHR_meshopt_compression"};
  const Scene scene = b.load();
  EXPECT_NEAR(test_files::area(scene), grid.area(), 1e-3);
  EXPECT_LT(glm::distance(scene.meshes.at(0).parts.at(0).colours[0], vec4(1, 0, 0, 1)), 0.01f);
}

TEST(Meshopt, ALaterCodecIsNamedAndAFallbackIsReadInstead) {
  const Grid grid;
  MeshoptBuilder b;
  const int positions = b.compressed_positions(grid);
  b.node({{"mesh",
           b.mesh({{"POSITION", positions}}, b.accessor(grid.indices, "SCALAR", test_files::k_uint, grid.indices.size()))}});
  b.data[0] = std::byte{0xae};  // a version that no library knows
  EXPECT_NE(b.error().find("version 14 of the vertex codec"), std::string::npos) << b.error();
  const auto bytes = std::as_bytes(std::span(grid.positions));
  b.root["buffers"][1]["uri"] = GltfBuilder::data_uri(bytes);
  EXPECT_NEAR(test_files::area(b.load()), grid.area(), 1e-3);
}

// --- Draco ---

struct DracoData {
  std::vector<std::byte> bytes;
  int position_id = 0, uv_id = 0;
};

DracoData encoded_with_draco(const Grid& grid) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(grid.indices.size() / 3));
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
  for (uint32_t f = 0; f < grid.indices.size() / 3; ++f) {
    const vec3 p[3] = {grid.positions[grid.indices[3 * f]], grid.positions[grid.indices[3 * f + 1]],
                       grid.positions[grid.indices[3 * f + 2]]};
    const vec2 t[3] = {vec2(p[0]) / 20.0f, vec2(p[1]) / 20.0f, vec2(p[2]) / 20.0f};
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(f), &p[0], &p[1], &p[2]);
    builder.SetAttributeValuesForFace(uv, draco::FaceIndex(f), &t[0], &t[1], &t[2]);
  }
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 16);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 14);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  const auto bytes = std::as_bytes(std::span(buffer.data(), buffer.size()));
  return {{bytes.begin(), bytes.end()},
          static_cast<int>(mesh->attribute(position)->unique_id()),
          static_cast<int>(mesh->attribute(uv)->unique_id())};
}

GltfBuilder draco_file(const Grid& grid, const DracoData& draco) {
  GltfBuilder b;
  const size_t vertices = grid.positions.size();
  const int positions = b.add("accessors", {{"type", "VEC3"}, {"componentType", test_files::k_float}, {"count", vertices}});
  const int uvs = b.add("accessors", {{"type", "VEC2"}, {"componentType", test_files::k_float}, {"count", vertices}});
  const int indices =
      b.add("accessors", {{"type", "SCALAR"}, {"componentType", test_files::k_ushort}, {"count", grid.indices.size()}});
  json extension = {{"bufferView", b.view(draco.bytes)},
                    {"attributes", {{"POSITION", draco.position_id}, {"TEXCOORD_0", draco.uv_id}}}};
  b.node({{"mesh", b.mesh({{"POSITION", positions}, {"TEXCOORD_0", uvs}}, indices,
                          {{"extensions", {{"KHR_draco_mesh_compression", extension}}}})}});
  b.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return b;
}

TEST(Draco, AccessorsWithoutBufferViews) {
  const Grid grid;
  const Scene scene = draco_file(grid, encoded_with_draco(grid)).load();
  EXPECT_EQ(scene.triangle_count(), 2u * Grid::k_side * Grid::k_side);
  EXPECT_NEAR(test_files::area(scene), grid.area(), 0.5);
  const MeshPart& part = scene.meshes.at(0).parts.at(0);
  for (size_t i = 0; i < part.positions.size(); ++i)
    EXPECT_LT(glm::distance(20.0f * part.uvs[i], vec2(part.positions[i])), 0.01f);
}

TEST(Draco, DamageIsReportedWithItsPlace) {
  const Grid grid;
  const DracoData draco = encoded_with_draco(grid);
  GltfBuilder wrong = draco_file(grid, draco);
  wrong.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 17;
  EXPECT_THROW(wrong.load(), Error);
  for (size_t i = 0; i < draco.bytes.size(); i += 3) {
    DracoData damaged = draco;
    damaged.bytes[i] ^= std::byte{0x41};
    try {
      check_scene(draco_file(grid, damaged).load());
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("test.gltf: meshes[0].primitives[0].")) << error.what();
    }
    damaged = draco;
    damaged.bytes.resize(std::max<size_t>(i, 1));
    EXPECT_THROW(draco_file(grid, damaged).load(), Error) << "cut at " << i;
  }
}

}  // namespace
}  // namespace gnomon
