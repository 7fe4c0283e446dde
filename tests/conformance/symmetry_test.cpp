// A scene whose x and z are exchanged, seen from between them, has the mirrored mask: no filter takes one axis of its map for
// the other.
#include <cmath>

#include "shadow/registry.h"
#include "stage.h"

namespace gnomon {
namespace {

using test::View;

// A floor and boxes, one of them near the edge that x = 4 is; `exchanged`: near z = 4.
Scene boxes(bool exchanged) {
  const auto turned = [&](const vec3& p) { return exchanged ? vec3(p.z, p.y, p.x) : p; };
  std::vector<MeshPart> parts = {test::box_part(vec3(-4, -0.2f, -4), vec3(4, 0, 4))};
  const std::pair<vec3, vec3> corners[] = {{{3.2f, 0.5f, -1.5f}, {3.9f, 1, 1.0f}}, {{-1, 0.3f, -2}, {0.4f, 1.5f, -1.4f}}};
  for (const auto& [low, high] : corners) parts.push_back(test::box_part(turned(low), turned(high)));
  Scene scene = test::scene_with(std::move(parts));
  scene.cameras.push_back(look_at("between", {7, 4, 7}, {0.5f, 0, 0.5f}, 50.0));
  scene.lights.push_back(test::make_sun({0, -1, 0}));
  return scene;
}

class Symmetry : public testing::TestWithParam<std::string> {};

TEST_P(Symmetry, ExchangedAxesMirrorTheMask) {
  constexpr uint32_t k_side = 84;
  View& plain = test::kept_view("boxes", [] { return boxes(false); }, {k_side, k_side});
  View& exchanged = test::kept_view("exchanged boxes", [] { return boxes(true); }, {k_side, k_side});
  const auto& spec = find_technique(GetParam());
  // Wide filters: a kernel of one texel has no axes.
  SettingsMap settings = test::settings_of(spec, {"single.size=128"});
  for (const auto& [filter, key, value] :
       {std::tuple("savsm", "width", "33"), std::tuple("vsm", "blur", "6"), std::tuple("evsm", "blur", "6"),
        std::tuple("esm", "blur", "6"), std::tuple("msm", "blur", "6"), std::tuple("pcf", "size", "11")}) {
    if (const auto found = settings.find(std::string_view(filter)); found != settings.end()) found->second.set(key, value, key);
  }
  const auto a = test::run_technique(plain, spec, settings).mask, b = test::run_technique(exchanged, spec, settings).mask;
  double difference = 0.0, shadow = 0.0;
  for (uint32_t y = 0; y < k_side; ++y) {
    for (uint32_t x = 0; x < k_side; ++x) {
      difference += std::abs(double(a[y * k_side + x]) - double(b[y * k_side + k_side - 1 - x]));
      shadow += 1.0 - double(a[y * k_side + x]);
    }
  }
  fmt::print("{}: differs by {:.4f} of the shadow\n", spec.name, difference / shadow);
  ASSERT_GT(shadow, 100.0);
  EXPECT_LT(difference / shadow, 0.02);
}

std::vector<std::string> techniques() {
  std::vector<std::string> names;
  for (const TechniqueSpec& spec : all_techniques()) {
    if (spec.name.starts_with("single/")) names.push_back(spec.name);
  }
  return names;
}
INSTANTIATE_TEST_SUITE_P(All, Symmetry, testing::ValuesIn(techniques()),
                         [](const auto& technique) { return test::test_name(technique.param); });

}  // namespace
}  // namespace gnomon
