// Loading is limited by the disk and the parser, not by what follows: seconds for a large model as text, and for the files
// named on the command line. Times of frames are suites (gnomon bench).
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>

#include "scene/load.h"

namespace {

using namespace gnomon;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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

void large_obj() {
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
  large_obj();
  for (int i = 1; i < argc; ++i) fmt::print("load {}: {:.2f} s\n", argv[i], seconds([&] { load_scene(argv[i]); }));
  return 0;
}
