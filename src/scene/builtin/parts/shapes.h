// Shapes that the built-in scenes are made of. Each function adds triangles to a part, with positions, normals and uvs;
// `finish` adds the rest once a part is complete. `uv_scale` is texture repeats per metre unless said otherwise.
#pragma once

#include <functional>
#include <span>

#include "scene/scene.h"

namespace gnomon {

uint32_t add_vertex(MeshPart& part, const vec3& position, const vec3& normal, const vec2& uv);
void add_triangle(MeshPart& part, uint32_t a, uint32_t b, uint32_t c);

// Flat, counter-clockwise from a: a, b at the bottom, c, d at the top. uv_min belongs to d (top left), uv_max to b.
void add_quad(MeshPart& part, const vec3& a, const vec3& b, const vec3& c, const vec3& d, const vec2& uv_min,
              const vec2& uv_max);

void add_box(MeshPart& part, const vec3& min, const vec3& max, float uv_scale);

// A grid of (columns + 1) x (rows + 1) vertices over the unit square. `at(u, v)` gives the point; triangles face along
// dP/du x dP/dv. Normals come from the neighbours in the grid: `at` must be defined one cell beyond a border that is not
// closed.
struct SurfaceGrid {
  int columns = 1, rows = 1;
  bool closed_u = false, closed_v = false;  // the last row or column coincides with the first, bit for bit
  vec2 uv_repeats = vec2(1.0f);
};
void add_surface(MeshPart& part, const SurfaceGrid& grid, const std::function<glm::dvec3(double u, double v)>& at);

// Poles along Y, vertices on the true sphere, one triangle for each pole segment (none is degenerate).
void add_sphere(MeshPart& part, const vec3& centre, float radius, int columns, int rows, const vec2& uv_repeats);

// Surface of revolution around Y. profile: (radius, height) in the order that keeps the outside on the right, that is upward
// on the outside of a vase. Corners sharper than 40 degrees stay sharp. A radius of 0 closes the shape.
void add_lathe(MeshPart& part, std::span<const vec2> profile, int segments, const vec2& uv_repeats);

// Tube along a path with a radius for each point; both ends are closed with a cone of no height.
void add_tube(MeshPart& part, std::span<const vec3> path, std::span<const float> radii, int sides, float uv_scale);

// Adds `other` moved by a rigid transform (or one with uniform scale).
void append(MeshPart& part, const MeshPart& other, const mat4& transform);

// White colours and tangents: the last call on a part.
void finish(MeshPart& part);

// What every generator does with a scene.
int add_texture(Scene& scene, const std::string& name, Image8 image, bool srgb, Wrap wrap = Wrap::repeat);
int add_material(Scene& scene, Material material);
int add_mesh(Scene& scene, const std::string& name, std::vector<MeshPart> parts);  // finishes the parts
void add_object(Scene& scene, const std::string& name, int mesh, const mat4& world_from_object = mat4(1.0f));
// A part that has the material of that index.
MeshPart part_of(int material);
// A sun of the real angular diameter that shines along `direction` (any length).
Light sun_light(const std::string& name, const vec3& direction, const vec3& colour, float intensity);
Camera look_at(const std::string& name, const vec3& eye, const vec3& target, double vertical_fov_degrees);

}  // namespace gnomon
