// Writes realistic folders of results, as compare, bench and sweep leave them, with pictures and report.html: what the web
// tests look at. Names and reasons that try to break out of HTML are part of them.
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "report/report.h"
#include "sample_pictures.h"

using namespace gnomon;
using namespace gnomon::sample;
using nlohmann::json;

namespace {

using Visibility = std::function<float(const Scene&, const vec3&, const vec3&)>;

struct Technique {
  std::string name;
  Visibility visibility;
  double build_ms, resolve_ms, mebibytes;
  json settings;
};

json errors(const Picture& picture, const Scene& scene, const std::vector<float>& mask, const std::vector<float>& truth) {
  double sum = 0, squares = 0, bias = 0, dark = 0, bright = 0;
  int receivers = 0, dark_count = 0, bright_count = 0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (!picture.is_receiver(i, scene.to_light)) continue;
    const double error = mask[i] - truth[i];
    ++receivers, sum += std::abs(error), squares += error * error, bias += error;
    if (error < -1.0 / 255) ++dark_count, dark -= error;
    if (error > 1.0 / 255) ++bright_count, bright += error;
  }
  const double n = receivers;
  return {{"mae", sum / n},
          {"rmse", std::sqrt(squares / n)},
          {"bias", bias / n},
          {"receivers", receivers},
          {"false_shadow", {{"area", dark_count / n}, {"severity", dark_count ? dark / dark_count : 0.0}}},
          {"false_light", {{"area", bright_count / n}, {"severity", bright_count ? bright / bright_count : 0.0}}}};
}

double psnr(const Image8& a, const Image8& b) {
  double squares = 0;
  for (size_t i = 0; i < a.rgba.size(); ++i) squares += std::pow((a.rgba[i] - b.rgba[i]) / 255.0, 2);
  return squares > 0 ? 10 * std::log10(static_cast<double>(a.rgba.size()) * 0.75 / squares) : 99.0;
}

json pass(const std::string& name, const char* stage, double ms, int draws, int dispatches, int triangles) {
  return {{"name", name},        {"stage", stage}, {"median_ms", ms},          {"p95_ms", ms * 1.12},
          {"mad_ms", ms * 0.02}, {"draws", draws}, {"dispatches", dispatches}, {"triangles", triangles}};
}

json common(const Scene& scene, const std::string& technique) {
  return {
      {"gnomon", {{"version", "0.1.0"}, {"commit", "1a2b3c4"}, {"build", "release"}}},
      {"command", "gnomon compare " + scene.name + " --techniques '" + technique + "' --size " + std::to_string(scene.width) +
                      "x" + std::to_string(scene.height) + " --set single.size=2048 -o out"},
      {"scene", {{"name", scene.name}, {"source", ""}, {"hash", "0123456789abcdef"}, {"triangles", 12034}, {"objects", 5}}},
      {"camera", {{"name", "default"}, {"eye", {0, 3.2, 9}}, {"forward", {0, -0.27, -0.96}}, {"vertical_fov_deg", 53}}},
      {"lights", {{{"name", "sun"}, {"kind", "directional"}, {"direction", {0.3, -0.8, 0.5}}, {"angular_diameter_deg", 13.7}}}},
      {"size", {scene.width, scene.height}},
      {"samples", 1},
      {"device", {{"name", "llvmpipe (LLVM 15)"}, {"type", "cpu"}, {"driver", "llvmpipe"}, {"driver_version", "Mesa 25.0.7"}}},
      {"technique", technique},
      {"status", "ok"},
      {"reason", ""}};
}

json passes_of(const Technique& t) {
  const std::string head = t.name.substr(0, t.name.find('/'));
  json passes = {pass("surface/cull", "surface", 0.03, 0, 1, 0), pass("surface/draw", "surface", 0.41, 5, 0, 12034)};
  if (t.build_ms > 0) {
    passes.push_back(pass(head + "/depth", "build", 0.8 * t.build_ms, 5, 0, 12034));
    passes.push_back(pass(t.name + "/blur", "build", 0.2 * t.build_ms, 0, 2, 0));
  }
  passes.push_back(pass(t.name + "/resolve", "resolve", t.resolve_ms, 0, 1, 0));
  passes.push_back(pass("shade", "shade", 0.22, 0, 1, 0));
  return passes;
}

std::string stem(const std::string& technique) {
  std::string name;
  for (const char c : technique) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '-';
  return name;
}

