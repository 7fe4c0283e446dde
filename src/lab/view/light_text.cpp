// Parsing and writing of lights.
#include "lab/view/light_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/error.h"

namespace gnomon {
namespace {

float radians(float degree) { return degree * k_pi / 180.0f; }

std::optional<float> parse_number(std::string_view text) {
  float value = 0.0f;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  for (size_t at = 0;;) {
    const size_t end = text.find(separator, at);
    pieces.push_back(text.substr(at, end == text.npos ? end : end - at));
    if (end == text.npos) return pieces;
    at = end + 1;
  }
}

struct Kind {
  std::string_view name;
  LightKind kind;
  size_t places;  // pieces before the keys
  const char* form;
};
constexpr std::array<Kind, 4> k_kinds = {{{"sun", LightKind::directional, 1, "sun:azimuth,elevation"},
                                          {"point", LightKind::point, 1, "point:x,y,z"},
                                          {"spot", LightKind::spot, 2, "spot:x,y,z:tx,ty,tz"},
                                          {"projector", LightKind::projector, 2, "projector:x,y,z:tx,ty,tz"}}};

// A number that a key sets: in the units of the command line, `scale` takes it to those of Light.
struct Key {
  std::string_view name;
  float Light::*member;
  float min, max, scale;
  const char* unit;
  std::array<bool, 4> of;  // directional, point, spot, projector
};
constexpr float k_degree = k_pi / 180.0f;
constexpr std::array<Key, 7> k_keys = {{
    {"intensity", &Light::intensity, 0.0f, 1e9f, 1.0f, "lux; candela of point and spot", {true, true, true, true}},
    {"angular_diameter", &Light::angular_diameter, 0.0f, 60.0f, k_degree, "degree", {true, false, false, true}},
    {"radius", &Light::radius, 0.0f, 1e4f, 1.0f, "m", {false, true, true, false}},
    {"range", &Light::range, 0.0f, 1e6f, 1.0f, "m; 0: unlimited", {false, true, true, false}},
    {"inner", &Light::inner_cone, 0.0f, 90.0f, k_degree, "degree", {false, false, true, false}},
    {"outer", &Light::outer_cone, 0.1f, 90.0f, k_degree, "degree", {false, false, true, false}},
    {"beam", &Light::beam_radius, 1e-3f, 1e6f, 1.0f, "m", {false, false, false, true}},
}};

std::string valid_keys(LightKind kind) {
  std::string names = "colour, name";
  for (const Key& key : k_keys) {
    if (key.of[static_cast<size_t>(kind)]) names += fmt::format(", {}", key.name);
  }
  return names;
}

void assign(Light& light, std::string_view whole, std::string_view assignment, bool& inner_set) {
  const size_t equals = assignment.find('=');
  if (equals == assignment.npos)
    fail_usage("--light {}: '{}' is not of the form key=value; valid keys: {}", whole, assignment, valid_keys(light.kind));
  const std::string_view name = assignment.substr(0, equals), value = assignment.substr(equals + 1);
  if (name == "name") {
    if (value.empty()) fail_usage("--light {}: name: valid: a word", whole);
    light.name = value;
    return;
  }
  if (name == "colour") {
    const auto colour = parse_vec3(value, '/');
    if (!colour || glm::any(glm::lessThan(*colour, vec3(0.0f))))
      fail_usage("--light {}: colour={}: valid: r/g/b, each 0 or more (linear)", whole, value);
    light.colour = *colour;
    return;
  }
  for (const Key& key : k_keys) {
    if (key.name != name || !key.of[static_cast<size_t>(light.kind)]) continue;
    const auto number = parse_number(value);
    if (!number || *number < key.min || *number > key.max) {
      fail_usage("--light {}: {}={}: valid: {} to {} [{}]", whole, name, value, key.min, key.max, key.unit);
    }
    light.*key.member = *number * key.scale;
    inner_set = inner_set || name == "inner";
    return;
  }
  fail_usage("--light {}: '{}' is no key of this kind; valid: {}", whole, name, valid_keys(light.kind));
}

// Position, direction: what stands before the keys.
void place(Light& light, std::string_view whole, const Kind& kind, const std::vector<std::string_view>& pieces) {
  if (light.kind == LightKind::directional) {
    const auto angles = split(pieces[0], ',');
    const auto azimuth = parse_number(angles[0]), elevation = angles.size() == 2 ? parse_number(angles[1]) : std::nullopt;
    if (!azimuth || !elevation || std::abs(*azimuth) > 360.0f || std::abs(*elevation) > 90.0f) {
      fail_usage("--light {}: valid: {} with azimuth -360 to 360 and elevation -90 to 90 [degree]", whole, kind.form);
    }
    light.direction = sun_direction(*azimuth, *elevation);
    return;
  }
  const auto position = parse_vec3(pieces[0]);
  if (!position) fail_usage("--light {}: '{}' is no point; valid: {} [m]", whole, pieces[0], kind.form);
  light.position = *position;
  if (light.kind == LightKind::point) return;
  const auto target = parse_vec3(pieces[1]);
  if (!target || *target == *position)
    fail_usage("--light {}: '{}' is no point away from the light; valid: {} [m]", whole, pieces[1], kind.form);
  light.direction = glm::normalize(*target - *position);
}

// As few digits as give the same number of Light again.
std::string key_text(const Key& key, float member) {
  const double value = std::clamp(static_cast<double>(member) / static_cast<double>(key.scale), static_cast<double>(key.min),
                                  static_cast<double>(key.max));
  std::string text;
  for (int digits = 6; digits <= 9; ++digits) {
    text = fmt::format("{:.{}g}", value, digits);
    if (*parse_number(text) * key.scale == member) break;
  }
  return text;
}

std::string angles_text(const vec3& direction) {
  const glm::dvec2 angles = sun_angles(direction);
  std::string text;
  for (int digits = 4; digits <= 9; ++digits) {
    const std::string first = fmt::format("{:.{}g}", angles.x, digits), second = fmt::format("{:.{}g}", angles.y, digits);
    text = first + "," + second;
    if (glm::length(sun_direction(*parse_number(first), *parse_number(second)) - direction) < 2e-7f) break;
  }
  return text;
}

std::string point_text(const vec3& point) { return fmt::format("{},{},{}", point.x, point.y, point.z); }

}  // namespace

std::string light_text(const Light& light, float reach_m) {
  GNOMON_ASSERT(light.name.find_first_of(k_not_in_light_names) == light.name.npos);
  const Kind& kind = *std::find_if(k_kinds.begin(), k_kinds.end(), [&](const Kind& other) { return other.kind == light.kind; });
  std::string text = std::string(kind.name) + ":";
  text += light.kind == LightKind::directional ? angles_text(light.direction) : point_text(light.position);
  if (kind.places == 2) {
    // Far from the origin the target must be far away too: positions are coarse there.
    const vec3 far = glm::abs(light.position);
    const float reach = std::max(reach_m, 1e-3f * std::max({far.x, far.y, far.z, 1e-3f}));
    text += ":" + point_text(light.position + reach * light.direction);
  }
  const Light usual = *parse_light(text);
  std::vector<std::string> keys;
  if (!light.name.empty() && light.name != usual.name) keys.push_back("name=" + light.name);
  if (light.colour != usual.colour)
    keys.push_back(fmt::format("colour={}/{}/{}", light.colour.x, light.colour.y, light.colour.z));
  for (const Key& key : k_keys) {
    if (key.of[static_cast<size_t>(light.kind)] && light.*key.member != usual.*key.member) {
      keys.push_back(fmt::format("{}={}", key.name, key_text(key, light.*key.member)));
    }
  }
  return keys.empty() ? text : fmt::format("{}:{}", text, fmt::join(keys, ","));
}

float light_reach(std::string_view text) {
  const auto pieces = split(text, ':');
  const auto position = pieces.size() > 2 ? parse_vec3(pieces[1]) : std::nullopt,
             target = pieces.size() > 2 ? parse_vec3(pieces[2]) : std::nullopt;
  return position && target ? glm::length(*target - *position) : 1.0f;
}

std::optional<vec3> parse_vec3(std::string_view text, char separator) {
  const auto pieces = split(text, separator);
  if (pieces.size() != 3) return std::nullopt;
  vec3 result;
  for (int i = 0; i < 3; ++i) {
    const auto number = parse_number(pieces[static_cast<size_t>(i)]);
    if (!number) return std::nullopt;
    result[i] = *number;
  }
  return result;
}

vec3 sun_direction(float azimuth_degrees, float elevation_degrees) {
  const float azimuth = radians(azimuth_degrees), elevation = radians(elevation_degrees);
  // cos(90 degrees) is not quite zero in floats: an overhead sun stands exactly overhead.
  const float across = std::abs(std::cos(elevation)) < 1e-6f ? 0.0f : std::cos(elevation);
  return -glm::normalize(vec3(across * std::sin(azimuth), std::sin(elevation), -across * std::cos(azimuth)));
}

glm::dvec2 sun_angles(const vec3& direction) {
  const glm::dvec3 to_sun = -glm::dvec3(direction);
  const auto degrees = [](double angle) { return angle * 180.0 / 3.14159265358979323846 + 0.0; };
  return {degrees(std::atan2(to_sun.x, -to_sun.z)), degrees(std::atan2(to_sun.y, std::hypot(to_sun.x, to_sun.z)))};
}

std::optional<Light> parse_light(std::string_view text) {
  for (const Kind& kind : k_kinds) {
    if (!text.starts_with(kind.name) || text.size() <= kind.name.size() || text[kind.name.size()] != ':') continue;
    const auto pieces = split(text.substr(kind.name.size() + 1), ':');
    if (pieces.size() < kind.places || pieces.size() > kind.places + 1)
      fail_usage("--light {}: valid: {}[:key=value,...]", text, kind.form);
    Light light;
    light.name = kind.name;
    light.kind = kind.kind;
    light.intensity = light.parallel() ? 3.0f : 100.0f;
    if (light.kind == LightKind::directional) light.angular_diameter = radians(0.533f);
    place(light, text, kind, pieces);
    bool inner_set = false;
    if (pieces.size() > kind.places) {
      for (const std::string_view assignment : split(pieces.back(), ',')) assign(light, text, assignment, inner_set);
    }
    if (light.inner_cone > light.outer_cone) {
      if (inner_set) fail_usage("--light {}: inner: valid: 0 to outer ({:g} [degree])", text, light.outer_cone / k_degree);
      light.inner_cone = light.outer_cone;
    }
    return light;
  }
  return std::nullopt;
}

}  // namespace gnomon
