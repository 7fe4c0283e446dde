// Writes a realistic folder of results (two scenes of spheres on a floor, shadows computed here), its pictures and its
// report.html: what the web tests look at. Names and reasons that try to break out of HTML are part of it.
#include <cmath>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/image.h"
#include "base/maths.h"
#include "report/report.h"

using namespace gnomon;
using nlohmann::json;

namespace {

struct Sphere {
  vec3 centre;
  float radius;
};

struct Scene {
  std::string name;
  std::vector<Sphere> spheres;
  vec3 to_light;
  int width, height;
};

struct Hit {
  vec3 position{}, normal{};
  bool found = false;
};

// Distance to the sphere along the ray, or a negative number.
float intersect(const Sphere& sphere, const vec3& origin, const vec3& direction) {
  const vec3 to_centre = sphere.centre - origin;
  const float along = glm::dot(to_centre, direction);
  const float inside = sphere.radius * sphere.radius - (glm::dot(to_centre, to_centre) - along * along);
  return inside < 0 ? -1.0f : along - std::sqrt(inside);
}

Hit trace(const Scene& scene, const vec3& origin, const vec3& direction) {
  float nearest = direction.y < 0 ? -origin.y / direction.y : 1e30f;
  Hit hit{origin + direction * nearest, vec3(0, 1, 0), direction.y < 0 && nearest < 60.0f};
  for (const Sphere& sphere : scene.spheres) {
    const float distance = intersect(sphere, origin, direction);
    if (distance <= 1e-3f || distance >= nearest) continue;
    nearest = distance;
    const vec3 position = origin + direction * distance;
    hit = {position, glm::normalize(position - sphere.centre), true};
  }
  return hit;
}

float lit(const Scene& scene, const vec3& point, const vec3& to_light) {
  for (const Sphere& sphere : scene.spheres) {
    if (intersect(sphere, point, to_light) > 1e-3f) return 0.0f;
  }
  return 1.0f;
}

// Area light: a disc of directions, by a fixed spiral.
float lit_area(const Scene& scene, const vec3& point) {
  constexpr int k_samples = 64;
  vec3 tangent, bitangent;
  orthonormal_basis(scene.to_light, tangent, bitangent);
  float sum = 0;
  for (int i = 0; i < k_samples; ++i) {
    const float r = 0.12f * std::sqrt((static_cast<float>(i) + 0.5f) / k_samples), a = static_cast<float>(i) * 2.39996f;
    sum += lit(scene, point, glm::normalize(scene.to_light + r * (std::cos(a) * tangent + std::sin(a) * bitangent)));
  }
  return sum / k_samples;
}

// A shadow map of texels `texel` wide: the point moves to its texel's centre in the light's plane, and away by the bias.
float lit_map(const Scene& scene, const vec3& point, const vec3& normal, float texel, float bias, float shift_x, float shift_y) {
  vec3 u, v;
  orthonormal_basis(scene.to_light, u, v);
  const float x = glm::dot(point, u), y = glm::dot(point, v), z = glm::dot(point, scene.to_light);
  const auto snap = [&](float value, float shift) { return (std::floor(value / texel + shift) + 0.5f) * texel; };
  const vec3 moved = snap(x, shift_x) * u + snap(y, shift_y) * v + z * scene.to_light;
  return lit(scene, moved + bias * scene.to_light + 0.2f * texel * normal, scene.to_light);
}

float lit_pcf(const Scene& scene, const vec3& point, const vec3& normal, float texel) {
  float sum = 0;
  for (int i = -2; i <= 2; ++i) {
    for (int k = -2; k <= 2; ++k) sum += lit_map(scene, point + 0.0f, normal, texel, 2 * texel, 0.4f * static_cast<float>(i), 0.4f * static_cast<float>(k));
  }
  return sum / 25;
}

using Visibility = std::function<float(const Scene&, const vec3&, const vec3&)>;

struct Technique {
  std::string name;
  Visibility visibility;
  double build_ms, resolve_ms, mebibytes;
  json settings;
};

struct Picture {
  int width, height;
  std::vector<Hit> hits;
  std::vector<float> hard, area;  // the reference