json result_of(const Scene& scene, const Picture& picture, const Technique& t, const Image8& truth,
               const std::filesystem::path& out) {
  std::vector<float> mask;
  for (const Hit& hit : picture.hits) {
    const bool faces = hit.found && glm::dot(hit.normal, scene.to_light) > 0;
    mask.push_back(faces ? t.visibility(scene, hit.position + 1e-3f * hit.normal, hit.normal) : 0.0f);
  }
  json line = common(scene, t.name);
  const std::string prefix = "images/" + scene.name + "." + stem(t.name) + ".", shared = "images/" + scene.name + ".reference.";
  const auto save = [&](const std::string& name, const Image8& image) {
    write_png(out / name, image);
    return name;
  };
  const Image8 picture_shaded = shaded(picture, scene, mask);
  line["settings"] = t.settings;
  line["visibility"] = {{"hard", errors(picture, scene, mask, picture.hard)},
                        {"area", errors(picture, scene, mask, picture.area)}};
  line["artefacts"] = {{"acne", 0.0012}, {"light_leak", nullptr}};
  line["image"] = {{"rmse", 0.01}, {"psnr", psnr(picture_shaded, truth)}};
  line["passes"] = passes_of(t);
  double total = 0;
  for (const json& p : line["passes"]) total += p["median_ms"].get<double>();
  line["timing"] = {
      {"mode", "measure"},        {"frames", 50}, {"warm_up", 5}, {"clock", "wall clock per pass"}, {"frame_ms", total * 1.017},
      {"sum_of_passes_ms", total}};
  line["gpu_ms"] = {{"build", t.build_ms}, {"resolve", t.resolve_ms}, {"total", t.build_ms + t.resolve_ms}};
  line["memory_bytes"] = static_cast<int64_t>(t.mebibytes * (1 << 20));
  line["reference"] = {{"hard", {{"kind", "embree"}, {"samples", 1}, {"confidence", 0.0}}},
                       {"area", {{"kind", "embree"}, {"samples", 64}, {"confidence", 0.0004}}}};
  line["images"] = {{"shaded", save(prefix + "shaded.png", picture_shaded)},
                    {"mask", save(prefix + "mask.png", grey(picture, mask))},
                    {"error",
                     {{"hard", save(prefix + "error.hard.png", error_map(picture, scene, mask, picture.hard))},
                      {"area", save(prefix + "error.area.png", error_map(picture, scene, mask, picture.area))}}},
                    {"reference", {{"hard", shared + "hard.png"}, {"area", shared + "area.png"}}},
                    {"reference_shaded", shared + "shaded.png"}};
  return line;
}

std::vector<Technique> techniques() {
  const auto map = [](float texel, float bias) {
    return [=](const Scene& s, const vec3& p, const vec3& n) { return lit_map(s, p, n, texel, bias, 0, 0); };
  };
  const auto pcf = [](float texel) {
    return [=](const Scene& s, const vec3& p, const vec3& n) { return lit_pcf(s, p, n, texel); };
  };
  const auto leaky = [](const Scene& s, const vec3& p, const vec3& n) {
    const float v = lit_pcf(s, p, n, 0.14f);
    return v * v * (3 - 2 * v) * 0.92f + 0.08f * lit_pcf(s, p, n, 0.4f);
  };
  const auto settings = [](int size, int kernel) {
    return json{{"single", {{"size", size}, {"slope_bias", 1.5}}},
                {"pcf", {{"kernel", kernel}}},
                {"light", {{"cast", true}}},
                {"camera", json::object()},
                {"reference", {{"samples", 64}}},
                {"measure", {{"frames", 50}}}};
  };
  return {
      // First, and exact: its pictures are byte for byte those of the reference.
      {"ray_traced", [](const Scene& s, const vec3& p, const vec3&) { return lit(s, p, s.to_light); }, 0, 3.84, 2.3,
       settings(1024, 1)},
      {"single/hard", map(0.16f, 0.1f), 0.31, 0.06, 4, settings(1024, 1)},
      {"single/pcf", pcf(0.16f), 0.33, 0.17, 4, settings(1024, 5)},
      {"single/pcf", pcf(0.08f), 0.58, 0.19, 16, settings(2048, 5)},
      {"single/vsm", leaky, 0.71, 0.09, 24, settings(1024, 5)},
      {"cascaded/hard", map(0.05f, 0.03f), 0.92, 0.11, 64, settings(2048, 1)},
      {"ray_traced/area", [](const Scene& s, const vec3& p, const vec3&) { return lit_area(s, p); }, 0.05, 88.2, 2.3,
       settings(1024, 1)},
  };
}

constexpr const char* k_hostile = "</script><img src=x onerror=\"window.hostile=1\"><b>{{data}}&amp;";

