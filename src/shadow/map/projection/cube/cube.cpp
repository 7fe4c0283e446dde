// Six perspective views around a point light (Gerasimov 2004, "Omnidirectional shadow mapping", GPU Gems). An array of six
// layers rather than a cube image, so that every filter that reads arrays works; faces overlap by a border, so that no kernel
// sees a seam.
#include <cmath>

#include "shadow/map/light_views.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Six maps around a point light, one for each face of a cube.\n"
    "Gerasimov 2004. Six depth passes, less what culling leaves out. Texels are up to three times smaller in a face's corner "
    "than\n"
    "in its middle. Faces overlap by cube.border texels, so that kernels up to that radius meet no seam.";

class Cube : public Projection {
 public:
  explicit Cube(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  uint32_t map_size() const override { return static_cast<uint32_t>(params_.size); }
  uint32_t layers() const override { return 6; }

  std::vector<ShadowView> views(const Frame& frame, const Light& light) const override {
    // The nearest caster may be off to the side of every face's axis.
    const auto [near, far] = distance_range(light.position, light.range, frame.scene().caster_bounds(), frame.scene().bounds());
    const float size = static_cast<float>(params_.size);
    const float half_angle = std::atan(size / std::max(size - 2.0f * params_.border, 0.5f * size));
    std::vector<ShadowView> views;
    for (int face = 0; face < 6; ++face) {
      vec3 forward(0.0f), x, y;
      forward[face / 2] = face % 2 ? -1.0f : 1.0f;
      orthonormal_basis(forward, x, y);
      views.push_back(perspective_view(light.position, mat3(x, y, forward), half_angle, near, far, map_size()));
      views.back().border = params_.border;
    }
    return views;
  }

 private:
  Params params_;
};

}  // namespace

GNOMON_REGISTER(projection, Projection) {
  return {GNOMON_ID_TEXT,
          k_manual,
          param_table_storage(),
          {LightKind::point},
          [](const ParamBlock& params) -> std::unique_ptr<Projection> { return std::make_unique<Cube>(params); }};
}

}  // namespace gnomon
