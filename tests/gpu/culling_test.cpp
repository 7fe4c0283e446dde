// Draw lists of the culling pass against a brute-force loop on the CPU.
#include <random>

#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using test::device;

// More than one work group's worth of items, in several buckets.
Scene scattered_boxes() {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-20.0f, 20.0f), side(0.1f, 2.0f);
  Scene scene = test::scene_with({test::floor_part(20.0f)});
  for (int m = 1; m < 4; ++m) {
    Material material = scene.materials[0];
    material.masked = m & 1, material.double_sided = m & 2;
    scene.materials.push_back(material);
  }
  for (int i = 0; i < 900; ++i) {
    MeshPart part = part_of(i % 4);
    const vec3 half(side(random), side(random), side(random));
    add_box(part, -half, half, 1.0f);
    const std::string name = "box " + std::to_string(i);
    const vec3 at(place(random), place(random), place(random));
    mat4 transform = glm::translate(mat4(1.0f), at) * glm::rotate(mat4(1.0f), side(random), glm::normalize(vec3(1, 2, 3)));
    if (i % 3 == 0) transform = transform * glm::scale(mat4(1.0f), vec3(-1, 1, 1));
    add_object(scene, name, add_mesh(scene, name, {part}), transform);
    scene.objects.back().casts = i % 7 != 0;
  }
  scene.cameras.push_back(look_at("out", {0, 1, 0}, {10, 2, -7}, 60.0));
  scene.lights.push_back(test::make_sun({0, -1, 0}));
  return scene;
}

enum class Verdict { outside, inside, too_close_to_say };

// Of one plane: outside only where all eight corners are.
Verdict against_plane(const Box& box, const glm::dvec4& plane) {
  double farthest = -1e300, size = std::abs(plane.w);
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner(box.corner(i));
    farthest = std::max(farthest, glm::dot(glm::dvec3(plane), corner) + plane.w);
    size = std::max(size, glm::dot(glm::abs(glm::dvec3(plane)), glm::abs(corner)));
  }
  if (std::abs(farthest) < 1e-5 * size) return Verdict::too_close_to_say;
  return farthest < 0.0 ? Verdict::outside : Verdict::inside;
}

Verdict expected(const DrawItem& item, const mat4& clip_from_world, uint32_t flags) {
  if ((flags & k_cull_casters_only) && !(item.flags & k_item_casts)) return Verdict::outside;
  const Box box{item.bounds_min_ws, item.bounds_max_ws};
  const glm::dmat4 rows = glm::transpose(glm::dmat4(clip_from_world));
  std::vector<glm::dvec4> planes = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1]};
  if (flags & k_cull_depth) planes.push_back(rows[2]), planes.push_back(rows[3] - rows[2]);
  Verdict verdict = Verdict::inside;
  for (const auto& plane : planes) {
    const Verdict one = against_plane(box, plane);
    if (one == Verdict::outside) return one;
    if (one == Verdict::too_close_to_say) verdict = one;
  }
  return verdict;
}

struct DrawList {
  std::vector<uint32_t> counts;
  std::vector<DrawCommand> draws;  // all buckets' ranges; only the first counts[b] of each are valid
};

DrawList cull(test::View& view, const mat4& clip_from_world, uint32_t flags) {
  const GpuScene& scene = view.gpu_scene();
  const Buffer matrix(device(), "view", sizeof(mat4), BufferMemory::upload);
  matrix.mapped_as<mat4>()[0] = clip_from_world;
  matrix.flush();
  CulledDraws draws(device(), scene, "test");
  test::run_passes([&](Recorder& recorder) {
    draws.record(recorder, view.frame().cull_pipeline(), "cull", PassStage::other, matrix.address(), flags);
  });
  const auto uses = draws.uses();
  const Buffer &commands = **std::get_if<const Buffer*>(&uses[0].resource),
               &counts = **std::get_if<const Buffer*>(&uses[1].resource);
  DrawList list;
  list.counts = read_back_as<uint32_t>(device(), counts, k_bucket_count);
  list.draws = read_back_as<DrawCommand>(device(), commands, scene.item_count());
  return list;
}

// The items of a bucket that are drawn, in order.
std::vector<uint32_t> drawn(const DrawList& list, const Bucket& bucket, uint32_t b) {
  std::vector<uint32_t> items;
  for (uint32_t i = 0; i < list.counts[b]; ++i) items.push_back(list.draws[bucket.begin + i].first_instance);
  return items;
}

