// Builds the two levels and evaluates coverage at hits on masked parts.
#include "reference/cpu/acceleration.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/glsl/alpha.glsl"

namespace gnomon {
namespace {

float texel_alpha(const Texture& texture, int x, int y) {
  const int wrapped_x = wrap_texel(x, texture.image.width, static_cast<uint32_t>(texture.wrap_u));
  const int wrapped_y = wrap_texel(y, texture.image.height, static_cast<uint32_t>(texture.wrap_v));
  return static_cast<float>(texture.image.at(wrapped_x, wrapped_y)[3]) * (1.0f / 255.0f);
}

float texture_alpha(const Texture& texture, const vec2& uv) {
  const vec2 position = texel_position(uv, {texture.image.width, texture.image.height});
  const ivec2 low = texel_below(position);
  return bilinear_alpha(texel_alpha(texture, low.x, low.y), texel_alpha(texture, low.x + 1, low.y),
                        texel_alpha(texture, low.x, low.y + 1), texel_alpha(texture, low.x + 1, low.y + 1),
                        texel_weight(position));
}

}  // namespace

Acceleration::Acceleration(const Scene& scene) : scene_(scene), device_(rtcNewDevice(nullptr)) {
  if (!device_) fail("the CPU reference cannot start: Embree error {}", static_cast<int>(rtcGetDeviceError(nullptr)));
  top_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(top_.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(top_.get(), RTC_BUILD_QUALITY_HIGH);
  std::map<std::pair<int, CastingParts>, embree::Scene> shared;  // the instances keep them alive
  for (const Object& object : scene.objects) {
    const Mesh& mesh = scene.meshes[static_cast<size_t>(object.mesh)];
    const CastingParts parts = casting_parts(object, mesh);
    if (parts.empty()) continue;
    for (const size_t part : parts) triangle_count_ += mesh.parts[part].triangle_count();
    if (invertible(object.world_from_object)) {
      embree::Scene& once = shared[{object.mesh, parts}];
      if (!once) once = build_mesh(mesh, parts, mat4(1.0f));
      add_instance(once.get(), object.world_from_object);
    } else {
      add_instance(build_mesh(mesh, parts, object.world_from_object).get(), mat4(1.0f));
    }
  }
  rtcCommitScene(top_.get());
  check();
}

Acceleration::CastingParts Acceleration::casting_parts(const Object& object, const Mesh& mesh) const {
  CastingParts parts;
  for (size_t i = 0; i < mesh.parts.size(); ++i) {
    const MeshPart& part = mesh.parts[i];
    const Material& material = scene_.materials[static_cast<size_t>(part.material)];
    if (part.triangle_count() > 0 && part_casts(object, material)) parts.push_back(i);
  }
  return parts;
}

embree::Scene Acceleration::build_mesh(const Mesh& mesh, const CastingParts& parts, const mat4& transform) {
  embree::Scene built(rtcNewScene(device_.get()));
  rtcSetSceneFlags(built.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(built.get(), RTC_BUILD_QUALITY_HIGH);
  for (const size_t part : parts) {
    const embree::Geometry geometry = build_part(mesh.parts[part], transform);
    rtcAttachGeometry(built.get(), geometry.get());
  }
  rtcCommitScene(built.get());
  check();
  return built;
}

embree::Geometry Acceleration::build_part(const MeshPart& part, const mat4& transform) {
  embree::Geometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  // Copies: Embree reads whole 16 bytes of the last vertex, which the scene's own arrays do not have.
  auto* positions = static_cast<vec3*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               sizeof(vec3), part.positions.size()));
  auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(uint32_t), part.triangle_count()));
  check();
  const auto transformed_position = [&](const vec3& position) { return vec3(transform * vec4(position, 1.0f)); };
  std::transform(part.positions.begin(), part.positions.end(), positions, transformed_position);
  std::copy(part.indices.begin(), part.indices.end(), indices);

  const Material& material = scene_.materials[static_cast<size_t>(part.material)];
  if (material.caster_cutoff() >= 0.0f) {
    const int texture = material.caster_texture();
    const Texture* picture = texture == k_no_texture ? nullptr : &scene_.textures[static_cast<size_t>(texture)];
    masked_parts_.push_back(std::make_unique<MaskedPart>(MaskedPart{part, material, picture}));
    rtcSetGeometryUserData(geometry.get(), masked_parts_.back().get());
    rtcSetGeometryOccludedFilterFunction(geometry.get(), alpha_filter);
  }
  rtcCommitGeometry(geometry.get());
  return geometry;
}

void Acceleration::add_instance(RTCScene mesh, const mat4& world_from_object) {
  const embree::Geometry instance(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(instance.get(), mesh);
  rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, glm::value_ptr(world_from_object));
  rtcCommitGeometry(instance.get());
  rtcAttachGeometry(top_.get(), instance.get());
}

void Acceleration::check() const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_OUT_OF_MEMORY)
    fail("the CPU reference: not enough memory for the acceleration structure of {}", scene_.name);
  if (error != RTC_ERROR_NONE) fail("the CPU reference: Embree error {} on scene {}", static_cast<int>(error), scene_.name);
}

bool Acceleration::exists(const MaskedPart& masked, unsigned int triangle, float u, float v) {
  const Material& material = masked.material;
  float alpha = material.base_colour.w;
  if (masked.texture) {
    const uint32_t* corner = &masked.part.indices[size_t{3} * triangle];
    const std::vector<vec2>& uvs = masked.part.uvs;
    const vec2 uv = interpolate_uv(uvs[corner[0]], uvs[corner[1]], uvs[corner[2]], u, v);
    alpha *= texture_alpha(*masked.texture, transform_uv(material.base_colour_uv.row_u, material.base_colour_uv.row_v, uv));
  }
  return alpha >= material.caster_cutoff();
}

void Acceleration::alpha_filter(const RTCFilterFunctionNArguments* arguments) {
  const auto& masked = *static_cast<const MaskedPart*>(arguments->geometryUserPtr);
  for (unsigned int i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] != -1) continue;
    const unsigned int triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
    const float u = RTCHitN_u(arguments->hit, arguments->N, i), v = RTCHitN_v(arguments->hit, arguments->N, i);
    if (!exists(masked, triangle, u, v)) arguments->valid[i] = 0;  // the ray goes on
  }
}

}  // namespace gnomon
