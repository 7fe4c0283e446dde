// Memory that runs out while a frame is made and drawn: an error, or the same mask, never a half; nothing is left behind on the
// device.
#include "support/failing_allocation.h"
#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using namespace test;

Scene small_scene() {
  Scene scene = scene_with({floor_part(4.0f), box_part(vec3(-1, 1, -1), vec3(1, 2, 1))});
  scene.lights = {make_sun(vec3(0.5f, -1.0f, 0.2f))};
  scene.cameras = {framing_camera(scene, 1.0f)};
  return scene;
}

// `technique`: one kind of map, filter or ray each.
void frame_without_memory(const char* technique) {
  const TechniqueSpec& spec = find_technique(technique);
  const SettingsMap settings = settings_of(spec);
  const uint64_t before = device().allocated_bytes();
  try_without_memory(
      technique,
      [&] {
        View view(small_scene(), {16, 16});
        return mixed(0, run_technique(view, spec, settings).mask);
      },
      80);
  EXPECT_EQ(device().allocated_bytes(), before) << technique;
}

TEST(WithoutMemory, AFrameWithAMapIsDrawnWholeOrNotAtAll) { frame_without_memory("single/hard"); }
TEST(WithoutMemory, AFrameWithMomentsIsDrawnWholeOrNotAtAll) { frame_without_memory("cascaded/evsm"); }
TEST(WithoutMemory, AFrameWithRaysIsDrawnWholeOrNotAtAll) { frame_without_memory("ray_traced"); }

}  // namespace
}  // namespace gnomon
