// The background reference: the same answers as the reference itself, coarse ones first, and none of a view that was given up.
#include "reference/cpu/progressive_reference.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "base/error.h"
#include "scene/load.h"

namespace gnomon {
namespace {

// A grid of points on the receiver of chart/sphere, facing up.
ProgressiveReference::View view_of(const Scene& scene, int side) {
  ProgressiveReference::View view;
  for (int i = 0; i < side * side; ++i) {
    const vec3 at(8.0f * (static_cast<float>(i % side) + 0.5f) / static_cast<float>(side) - 4.0f, 0.0f,
                  8.0f * (static_cast<float>(i / side) + 0.5f) / static_cast<float>(side) - 4.0f);
    view.points.push_back({at, 0, vec3(0, 1, 0), static_cast<uint32_t>(i)});
  }
  view.eye_ws = vec3(0, 5, 5);
  view.lights = {scene.lights.front()};
  view.lights.front().angular_diameter = 0.05f;
  view.samples = 16;
  return view;
}

// Every answer until the complete one.
std::vector<ProgressiveReference::Answer> answers_of(ProgressiveReference& reference) {
  std::vector<ProgressiveReference::Answer> answers;
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while ((answers.empty() || !answers.back().complete) && std::chrono::steady_clock::now() < end) {
    if (auto answer = reference.poll()) answers.push_back(std::move(*answer));
    std::this_thread::yield();
  }
  return answers;
}

TEST(ProgressiveReference, EndsWithTheReferencesOwnAnswer) {
  const Scene scene = load_scene("chart/sphere");
  const EmbreeReference embree(scene);
  SharedReference rays(scene);
  ProgressiveReference reference(rays, embree.triangle_count());
  const auto view = view_of(scene, 200);  // several bands
  reference.start(view);
  const auto answers = answers_of(reference);
  ASSERT_FALSE(answers.empty());
  ASSERT_TRUE(answers.back().complete);
  EXPECT_EQ(answers.back().samples, 16);
  EXPECT_DOUBLE_EQ(reference.share(), 1.0);
  const ReferenceResult whole = embree.trace(view.points, view.eye_ws, view.lights[0], true, 16, view.seed);
  EXPECT_EQ(answers.back().lights[0].visibility, whole.visibility);
  EXPECT_EQ(answers.back().lights[0].receiver, whole.receiver);
  EXPECT_NEAR(answers.back().lights[0].confidence, whole.confidence, 1e-3 * whole.confidence);
  EXPECT_GT(whole.confidence, 0.0) << "there is no penumbra in the view: the test shows little";
}

TEST(ProgressiveReference, AnswersForTheLastViewOnly) {
  const Scene scene = load_scene("chart/sphere");
  SharedReference rays(scene);
  ProgressiveReference reference(rays, rays.get().triangle_count());
  auto large = view_of(scene, 1000);
  large.samples = 4096;  // some minutes
  reference.start(large);
  reference.start(view_of(scene, 20));
  const auto answers = answers_of(reference);
  ASSERT_FALSE(answers.empty());
  EXPECT_TRUE(answers.back().complete);
  for (const auto& answer : answers) EXPECT_EQ(answer.lights[0].visibility.size(), 400u);
}

TEST(ProgressiveReference, RefusesAStructureThatTheRasteriserDoesNotDraw) {
  const Scene scene = load_scene("chart/sphere");
  SharedReference rays(scene);
  ProgressiveReference reference(rays, rays.get().triangle_count() + 1);
  reference.start(view_of(scene, 4));
  EXPECT_THROW(answers_of(reference), Error);
}

TEST(SharedReference, IsBuiltOnce) {
  const Scene scene = load_scene("chart/sphere");
  SharedReference rays(scene);
  const EmbreeReference* other = nullptr;
  std::thread([&] { other = &rays.get(); }).join();
  EXPECT_EQ(&rays.get(), other);
}

}  // namespace
}  // namespace gnomon