  bool is_receiver(size_t i, const vec3& to_light) const { return hits[i].found && glm::dot(hits[i].normal, to_light) > 0; }
};

Picture reference(const Scene& scene) {
  Picture picture{scene.width, scene.height, {}, {}, {}};
  const vec3 eye(0, 3.2f, 9);
  const vec3 forward = glm::normalize(vec3(0, 0.6f, 0) - eye), right = glm::normalize(glm::cross(forward, vec3(0, 1, 0)));
  const vec3 up = glm::cross(right, forward);
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const float sx = (static_cast<float>(2 * x + 1 - scene.width)) / static_cast<float>(scene.height);
      const float sy = (static_cast<float>(scene.height - 2 * y - 1)) / static_cast<float>(scene.height);
      const Hit hit = trace(scene, eye, glm::normalize(forward + 0.5f * (sx * right + sy * up)));
      picture.hits.push_back(hit);
      const bool faces = hit.found && glm::dot(hit.normal, scene.to_light) > 0;
      picture.hard.push_back(faces ? lit(scene, hit.position + 1e-3f * hit.normal, scene.to_light) : 0.0f);
      picture.area.push_back(faces ? lit_area(scene, hit.position + 1e-3f * hit.normal) : 0.0f);
    }
  }
  return picture;
}

uint8_t byte_of(float value) { return static_cast<uint8_t>(std::lround(255.0f * glm::clamp(value, 0.0f, 1.0f))); }

Image8 draw(const Picture& picture, const std::function<vec3(size_t)>& colour) {
  Image8 image(picture.width, picture.height);
  for (size_t i = 0; i < picture.hits.size(); ++i) {
    const vec3 c = colour(i);
    uint8_t* out = &image.rgba[4 * i];
    out[0] = byte_of(c.x), out[1] = byte_of(c.y), out[2] = byte_of(c.z), out[3] = 255;
  }
  return image;
}

float diffuse(const Picture& picture, const Scene& scene, size_t i) {
  return std::max(0.0f, glm::dot(picture.hits[i].normal, scene.to_light));
}

Image8 shaded(const Picture& picture, const Scene& scene, const std::vector<float>& mask) {
  return draw(picture, [&](size_t i) {
    if (!picture.hits[i].found) return vec3(0.66f, 0.76f, 0.86f);
    const vec3& p = picture.hits[i].position;
    const bool floor = picture.hits[i].normal.y > 0.999f && p.y < 0.01f;
    const float tile = (static_cast<int>(std::floor(p.x)) + static_cast<int>(std::floor(p.z))) % 2 == 0 ? 0.82f : 0.74f;
    const vec3 albedo = floor ? vec3(tile, tile * 0.97f, tile * 0.9f) : vec3(0.86f, 0.62f, 0.42f);
    return albedo * (0.22f + 0.86f * mask[i] * diffuse(picture, scene, i));
  });
}

Image8 grey(const Picture& picture, const std::vector<float>& mask) {
  return draw(picture, [&](size_t i) { return vec3(mask[i]); });
}

// Red: false shadow; blue: false light; grey: agreement.
Image8 error_map(const Picture& picture, const Scene& scene, const std::vector<float>& mask, const std::vector<float>& truth) {
  return draw(picture, [&](size_t i) {
    const float base = 0.3f + 0.45f * truth[i] * diffuse(picture, scene, i), error = mask[i] - truth[i];
    const vec3 towards = error < 0 ? vec3(0.9f, 0.1f, 0.08f) : vec3(0.1f, 0.35f, 0.95f);
    return glm::mix(vec3(base), towards, std::min(1.0f, std::abs(error) * 1.2f));
  });
}

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
  return {{"mae", sum / n}, {"rmse", std::sqrt(squares / n)}, {"bias", bias / n}, {"receivers", receivers},
          {"false_shadow", {{"area", dark_count / n}, {"severity", dark_count ? dark / dark_count : 0.0}}},
          {"false_light", {{"area", bright_count / n}, {"severity", bright_count ? bright / bright_count : 0.0}}}};
}

