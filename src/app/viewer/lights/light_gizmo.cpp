#include "app/viewer/lights/light_gizmo.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/viewer/status_file.h"
#include "lab/view/light_text.h"

namespace gnomon::viewer {
namespace {

constexpr ImU32 k_mark = IM_COL32(255, 220, 120, 255), k_rim = IM_COL32(0, 0, 0, 200), k_hot = IM_COL32(255, 255, 255, 255);
constexpr ImU32 k_faint = IM_COL32(255, 255, 255, 110), k_ground = IM_COL32(20, 24, 32, 150);
constexpr std::array<ImU32, 3> k_axis_colours = {IM_COL32(235, 80, 80, 255), IM_COL32(110, 215, 90, 255),
                                                 IM_COL32(95, 140, 255, 255)};

ImVec2 im(vec2 v) { return {v.x, v.y}; }
vec2 mouse() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }
float unit() { return ImGui::GetFontSize() / 13.0f; }

float distance_to_segment(vec2 point, vec2 a, vec2 b) {
  const vec2 way = b - a;
  const float t = std::clamp(glm::dot(point - a, way) / std::max(glm::dot(way, way), 1e-6f), 0.0f, 1.0f);
  return glm::length(point - a - t * way);
}

void knob(ImDrawList& list, vec2 at, float radius, ImU32 colour) {
  list.AddCircleFilled(im(at), radius + 1.5f * unit(), k_rim);
  list.AddCircleFilled(im(at), radius, colour);
}

}  // namespace

bool LightGizmo::drags(Handle handle, vec2 at, float reach_px) {
  const bool free_mouse = !ImGui::GetIO().WantCaptureMouse && dragged_ == Handle::none;
  if (free_mouse && hovered_ == Handle::none && glm::length(mouse() - at) <= reach_px) hovered_ = handle;
  if (hovered_ == handle && free_mouse && ImGui::IsMouseClicked(0)) dragged_ = handle, grip_px_ = mouse() - at;
  return dragged_ == handle;
}

bool LightGizmo::show(std::vector<ListedLight>& lights, size_t& chosen, const ScreenSpace& screen) {
  hovered_ = Handle::none;
  if (!ImGui::IsMouseDown(0)) dragged_ = Handle::none;
  bool moved = false;
  if (chosen < lights.size()) {
    ListedLight& listed = lights[chosen];
    moved = listed.light.kind == LightKind::directional ? show_sun(listed.light, screen) : show_lamp(listed, screen);
  }
  draw_marks(lights, chosen, screen);
  return moved;
}

void LightGizmo::draw_marks(const std::vector<ListedLight>& lights, size_t& chosen, const ScreenSpace& screen) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i].light;
    const auto at = light.kind == LightKind::directional || i == chosen ? std::nullopt : screen.to_screen(light.position);
    if (!at) continue;
    const bool hot = !has_mouse() && !ImGui::GetIO().WantCaptureMouse && glm::length(mouse() - *at) < 9.0f * unit();
    knob(list, *at, 5.0f * unit(), hot ? k_hot : k_mark);
    if (hot) list.AddText({at->x + 10.0f * unit(), at->y - 7.0f * unit()}, k_hot, light.name.c_str());
    if (hot && ImGui::IsMouseClicked(0)) chosen = i;
  }
}

// Seen from below: the zenith in the middle, the horizon as the rim, up is where the camera looks.
bool LightGizmo::show_sun(Light& sun, const ScreenSpace& screen) {
  const float radius = 52.0f * unit();
  const vec2 centre = screen.size() - vec2(radius + 22.0f * unit());
  const CameraData& camera = screen.camera();
  const float heading = std::atan2(camera.forward_ws.x, -camera.forward_ws.z);
  const glm::dvec3 to_sun = -glm::dvec3(sun.direction);
  const auto azimuth = static_cast<float>(std::atan2(to_sun.x, -to_sun.z));
  const auto elevation = static_cast<float>(std::atan2(to_sun.y, std::hypot(to_sun.x, to_sun.z)));
  const auto place = [&](float azimuth_rad, float elevation_rad) {
    const float turn = azimuth_rad - heading, arm = radius * (1.0f - elevation_rad / (0.5f * k_pi));
    return centre + arm * vec2(std::sin(turn), -std::cos(turn));
  };

  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddCircleFilled(im(centre), radius, k_ground, 48);
  list.AddCircle(im(centre), radius, k_faint, 48, 1.5f * unit());
  for (const float ring : {k_pi / 6.0f, k_pi / 3.0f})
    list.AddCircle(im(centre), glm::length(place(0.0f, ring) - centre), IM_COL32(255, 255, 255, 45), 48);
  const char* const names[] = {"-Z", "+X", "+Z", "-X"};
  for (int i = 0; i < 4; ++i) {
    const vec2 at = place(0.5f * k_pi * static_cast<float>(i), -0.12f * k_pi);
    const ImVec2 size = ImGui::CalcTextSize(names[i]);
    list.AddText({at.x - 0.5f * size.x, at.y - 0.5f * size.y}, k_faint, names[i]);
  }
  list.AddLine(im(centre), im(centre - vec2(0, 0.25f * radius)), k_faint);  // the camera's way
  const vec2 at = place(azimuth, std::max(elevation, 0.0f));
  note_point("sun_handle", at);
  const bool dragged = drags(Handle::sky, at, 11.0f * unit());
  list.AddLine(im(centre), im(at), IM_COL32(255, 220, 120, 120), 1.5f * unit());
  knob(list, at, 7.0f * unit(), dragged || hovered_ == Handle::sky ? k_hot : (elevation < 0.0f ? k_faint : k_mark));
  if (!dragged ||
      ImGui::GetIO().MouseDelta.x * ImGui::GetIO().MouseDelta.x + ImGui::GetIO().MouseDelta.y * ImGui::GetIO().MouseDelta.y ==
          0.0f)
    return false;

  const vec2 arm = mouse() - grip_px_ - centre;
  const float length = glm::length(arm);
  const float new_azimuth = length < 0.5f ? azimuth : std::atan2(arm.x, -arm.y) + heading;
  // On the rim the sun stands half a degree high: shadows without end are of no use.
  const float new_elevation = std::clamp(90.0f * (1.0f - length / radius), 0.5f, 90.0f);
  sun.direction = sun_direction(std::remainder(new_azimuth * 180.0f / k_pi, 360.0f), new_elevation);
  return true;
}

