// A scene as the CPU holds it: what loaders and built-in generators produce, and what upload, the CPU reference and the content
// hash read. World space: metres, right-handed, +Y up. Triangles wind counter-clockwise seen from the front in object space;
// an object whose transform mirrors keeps its front (drawing and rays see to that, frame/gpu_scene.h).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/maths.h"

namespace gnomon {

// A picture that materials refer to. Wrap mode is per texture, as in glTF's samplers.
enum class Wrap : uint32_t { repeat, clamp, mirror };
struct Texture {
  std::string name;
  Image8 image;
  bool srgb = true;  // colour; false for normal maps
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
};

// KHR_texture_transform: uv' = offset + rotation * (scale * uv), radians counter-clockwise. The rows of a 2x3 matrix.
struct UvTransform {
  vec3 row_u = vec3(1, 0, 0), row_v = vec3(0, 1, 0);
  static UvTransform from(vec2 offset, float rotation, vec2 scale);
  vec2 apply(vec2 uv) const { return {row_u.x * uv.x + row_u.y * uv.y + row_u.z, row_v.x * uv.x + row_v.y * uv.y + row_v.z}; }
};

inline constexpr int k_no_texture = -1;

// What is said of the shadow of a name (scene/casting.h): the number of the last rule that fits it, and its answer.
struct NamedCast {
  int rule = -1;  // none
  bool on = true;
};

// Alpha-tested (masked) materials: a point exists where base alpha * texture alpha >= alpha_cutoff.
struct Material {
  std::string name;
  vec4 base_colour = vec4(1.0f);           // linear
  int base_colour_texture = k_no_texture;  // RGB colour, A coverage
  int normal_texture = k_no_texture;       // tangent space, +Y up (OpenGL convention)
  float normal_scale = 1.0f;
  UvTransform base_colour_uv, normal_uv;
  bool masked = false;
  float alpha_cutoff = 0.5f;
  bool blended = false;  // lets light through (scene/blended.h); the camera sees it as solid as if it did not
  bool casts = true;
  // A shadow only where base alpha * texture alpha >= 0.5, whatever the camera sees; of half_texture, where there is one,
  // instead of base_colour_texture (same coordinates, size and wrap modes).
  bool half_casts = false;
  int half_texture = k_no_texture;
  NamedCast named_cast;  // of one that is on: whatever the camera sees casts
  bool double_sided = false;
  vec3 specular = vec3(0.0f);  // Blinn-Phong colour and exponent
  float shininess = 32.0f;
  vec3 emissive = vec3(0.0f);

  // Least alpha that the camera sees, and that casts; below 0: whatever the alpha.
  float seen_cutoff() const { return masked ? alpha_cutoff : -1.0f; }
  float caster_cutoff() const { return casts_by_half() ? 0.5f : seen_cutoff(); }
  // Whose alpha that is.
  int caster_texture() const { return casts_by_half() && half_texture != k_no_texture ? half_texture : base_colour_texture; }

 private:
  bool casts_by_half() const { return half_casts && !(named_cast.rule >= 0 && named_cast.on); }
};

// Triangles of one material. Every vector has one entry per vertex, except `indices` (three per triangle); loaders fill all
// of them (scene/mesh_tools.h makes what a file leaves out).
struct MeshPart {
  std::vector<vec3> positions;
  std::vector<vec3> normals;   // unit
  std::vector<vec4> tangents;  // unit xyz, w = handedness (+1 or -1), as in glTF
  std::vector<vec2> uvs;       // v runs downward, as in glTF and Vulkan
  std::vector<vec4> colours;   // linear; white where the file has none
  std::vector<uint32_t> indices;
  int material = 0;

