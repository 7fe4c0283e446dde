// Goals of the foundation: a frame's CPU time does not grow with the number of objects; loading is limited by the disk and the
// parser, not by what follows. Prints one line per goal: what, figures, ratio, goal.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "base/statistics.h"
#include "lab/timing.h"
#include "scene/load.h"
#include "scene/mesh_tools.h"
#include "shadow/technique.h"

namespace {

using namespace gnomon;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

MeshPart box_part() {
  MeshPart part;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    vec3 n(0.0f), u(0.0f), v(0.0f);
    n[axis] = face % 2 ? 1.0f : -1.0f;
    u[(axis + 1) % 3] = 1.0f;
    v[(axis + 2) % 3] = n[axis];
    const auto first = static_cast<uint32_t>(part.positions.size());
    for (const vec2 corner : {vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, 1)}) {
      part.positions.push_back(n + u * corner.x + v * corner.y);
      part.normals.push_back(n);
      part.tangents.emplace_back(u, 1.0f);
      part.uvs.push_back(corner);
      part.colours.emplace_back(1.0f);
    }
    for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) part.indices.push_back(first + i);
  }
  return part;
}

// A square field of small boxes, one object each.
Scene field_of_boxes(int count) {
  Scene scene;
  scene.name = fmt::format("{} boxes", count);
  scene.materials.emplace_back();
  scene.meshes.push_back({"box", {box_part()}});
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i) {
    const vec3 centre(40.0f * static_cast<float>(i % side) / static_cast<float>(side), 0.0f, 40.0f * static_cast<float>(i / side) / static_cast<float>(side));
    scene.objects.push_back({"box", 0, glm::scale(glm::translate(mat4(1.0f), centre), vec3(0.2f)), true});
  }
  check_scene(scene);
  return scene;
}

// A whole frame of single/hard at a small size, recorded and submitted again and again.
class RecordedFrame {
 public:
  RecordedFrame(Device& device, int objects)
      : scene_(field_of_boxes(objects)), gpu_scene_(device, scene_), frame_(device, gpu_scene_, {64, 64}, 1, std::span(&sun_, 1)), context_(device, frame_) {
    frame_.set_camera(framing_camera(scene_, 1.0f));
    const TechniqueSpec& spec = find_technique("single/hard");
    SettingsMap settings = spec.default_settings();
    settings.at("single").set_number("size", 256, "single.size");
    technique_ = spec.make(context_, settings);
  }
  double record_ms(Recorder& recorder) {
    recorder.begin();
    frame_.record_surface(recorder);
    technique_->record(recorder, frame_, 0);
    frame_.record_shade(recorder);
    return recorder.finish().record_ms;
  }

 private:
  Light sun_ = {.direction = glm::normalize(vec3(-1, -2, -1))};
  Scene scene_;
  GpuScene gpu_scene_;
  Frame frame_;
  TechniqueContext context_;
  std::unique_ptr<Technique> technique_;
};

void cpu_time_per_frame(Device& device) {
  RecordedFrame few(device, 20), many(device, 1000);
  Recorder recorder(device, TimingMode::play, false);
  std::vector<double> few_ms, many_ms;
  for (int i = 0; i < 220; ++i) {
    const double a = few.record_ms(recorder), b = many.record_ms(recorder);
    if (i >= 20) few_ms.push_back(a), many_ms.push_back(b);
  }
  const double a = summarise(few_ms).median, b = summarise(many_ms).median;
  fmt::print("CPU time per frame (record + submit): 20 objects {:.4f} ms, 1000 objects {:.4f} ms, ratio {:.2f} (goal: at most 1.20)\n", a, b, b / a);
}

// A grid of 1140 x 1140 vertices as text: the size of terrain's model.
void write_large_obj(const std::filesystem::path& path) {
  constexpr int k_side = 1140;
  std::ofstream file(path);
  for (int y = 0; y < k_side; ++y) {
    for (int x = 0; x < k_side; ++x) file << fmt::format("v {} {} {}\n", x * 0.01, 0.001 * ((x * y) % 97), y * 0.01);
  }
  for (int y = 0; y + 1 < k_side; ++y) {
    for (int x = 0; x + 1 < k_side; ++x) {
      const int a = y * k_side + x + 1;
      file << fmt::format("f {} {} {} {}\n", a, a + k_side, a + k_side + 1, a + 1);
    }
  }
}

void loading() {
  const auto path = std::filesystem::temp_directory_path() / "gnomon_bench_large.obj";
  write_large_obj(path);
  const double bytes = static_cast<double>(std::filesystem::file_size(path));
  size_t triangles = 0;
  const double time = seconds([&] { triangles = load_scene(path.string()).triangle_count(); });
  std::filesystem::remove(path);
  fmt::print("load OBJ of 1.3 M vertices ({} triangles, {:.0f} MB): {:.2f} s\n", triangles, bytes * 1e-6, time);
}

}  // namespace

int main(int argc, char** argv) {
  Device device;
  fmt::print("{}\n", device.info().name);
  cpu_time_per_frame(device);
  loading();
  for (int i = 1; i < argc; ++i) fmt::print("load {}: {:.2f} s\n", argv[i], seconds([&] { load_scene(argv[i]); }));
  return 0;
}