bool LightGizmo::show_lamp(ListedLight& listed, const ScreenSpace& screen) {
  Light& light = listed.light;
  const vec3 target = listed.target();
  const bool aims = light.kind != LightKind::point;
  const auto place = screen.to_screen(light.position), aim = aims ? screen.to_screen(target) : std::nullopt;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const WorldRay ray = screen.ray_at(mouse() - grip_px_);
  std::optional<vec3> new_place, new_target;

  if (place) note_point("lamp_handle", *place);
  if (aim) note_point("aim_handle", *aim);
  // Handles that lie on top are asked first.
  if (place && drags(Handle::place, *place, 9.0f * unit()))
    new_place = on_plane(light.position, screen.camera().forward_ws, ray);
  if (aim && drags(Handle::target, *aim, 9.0f * unit())) new_target = on_plane(target, screen.camera().forward_ws, ray);
  if (place && aim) list.AddLine(im(*place), im(*aim), IM_COL32(255, 220, 120, 150), 1.5f * unit());
  for (int i = 0; place && i < 3; ++i) {
    vec3 axis(0.0f);
    axis[i] = 1.0f;
    const auto tip = screen.to_screen(light.position + screen.metres(light.position, 70.0f * unit()) * axis);
    if (!tip || glm::length(*tip - *place) < 8.0f * unit()) continue;  // it points at the viewer
    note_point(std::array{"arrow_x", "arrow_y", "arrow_z"}[static_cast<size_t>(i)], *tip);
    const Handle handle = std::array{Handle::x, Handle::y, Handle::z}[static_cast<size_t>(i)];
    // The whole arrow is its handle: what is nearest to the mouse on it.
    const bool near = distance_to_segment(mouse(), *place, *tip) < 6.0f * unit();
    const bool dragged = drags(handle, near ? mouse() : *tip, 8.0f * unit());
    if (dragged && ImGui::IsMouseClicked(0)) grip_px_ = mouse() - *place;
    if (dragged) new_place = nearest_on_line(light.position, axis, screen.ray_at(mouse() - grip_px_));
    const ImU32 colour = dragged || hovered_ == handle ? k_hot : k_axis_colours[static_cast<size_t>(i)];
    list.AddLine(im(*place), im(*tip), k_rim, 5.0f * unit());
    list.AddLine(im(*place), im(*tip), colour, 3.0f * unit());
    const vec2 along = glm::normalize(*tip - *place), side(-along.y, along.x);
    list.AddTriangleFilled(im(*tip + 9.0f * unit() * along), im(*tip + 5.0f * unit() * side), im(*tip - 5.0f * unit() * side),
                           colour);
  }
  if (aim)
    knob(list, *aim, 5.0f * unit(),
         dragged_ == Handle::target || hovered_ == Handle::target ? k_hot : IM_COL32(255, 150, 70, 255));
  if (place) knob(list, *place, 7.0f * unit(), dragged_ == Handle::place || hovered_ == Handle::place ? k_hot : k_mark);

  const bool still = ImGui::GetIO().MouseDelta.x == 0.0f && ImGui::GetIO().MouseDelta.y == 0.0f;
  if (still || (!new_place && !new_target)) return false;
  // A lamp that is moved goes on pointing at its target.
  if (new_place && (!aims || glm::length(*new_place - target) > 1e-4f)) light.position = *new_place;
  if (aims) listed.aim_at(new_target.value_or(target));
  return true;
}

}  // namespace gnomon::viewer