std::string scene_lines(const Scene& scene, const std::filesystem::path& out) {
  const Picture picture = reference(scene);
  const Image8 truth = shaded(picture, scene, picture.hard);
  write_png(out / ("images/" + scene.name + ".reference.hard.png"), grey(picture, picture.hard));
  write_png(out / ("images/" + scene.name + ".reference.area.png"), grey(picture, picture.area));
  write_png(out / ("images/" + scene.name + ".reference.shaded.png"), truth);
  std::string lines;
  for (const Technique& t : techniques()) lines += result_of(scene, picture, t, truth, out).dump() + "\n";

  json refused = common(scene, "paraboloid/sat_vsm");
  refused["status"] = "unavailable";
  refused["reason"] = "a paraboloid's map has no summed-area table: its texels do not tile the plane";
  lines += refused.dump() + "\n";

  json hostile = common(scene, std::string("evil/") + k_hostile);  // timed only, as by bench
  hostile["gpu_ms"] = {{"build", 12.5}, {"resolve", 1.25}, {"total", 13.75}};
  hostile["settings"] = {{"<i>", {{"x\"y", k_hostile}}}};
  hostile["visibility"] = {{"hard", {{"mae", nullptr}}}};
  lines += hostile.dump() + "\n";

  json errors_only = common(scene, "volumes");  // compared, not timed
  errors_only["visibility"]["hard"] = errors(picture, scene, picture.hard, picture.hard);
  lines += errors_only.dump() + "\n";
  return lines;
}

// As `bench` writes them: times, no errors, no pictures.
std::string bench_lines(const Scene& scene) {
  std::string lines;
  for (const Technique& t : techniques()) {
    json line = common(scene, t.name);
    line["settings"] = t.settings;
    line["passes"] = passes_of(t);
    line["gpu_ms"] = {{"build", t.build_ms}, {"resolve", t.resolve_ms}, {"total", t.build_ms + t.resolve_ms}};
    lines += line.dump() + "\n";
  }
  return lines;
}

// As `sweep` writes them: many settings of few techniques, no pictures.
std::string sweep_lines(const Scene& scene) {
  std::string lines;
  for (const char* name : {"single/pcf", "single/vsm", "cascaded/evsm", "cascaded/pcf"}) {
    for (int i = 0; i < 16; ++i) {
      const int size = 256 << (i / 4), kernel = 1 + 2 * (i % 4);
      const double build = 0.02 * size / 64.0 + 0.01 * kernel, resolve = 0.02 * kernel * kernel;
      const double mae =
          0.3 / std::sqrt(size) / (1 + 0.1 * kernel) * (name[0] == 'c' ? 0.6 : 1.0) + (name[7] == 'v' ? 0.004 : 0.0);
      json line = common(scene, name);
      line["settings"] = {{"single", {{"size", size}}}, {"filter", {{"kernel", kernel}}}};
      line["visibility"]["hard"] = {
          {"mae", mae}, {"rmse", 2.4 * mae}, {"false_shadow", {{"area", 1.3 * mae}, {"severity", 0.4}}}};
      line["gpu_ms"] = {{"build", build}, {"resolve", resolve}, {"total", build + resolve}};
      line["passes"] = {pass("map/depth", "build", build, 5, 0, 12034), pass("map/resolve", "resolve", resolve, 0, 1, 0)};
      lines += line.dump() + "\n";
    }
  }
  return lines;
}

void write(const std::filesystem::path& folder, const std::string& lines) {
  make_folder(folder);
  write_file(folder / "results.jsonl", lines);
  const std::filesystem::path folders[] = {folder};
  write_report(folders, {});
  write_csv(folders, folder / "results.csv");
  std::fputs(text_table(read_results(folder)).c_str(), stdout);
}

void make(const std::filesystem::path& out) {
  make_folder(out / "compare/images");
  const vec3 sun = glm::normalize(vec3(-0.55f, 0.75f, 0.35f)), evening = glm::normalize(vec3(0.8f, 0.4f, 0.2f));
  const Scene spheres{"spheres", {{{-1.6f, 1, 0}, 1}, {{1.4f, 1.5f, -1.5f}, 0.9f}, {{0.6f, 0.4f, 1.8f}, 0.4f}}, sun, 400, 260};
  const Scene posts{"row_of_posts",
                    {{{-3, 0.5f, -3}, 0.5f}, {{-1, 0.5f, -1.5f}, 0.5f}, {{1, 0.5f, 0}, 0.5f}, {{3, 0.5f, 1.5f}, 0.5f}},
                    evening,
                    320,
                    240};
  write(out / "compare", scene_lines(spheres, out / "compare") + scene_lines(posts, out / "compare"));
  write(out / "bench", bench_lines(spheres));
  write(out / "sweep", sweep_lines(spheres));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: gnomon_make_sample_report FOLDER\n", stderr);
    return 2;
  }
  try {
    make(arguments[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gnomon_make_sample_report: %s\n", error.what());
    return 1;
  }
  return 0;
}
