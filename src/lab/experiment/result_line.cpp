// Provenance of a result.
#include "lab/experiment/result_line.h"

#include <cmath>

#include <fmt/format.h>

#include "base/shell.h"
#include "base/version.h"

namespace gnomon {
namespace {

nlohmann::json to_json(const vec3& v) { return {v.x, v.y, v.z}; }
// To a millionth of a degree: the digits beyond are the float's.
double degrees(float radians) { return std::round(static_cast<double>(radians) * 180.0e6 / 3.14159265358979) * 1e-6; }

nlohmann::json describe_light(const Light& light) {
  nlohmann::json json = {{"name", light.name}, {"kind", light_kind_name(light.kind)}, {"intensity", light.intensity}};
  if (light.kind != LightKind::point) json["direction"] = to_json(light.direction);
  if (light.kind != LightKind::directional) json["position"] = to_json(light.position);
  if (light.parallel()) {
    json["angular_diameter_deg"] = degrees(light.angular_diameter);
  } else {
    json["radius_m"] = light.radius;
    json["range_m"] = light.range;
  }
  if (light.kind == LightKind::projector) json["beam_radius_m"] = light.beam_radius;
  if (light.kind == LightKind::spot) json["outer_cone_deg"] = degrees(light.outer_cone);
  return json;
}

}  // namespace

nlohmann::json describe_session(Session& session) {
  const Scene& scene = session.scene();
  const CameraData& camera = session.frame().camera();
  const DeviceInfo& device = session.device().info();
  nlohmann::json line;
  line["gnomon"] = {{"version", version()}, {"commit", commit()}, {"build", build_type()}};
  line["scene"] = {{"name", scene.name},
                   {"source", scene.source},
                   {"hash", scene.content_hash()},
                   {"triangles", scene.triangle_count()},
                   {"objects", scene.objects.size()},
                   {"casts", session.options().casts}};
  line["camera"] = {{"name", session.camera().name},
                    {"eye", to_json(camera.eye_ws)},
                    {"forward", to_json(camera.forward_ws)},
                    {"orthographic", camera.orthographic != 0},
                    {"vertical_fov_deg", degrees(session.camera().vertical_fov)}};
  line["lights"] = nlohmann::json::array();
  for (const Light& light : session.frame().lights()) line["lights"].push_back(describe_light(light));
  line["size"] = {session.frame().size().x, session.frame().size().y};
  line["samples"] = session.frame().samples();
  line["device"] = {
      {"name", device.name}, {"type", device.type}, {"driver", device.driver}, {"driver_version", device.driver_version}};
  return line;
}

nlohmann::json describe_reference(const ReferenceSet& set, const LightReference& reference) {
  nlohmann::json json;
  json["hard"] = {{"kind", set.kind}, {"samples", 1}, {"confidence", reference.hard.confidence}};
  if (reference.area) json["area"] = {{"kind", set.kind}, {"samples", set.samples}, {"confidence", reference.area->confidence}};
  if (reference.pixel) {
    json["pixel"] = {{"kind", set.kind},
                     {"samples", set.pixel_samples},
                     {"rays", reference.area ? set.rays_per_pixel_sample : 1},
                     {"confidence", reference.pixel->result.confidence},
                     {"uncovered", reference.pixel->uncovered}};
  }
  return json;
}

std::string repeat_command(const Session& session, const std::string& technique, const std::string& light) {
  const ViewOptions& view = session.options();
  std::string command = "gnomon compare " + shell_quoted(view.scene) + " --techniques " + technique;
  command += fmt::format(" --size {}x{}", view.size.x, view.size.y);
  if (view.samples != 1) command += fmt::format(" --samples {}", view.samples);
  if (!view.camera.empty()) command += " --camera " + shell_quoted(view.camera);
  if (!light.empty()) command += " --light " + shell_quoted(light);
  for (const std::string& cast : view.casts) command += " --cast " + shell_quoted(cast);
  for (const std::string& assignment : session.settings().assignments_for(find_technique(technique))) {
    command += " --set " + shell_quoted(assignment);
  }
  return command + " -o out";
}

}  // namespace gnomon