  size_t triangle_count() const { return indices.size() / 3; }
};

struct Mesh {
  std::string name;
  std::vector<MeshPart> parts;
  Box bounds() const;
};

// One placed mesh: what culling, the object id and the caster flag refer to.
struct Object {
  std::string name;
  int mesh = 0;
  mat4 world_from_object = mat4(1.0f);
  bool casts = true;
  NamedCast named_cast;
};

inline bool material_casts(const Material& material) {
  return material.named_cast.rule < 0 ? material.casts : material.named_cast.on;
}

// Whether the parts of an object that have that material cast shadows. What the user named outranks what the scene says.
inline bool part_casts(const Object& object, const Material& material) {
  const NamedCast& last = object.named_cast.rule > material.named_cast.rule ? object.named_cast : material.named_cast;
  return last.rule < 0 ? object.casts && material.casts : last.on;
}

// In the order of base/glsl/light_sampling.glsl. A projector is a parallel beam inside a cylinder, dark outside.
enum class LightKind : uint32_t { directional, point, spot, projector };
struct Light {
  std::string name;
  LightKind kind = LightKind::directional;
  vec3 position = vec3(0.0f);       // all but directional; of a projector the centre of its aperture
  vec3 direction = vec3(0, -1, 0);  // unit, the way the light travels; all but point
  vec3 colour = vec3(1.0f);         // linear
  float intensity = 1.0f;           // lux for directional and projector, candela for point and spot, as in KHR_lights_punctual
  float angular_diameter = 0.0f;    // radians; a disc-shaped sun; directional and projector
  float radius = 0.0f;              // metres; of the emitting sphere of point and spot lights
  float range = 0.0f;               // metres; 0 = unlimited
  float inner_cone = 0.0f, outer_cone = k_pi / 4.0f;  // half angles, radians; spot
  float beam_radius = 1.0f;                           // metres; projector

  bool parallel() const { return kind == LightKind::directional || kind == LightKind::projector; }
  bool has_size() const { return (parallel() ? angular_diameter : radius) > 0.0f; }
};

struct Camera {
  std::string name;
  mat4 world_from_view = mat4(1.0f);  // looks along its own -Z, +Y up
  bool orthographic = false;
  float vertical_fov = k_pi / 3.0f;  // radians; perspective
  float half_height = 1.0f;          // metres; orthographic
  float near = 0.1f;
  float far = 1000.0f;  // the perspective projection is infinite; techniques that slice the view use this
};

// Where a viewer stands and looks over time (scene/path.h). Key times rise from 0.
struct CameraKey {
  double time_s = 0.0;
  vec3 eye = vec3(0.0f), target = vec3(0, 0, -1);
};
struct CameraPath {
  std::string name;
  std::vector<CameraKey> keys;  // at least one
};

// A day of the sun (scene/path.h): where it stands follows from latitude and declination, colour and intensity from the air
// that its light crosses. Angles in radians; hours of solar time, 12 at noon.
struct SunPath {
  std::string name;
  double latitude = 0.785, declination = 0.30;
  double turn = 0.0;  // of north about +Y, from -Z
  double first_hour = 6.0, last_hour = 18.0;
  double duration_s = 60.0;  // of this day as it is shown
  vec3 colour = vec3(1.0f);  // at colour_hour, as is the intensity
  float intensity = 3.0f;    // lux
  double colour_hour = 12.0;
};

// The exact fraction of a light that reaches a point of a chart's receiver, in [0, 1]; nullopt where no closed form is known
// (points of the caster itself). `point_ws` is in double precision so that the answer is exact at an edge.
using ClosedFormVisibility = std::function<std::optional<double>(const glm::dvec3& point_ws, const Light& light)>;

struct Scene {
  std::string name;    // built-in name, or the file's name without folder
  std::string source;  // path, or empty for a built-in scene
  std::vector<Texture> textures;
  std::vector<Material> materials;  // at least one
  std::vector<Mesh> meshes;
  std::vector<Object> objects;
  std::vector<Light> lights;             // may be empty: the sun is then that of the `light` settings
  std::vector<Camera> cameras;           // may be empty: the camera then frames the scene
  std::vector<CameraPath> camera_paths;  // no content: they place cameras, and a picture's camera is recorded with it
  std::vector<SunPath> sun_paths;
  ClosedFormVisibility closed_form;  // test charts only

  // By what messages name it: its file, or its own name.
  const std::string& file_or_name() const { return source.empty() ? name : source; }
  Box bounds() const;             // world space
  size_t triangle_count() const;  // as drawn: instances counted
  // Of everything that can change a picture: geometry, materials, textures, transforms, lights, cameras. 16 hex digits.
  std::string content_hash() const;
};

// Throws Error where an invariant of the structs above does not hold (index ranges, sizes, finite numbers), naming the place:
// what every loader and generator must pass.
void check_scene(const Scene& scene);

// The camera that shows the whole scene from above at an angle, for scenes that bring none. aspect = width / height.
Camera framing_camera(const Scene& scene, float aspect);

}  // namespace gnomon