double psnr(const Image8& a, const Image8& b) {
  double squares = 0;
  for (size_t i = 0; i < a.rgba.size(); ++i) squares += std::pow((a.rgba[i] - b.rgba[i]) / 255.0, 2);
  return squares > 0 ? 10 * std::log10(static_cast<double>(a.rgba.size()) * 0.75 / squares) : 99.0;
}

json pass(const std::string& name, const char* stage, double ms, int draws, int dispatches, int triangles) {
  return {{"name", name}, {"stage", stage}, {"median_ms", ms}, {"p95_ms", ms * 1.12}, {"mad_ms", ms * 0.02},
          {"draws", draws}, {"dispatches", dispatches}, {"triangles", triangles}};
}

json common(const Scene& scene, const std::string& technique) {
  return {{"gnomon", {{"version", "0.1.0"}, {"commit", "1a2b3c4"}, {"build", "release"}}},
          {"command", "gnomon compare " + scene.name + " --techniques '" + technique + "' --size " + std::to_string(scene.width) + "x" +
                          std::to_string(scene.height) + " --set single.size=2048 -o out"},
          {"scene", {{"name", scene.name}, {"source", ""}, {"hash", "0123456789abcdef"}, {"triangles", 12034}, {"objects", 5}}},
          {"camera", {{"name", "default"}, {"eye", {0, 3.2, 9}}, {"forward", {0, -0.27, -0.96}}, {"vertical_fov_deg", 53}}},
          {"lights", {{{"name", "sun"}, {"kind", "directional"}, {"direction", {0.3, -0.8, 0.5}}, {"angular_diameter_deg", 13.7}}}},
          {"size", {scene.width, scene.height}}, {"samples", 1},
          {"device", {{"name", "llvmpipe (LLVM 15)"}, {"type", "cpu"}, {"driver", "llvmpipe"}, {"driver_version", "Mesa 25.0.7"}}},
          {"technique", technique}, {"status", "ok"}, {"reason", ""}};
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

json result_of(const Scene& scene, const Picture& picture, const Technique& t, const Image8& truth, const std::filesystem::path& out) {
  std::vector<float> mask;
  for (const Hit& hit : picture.hits) {
    const bool faces = hit.found && glm::dot(hit.normal, scene.to_light) > 0;
    mask.push_back(faces ? t.visibility(scene, hit.position + 1e-3f * hit.normal, hit.normal) : 0.0f);
  }
  json line = common(scene, t.name);
  const std::string prefix = "images/" + scene.name + "." + stem(t.name) + ".", shared = "images/" + scene.name + ".reference.";
  const auto write = [&](const std::string& name, const Image8& image) { write_png(out / name, image); return name; };
  const Image8 picture_shaded = shaded(picture, scene, mask);
  line["settings"] = t.settings;
  line["visibility"] = {{"hard", errors(picture, scene, mask, picture.hard)}, {"area", errors(picture, scene, mask, picture.area)}};
  line["artefacts"] = {{"acne", 0.0012}, {"light_leak", nullptr}};
  line["image"] = {{"rmse", 0.01}, {"psnr", psnr(picture_shaded, truth)}};
  line["passes"] = passes_of(t);
  double total = 0;
  for (const json& p : line["passes"]) total += p["median_ms"].get<double>();
  line["timing"] = {{"mode", "measure"}, {"frames", 50}, {"warm_up", 5}, {"clock", "wall clock per pass"}, {"frame_ms", total * 1.017}, {"sum_of_passes_ms", total}};
  line["gpu_ms"] = {{"build", t.build_ms}, {"resolve", t.resolve_ms}, {"total", t.build_ms + t.resolve_ms}};
  line["memory_bytes"] = static_cast<int64_t>(t.mebibytes * (1 << 20));
  line["reference"] = {{"hard", {{"kind", "embree"}, {"samples", 1}, {"confidence", 0.0}}}, {"area", {{"kind", "embree"}, {"samples", 64}, {"confidence", 0.0004}}}};
  line["images"] = {{"shaded", write(prefix + "shaded.png", picture_shaded)}, {"mask", write(prefix + "mask.png", grey(picture, mask))},
                    {"error", {{"hard", write(prefix + "error.hard.png", error_map(picture, scene, mask, picture.hard))},
                               {"area", write(prefix + "error.area.png", error_map(picture, scene, mask, picture.area))}}},
                    {"reference", {{"hard", shared + "hard.png"}, {"area", shared + "area.png"}}}, {"reference_shaded", shared + "shaded.png"}};
  return line;
}

std::vector<Technique> techniques() {
  const auto map = [](float texel, float bias) {
    return [=](const Scene& s, const vec3& p, const vec3& n) { return lit_map(s, p, n, texel, bias, 0, 0); };
  };
  const auto pcf = [](float texel) { return [=](const Scene& s, const vec3& p, const vec3& n) { return lit_pcf(s, p, n, texel); }; };
  const auto leaky = [](const Scene& s, const vec3& p, const vec3& n) {
    const float v = lit_pcf(s, p, n, 0.14f);
    return v * v * (3 - 2 * v) * 0.92f + 0.08f * lit_pcf(s, p, n, 0.4f);
  };
  const auto settings = [](int size, int kernel) {
    return json{{"single", {{"size", size}, {"slope_bias", 1.5}}}, {"pcf", {{"kernel", kernel}}}, {"light", {{"cast", true}}}, {"camera", json::object()},
                {"reference", {{"samples", 64}}}, {"measure", {{"frames", 50}}}};
  };
  return {
      {"single/hard", map(0.16f, 0.1f), 0.31, 0.06, 4, settings(1024, 1)},
      {"single/pcf", pcf(0.16f), 0.33, 0.17, 4, settings(1024, 5)},
      {"single/pcf", pcf(0.08f), 0.58, 0.19, 16, settings(2048, 5)},
      {"single/vsm", leaky, 0.71, 0.09, 24, settings(1024, 5)},
      {"cascaded/hard", map(0.05f, 0.03f), 0.92, 0.11, 64, settings(2048, 1)},
      {"ray_traced", [](const Scene& s, const vec3& p, const vec3&) { return lit(s, p, s.to_light); }, 0, 3.84, 2.3, settings(1024, 1)},
      {"ray_traced/area", [](const Scene& s, const vec3& p, const vec3&) { return lit_area(s, p); }, 0.05, 88.2, 2.3, settings(1024, 1)},
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

void make(const std::filesystem::path& out) {
  make_folder(out / "images");
  const vec3 sun = glm::normalize(vec3(-0.55f, 0.75f, 0.35f));
  const Scene spheres{"spheres", {{{-1.6f, 1, 0}, 1}, {{1.4f, 1.5f, -1.5f}, 0.9f}, {{0.6f, 0.4f, 1.8f}, 0.4f}}, sun, 400, 260};
  const Scene row{"row_of_posts", {{{-3, 0.5f, -3}, 0.5f}, {{-1, 0.5f, -1.5f}, 0.5f}, {{1, 0.5f, 0}, 0.5f}, {{3, 0.5f, 1.5f}, 0.5f}},
                  glm::normalize(vec3(0.8f, 0.4f, 0.2f)), 320, 240};
  write_file(out / "results.jsonl", scene_lines(spheres, out) + scene_lines(row, out));
  const std::filesystem::path folders[] = {out};
  write_report(folders, {});
  write_csv(folders, out / "results.csv");
  std::fputs(text_table(read_results(out)).c_str(), stdout);
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
