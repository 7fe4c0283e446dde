// Where shadows lie: a filter that reads texels off centre moves them all, which errors along edges hardly show.
#include <cmath>

#include "stage.h"

namespace gnomon {
namespace {

using test::View;

// A turned box over a floor, both seen along a sun that stands overhead: texels of its edges lie to all sides alike.
View& turned_box() {
  return test::kept_view("turned box",
                         [] {
                           Scene scene = test::scene_with({test::floor_part(4.0f), test::box_part({-1, 0.8f, -1}, {1, 1, 1})});
                           scene.objects[1].world_from_object = glm::translate(mat4(1.0f), vec3(0.37f, 0, -0.21f)) *
                                                                glm::rotate(mat4(1.0f), 0.47f, vec3(0, 1, 0));
                           // From the side, below the box.
                           scene.cameras.push_back(look_at("below", {3.5f, 0.7f, 3.0f}, {0.2f, 0, -0.3f}, 60.0));
                           scene.lights.push_back(test::make_sun({0, -1, 0}, 0.02f));
                           return scene;
                         },
                         {192, 144});
}

// Of the shadow on the floor, metres; each sample counts as much as the floor that it shows.
vec2 centre_of_shadow(const std::vector<float>& mask, const std::vector<SurfacePoint>& points, const vec3& eye) {
  glm::dvec2 sum(0.0);
  double weights = 0.0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (points[i].object != 0) continue;
    const vec3 to_eye = eye - points[i].position_ws;
    const double distance = glm::length(to_eye), floor_of_sample = distance * distance * distance / to_eye.y;
    const double weight = (1.0 - double(mask[i])) * floor_of_sample;
    sum += weight * glm::dvec2(points[i].position_ws.x, points[i].position_ws.z);
    weights += weight;
  }
  return vec2(sum / weights);
}

TEST(Place, ShadowsLieBelowTheirCaster) {
  View& view = turned_box();
  view.draw();
  const auto points = view.frame().read_points();
  const vec3 eye = view.frame().camera().eye_ws;
  const vec2 expected = centre_of_shadow(test::hard_reference(view).visibility, points, eye);
  constexpr float k_texel_m = 8.0f / 128.0f;
  std::vector<std::pair<std::string, std::string>> cases = {
      {"single/esm", "esm.prefilter=true"},   {"single/esm", "esm.space=exponential"},
      {"single/pcf", "pcf.kernel=optimised"}, {"single/pcf", "pcf.size=4"},
      {"single/pcf", "pcf.kernel=vogel"},     {"single/pcf", "bias.receiver_plane=false"},
      {"single/vsm", "vsm.mips=true"},        {"single/savsm", "savsm.width=4"}};
  for (const auto& spec : all_techniques()) {
    if (spec.name.starts_with("single/")) cases.emplace_back(spec.name, "bias.constant=0.2");
  }
  for (const auto& [name, assignment] : cases) {
    const auto& spec = find_technique(name);
    const auto mask = test::run_technique(view, spec, test::settings_of(spec, {"single.size=128", assignment})).mask;
    const vec2 off = (centre_of_shadow(mask, points, eye) - expected) / k_texel_m;
    fmt::print("{}, {}: {:.2f} and {:.2f} texels off\n", name, assignment, off.x, off.y);
    EXPECT_LT(glm::length(off), 0.35f) << name << ", " << assignment;
  }
}

}  // namespace
}  // namespace gnomon