TEST(Culling, DrawListEqualsBruteForce) {
  test::View view(scattered_boxes());
  const GpuScene& scene = view.gpu_scene();
  std::vector<Camera> cameras = {look_at("a", {0, 1, 0}, {10, 2, -7}, 60.0), look_at("b", {30, 30, 30}, {0, 0, 0}, 20.0),
                                 look_at("c", {-15, 3, 2}, {-16, 3, 2}, 100.0)};
  cameras.push_back(cameras[1]);
  cameras.back().orthographic = true, cameras.back().half_height = 4.0f, cameras.back().far = 60.0f;
  size_t kept = 0, culled = 0, unclear = 0;
  for (const Camera& camera : cameras) {
    const mat4 clip_from_world = camera_data(camera, {64, 48}, 1).clip_from_world;
    for (const uint32_t flags : {0u, k_cull_depth, k_cull_casters_only, k_cull_depth | k_cull_casters_only}) {
      const DrawList list = cull(view, clip_from_world, flags);
      for (uint32_t b = 0; b < k_bucket_count; ++b) {
        const Bucket& bucket = scene.bucket(b);
        ASSERT_LE(list.counts[b], bucket.end - bucket.begin);
        const auto items = drawn(list, bucket, b);
        EXPECT_TRUE(std::is_sorted(items.begin(), items.end())) << "camera " << camera.name << ", bucket " << b;
        for (uint32_t item = bucket.begin; item < bucket.end; ++item) {
          const bool present = std::binary_search(items.begin(), items.end(), item);
          const Verdict verdict = expected(scene.item_list()[item], clip_from_world, flags);
          if (verdict == Verdict::too_close_to_say) {
            ++unclear;
            continue;
          }
          ++(present ? kept : culled);
          EXPECT_EQ(present, verdict == Verdict::inside)
              << "camera " << camera.name << ", flags " << flags << ", item " << item;
        }
      }
    }
  }
  EXPECT_GT(kept, 1000u);
  EXPECT_GT(culled, 1000u);
  EXPECT_LT(unclear, 10u);
}

TEST(Culling, CommandsDescribeTheirItems) {
  test::View view(scattered_boxes());
  const GpuScene& scene = view.gpu_scene();
  const DrawList list = cull(view, camera_data(view.scene().cameras[0], {64, 48}, 1).clip_from_world, k_cull_depth);
  for (uint32_t b = 0; b < k_bucket_count; ++b) {
    for (uint32_t i = 0; i < list.counts[b]; ++i) {
      const DrawCommand& command = list.draws[scene.bucket(b).begin + i];
      ASSERT_LT(command.first_instance, scene.item_count());
      const DrawItem& item = scene.item_list()[command.first_instance];
      EXPECT_EQ(command.index_count, item.index_count);
      EXPECT_EQ(command.first_index, item.first_index);
      EXPECT_EQ(command.vertex_offset, static_cast<int>(item.first_vertex));
      EXPECT_EQ(command.instance_count, 1u);
    }
  }
}

TEST(Culling, OrderIsTheSameEveryTime) {
  test::View view(scattered_boxes());
  const mat4 clip_from_world = camera_data(view.scene().cameras[0], {64, 48}, 1).clip_from_world;
  const DrawList first = cull(view, clip_from_world, k_cull_depth);
  for (int i = 0; i < 5; ++i) {
    const DrawList again = cull(view, clip_from_world, k_cull_depth);
    ASSERT_EQ(again.counts, first.counts);
    for (uint32_t b = 0; b < k_bucket_count; ++b) {
      EXPECT_EQ(drawn(again, view.gpu_scene().bucket(b), b), drawn(first, view.gpu_scene().bucket(b), b));
    }
  }
}

TEST(Culling, BucketsHoldWhatTheirNameSays) {
  test::View view(scattered_boxes());
  const GpuScene& scene = view.gpu_scene();
  uint32_t items = 0;
  for (uint32_t b = 0; b < k_bucket_count; ++b) {
    for (uint32_t i = scene.bucket(b).begin; i < scene.bucket(b).end; ++i, ++items) {
      const DrawItem& item = scene.item_list()[i];
      const Material& material = view.scene().materials[item.material];
      EXPECT_EQ(material.masked, (b & Bucket::k_masked) != 0);
      EXPECT_EQ(material.double_sided, (b & Bucket::k_double_sided) != 0);
      EXPECT_EQ((item.flags & k_item_mirrored) != 0, (b & Bucket::k_mirrored) != 0);
    }
  }
  EXPECT_EQ(items, scene.item_count());
  EXPECT_EQ(items, 901u);
}

}  // namespace
}  // namespace gnomon
