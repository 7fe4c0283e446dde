// The casters of a scene as Embree holds them: one structure per mesh, an instance per casting object, alpha tested by a
// filter.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "reference/cpu/embree_api.h"
#include "scene/scene.h"

namespace gnomon {

class Acceleration {
 public:
  // Keeps a reference to the scene. Throws Error where Embree refuses (memory, CPU without SSE).
  explicit Acceleration(const Scene& scene);

  RTCScene top() const { return top_.get(); }
  size_t triangle_count() const { return triangle_count_; }

 private:
  // What the alpha filter of one part reads; Embree keeps its address.
  struct MaskedPart {
    const MeshPart& part;
    const Material& material;
    const Texture* texture;  // may be null
  };

  using CastingParts = std::vector<size_t>;  // of a mesh, those that have triangles

  CastingParts casting_parts(const Object& object, const Mesh& mesh) const;
  embree::Scene build_mesh(const Mesh& mesh, const CastingParts& parts, const mat4& transform);
  embree::Geometry build_part(const MeshPart& part, const mat4& transform);
  void add_instance(RTCScene mesh, const mat4& world_from_object);
  void check() const;

  static bool exists(const MaskedPart& masked, unsigned int triangle, float u, float v);
  static void alpha_filter(const RTCFilterFunctionNArguments* arguments);

  const Scene& scene_;
  embree::Device device_;
  std::vector<std::unique_ptr<MaskedPart>> masked_parts_;
  embree::Scene top_;
  size_t triangle_count_ = 0;
};

}  // namespace gnomon
