// How a viewer and a sun move: pure functions of time.
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "scene/scene.h"

namespace gnomon {

struct CameraPose {
  vec3 eye, target;
};

// Seconds from 0 to the last key; clamped outside. Passes through every key at its time; the velocity is continuous (a cubic
// Hermite spline whose tangents are those of the parabola through three keys: Catmull-Rom for times that are not even).
CameraPose pose_at(const CameraPath& path, double time_s);
// The lens of `like` at that place.
Camera camera_at(const CameraPath& path, double time_s, const Camera& like);
double duration_s(const CameraPath& path);

// A sun's place, colour and strength at a time of day.
struct SunState {
  vec3 direction;  // unit, the way the light travels
  vec3 colour;     // linear; redder toward the horizon
  float intensity;
};
// Hours are clamped to the path's day.
SunState sun_at(const SunPath& path, double hour);
// The hour at which the sun of the path stands nearest to where `direction` comes from, to some minutes; and how far off that
// is, radians.
struct NearestHour {
  double hour;
  float off;
};
NearestHour nearest_hour(const SunPath& path, const vec3& direction);
// The hour that belongs to a time since the path's start.
double hour_at(const SunPath& path, double time_s);
// A sun as it was recorded. It passes through every key at its time, along a great circle between two of them; clamped outside.
struct SunKey {
  double time_s = 0.0;
  SunState state;
};
struct RecordedSun {
  std::string name;
  std::vector<SunKey> keys;  // at least one; no two neighbours stand opposite each other
};
SunState sun_at_time(const RecordedSun& path, double time_s);

// What moves a sun: a day, or what was recorded.
using SunMotion = std::variant<SunPath, RecordedSun>;
const std::string& name_of(const SunMotion& motion);
double duration_s(const SunMotion& motion);
// `sun` moved to that time; what the motion does not say stays (name, angular diameter).
Light light_at(const SunMotion& motion, double time_s, Light sun);

// A day in which the sun passes through where `sun` stands, as bright and of the same colour there. It is always above the
// horizon: from and to an elevation of three degrees, or that of `sun` where it stands lower.
SunPath day_through(const std::string& name, const Light& sun);

// Key times from the way between the eyes, for an even pace over `duration_s` seconds.
CameraPath camera_path(const std::string& name, double duration_s, std::span<const CameraPose> poses);
// A full turn about the upright axis at one place, beginning as `camera` looks.
CameraPath turn_path(const std::string& name, double duration_s, const Camera& camera, float distance_m);
// Once around `centre`, beginning at `eye`, looking at the centre.
CameraPath orbit_path(const std::string& name, double duration_s, const vec3& eye, const vec3& centre);

// `walk` and `fly` through these places, `turn` at the first camera, and the sun path `day` (20, 30, 20 and 60 seconds).
void add_paths(Scene& scene, std::span<const CameraPose> walk, std::span<const CameraPose> fly);
// What a scene that brings no paths gets: `walk` toward what its first camera looks at and past it, `turn`, `fly` around the
// scene, and the sun path `day` through its first sun, or through a usual one.
void add_default_paths(Scene& scene);

}  // namespace gnomon
