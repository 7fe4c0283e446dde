// Shapes and the small steps that every generator shares.
#include "scene/builtin/parts/shapes.h"

#include <cmath>
#include <utility>

#include "base/error.h"
#include "scene/builtin/parts/noise.h"
#include "scene/mesh_tools.h"

namespace gnomon {
namespace {

constexpr double k_two_pi = 6.28318530717958647693;

// Where a full turn ends it must coincide with where it began.
glm::dvec2 spoke(int index, int count) { return unit_circle(k_two_pi * (index % count) / count); }

// Two triangles between rows of `first` and `first + stride`, facing along (next column) x (next row).
void add_cell(MeshPart& part, uint32_t first, uint32_t stride) {
  add_triangle(part, first, first + 1, first + stride + 1);
  add_triangle(part, first, first + stride + 1, first + stride);
}

vec3 flat_normal(const vec3& a, const vec3& b, const vec3& c) { return glm::normalize(glm::cross(b - a, c - a)); }

}  // namespace

uint32_t add_vertex(MeshPart& part, const vec3& position, const vec3& normal, const vec2& uv) {
  part.positions.push_back(position);
  part.normals.push_back(normal);
  part.uvs.push_back(uv);
  return static_cast<uint32_t>(part.positions.size() - 1);
}

void add_triangle(MeshPart& part, uint32_t a, uint32_t b, uint32_t c) { part.indices.insert(part.indices.end(), {a, b, c}); }

void add_quad(MeshPart& part, const vec3& a, const vec3& b, const vec3& c, const vec3& d, const vec2& uv_min,
              const vec2& uv_max) {
  const vec3 normal = flat_normal(a, b, c);
  const uint32_t first = add_vertex(part, a, normal, {uv_min.x, uv_max.y});
  add_vertex(part, b, normal, uv_max);
  add_vertex(part, c, normal, {uv_max.x, uv_min.y});
  add_vertex(part, d, normal, uv_min);
  add_triangle(part, first, first + 1, first + 2);
  add_triangle(part, first, first + 2, first + 3);
}

void add_box(MeshPart& part, const vec3& min, const vec3& max, float uv_scale) {
  const Box box{min, max};
  const auto face = [&](int a, int b, int c, int d) {
    const vec3 pa = box.corner(a), pb = box.corner(b), pd = box.corner(d);
    // Offsets by position, so that neighbouring boxes do not show the same stones.
    const vec2 offset(uv_scale * glm::dot(pa, glm::normalize(pb - pa)), -uv_scale * glm::dot(pd, glm::normalize(pd - pa)));
    add_quad(part, pa, pb, box.corner(c), pd, offset, offset + uv_scale * vec2(glm::length(pb - pa), glm::length(pd - pa)));
  };
  face(4, 5, 7, 6);  // +Z
  face(1, 0, 2, 3);  // -Z
  face(5, 1, 3, 7);  // +X
  face(0, 4, 6, 2);  // -X
  face(6, 7, 3, 2);  // +Y
  face(0, 1, 5, 4);  // -Y
}

void add_surface(MeshPart& part, const SurfaceGrid& grid, const std::function<glm::dvec3(double u, double v)>& at) {
  // One point beyond each border, so that every vertex has neighbours on all sides.
  const int stride = grid.columns + 3;
  const auto parameter = [](int index, int count, bool closed) {
    return double(closed ? (index + count) % count : index) / count;
  };
  std::vector<glm::dvec3> points;
  points.reserve(static_cast<size_t>(stride) * (grid.rows + 3));
  for (int row = -1; row <= grid.rows + 1; ++row) {
    const double v = parameter(row, grid.rows, grid.closed_v);
    for (int column = -1; column <= grid.columns + 1; ++column)
      points.push_back(at(parameter(column, grid.columns, grid.closed_u), v));
  }
  const auto first = static_cast<uint32_t>(part.positions.size());
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column) {
      const glm::dvec3* point = &points[static_cast<size_t>(row + 1) * stride + column + 1];
      const vec2 uv(static_cast<float>(column) / static_cast<float>(grid.columns),
                    static_cast<float>(row) / static_cast<float>(grid.rows));
      const glm::dvec3 normal = glm::cross(point[1] - point[-1], point[stride] - point[-stride]);
      add_vertex(part, vec3(*point), vec3(glm::normalize(normal)), uv * grid.uv_repeats);
    }
  }
  const auto vertices = static_cast<uint32_t>(grid.columns + 1);
  for (uint32_t row = 0; row < static_cast<uint32_t>(grid.rows); ++row) {
    for (uint32_t column = 0; column + 1 < vertices; ++column) add_cell(part, first + row * vertices + column, vertices);
  }
}

void add_sphere(MeshPart& part, const vec3& centre, float radius, int columns, int rows, const vec2& uv_repeats) {
  const auto first = static_cast<uint32_t>(part.positions.size());
  for (int row = 0; row <= rows; ++row) {
    const glm::dvec2 meridian = row == 0      ? glm::dvec2(1, 0)
                                : row == rows ? glm::dvec2(-1, 0)
                                              : unit_circle(0.5 * k_two_pi * row / rows);
    for (int column = 0; column <= columns; ++column) {
      const glm::dvec2 around = spoke(column, columns);
      const glm::dvec3 normal(meridian.y * around.x, meridian.x, -meridian.y * around.y);
      const vec2 uv(static_cast<float>(column) / static_cast<float>(columns),
                    static_cast<float>(row) / static_cast<float>(rows));
      add_vertex(part, vec3(glm::dvec3(centre) + double(radius) * normal), vec3(normal), uv * uv_repeats);
    }
  }
  const auto stride = static_cast<uint32_t>(columns + 1);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const uint32_t top = first + static_cast<uint32_t>(row) * stride + static_cast<uint32_t>(column), bottom = top + stride;
      if (row > 0) add_triangle(part, bottom + 1, top + 1, top);
      if (row < rows - 1) add_triangle(part, top, bottom, bottom + 1);
    }
  }
}

void add_lathe(MeshPart& part, std::span<const vec2> profile, int segments, const vec2& uv_repeats) {
  GNOMON_ASSERT(profile.size() >= 2);
  const size_t pieces = profile.size() - 1;
  std::vector<vec2> outward(pieces);  // normal of each piece in the (radius, height) plane
  std::vector<float> length_to(profile.size(), 0.0f);
  for (size_t i = 0; i < pieces; ++i) {
    const vec2 along = profile[i + 1] - profile[i];
    outward[i] = glm::normalize(vec2(along.y, -along.x));
    length_to[i + 1] = length_to[i] + glm::length(along);
  }
  const auto joined = [&](size_t piece, size_t neighbour) {
    if (neighbour >= pieces || glm::dot(outward[piece], outward[neighbour]) < 0.766f) return outward[piece];
    return glm::normalize(outward[piece] + outward[neighbour]);
  };
  for (size_t i = 0; i < pieces; ++i) {
    const auto first = static_cast<uint32_t>(part.positions.size());
    for (int end = 0; end < 2; ++end) {
      const vec2 at = profile[i + static_cast<size_t>(end)], normal = joined(i, end == 0 ? i - 1 : i + 1);
      const float v = 1.0f - length_to[i + static_cast<size_t>(end)] / length_to.back();
      for (int s = 0; s <= segments; ++s) {
        const vec2 around(spoke(s, segments));
        add_vertex(part, {at.x * around.x, at.y, -at.x * around.y}, {normal.x * around.x, normal.y, -normal.x * around.y},
                   uv_repeats * vec2(static_cast<float>(s) / static_cast<float>(segments), v));
      }
    }
    const auto stride = static_cast<uint32_t>(segments + 1);
    for (uint32_t s = 0; s + 1 < stride; ++s) {
      const uint32_t low = first + s, high = low + stride;
      if (profile[i].x > 0.0f) add_triangle(part, low, low + 1, high + 1);
      if (profile[i + 1].x > 0.0f) add_triangle(part, low, high + 1, high);
    }
  }
}

void add_tube(MeshPart& part, std::span<const vec3> path, std::span<const float> radii, int sides, float uv_scale) {
  GNOMON_ASSERT(path.size() >= 2 && radii.size() == path.size());
  const auto first = static_cast<uint32_t>(part.positions.size());
  const auto stride = static_cast<uint32_t>(sides + 1);
  const auto count = path.size();
  vec3 side = vec3(0.0f);
  float v = 0.0f;
  for (size_t i = 0; i < count; ++i) {
    const vec3 along = glm::normalize(path[i + 1 < count ? i + 1 : i] - path[i > 0 ? i - 1 : i]);
    if (i == 0) {
      vec3 unused;
      orthonormal_basis(along, side, unused);
    } else {
      v += glm::length(path[i] - path[i - 1]) * uv_scale;
    }
    side = glm::normalize(side - along * glm::dot(side, along));  // carried along the path, so that the tube does not twist
    const vec3 other = glm::cross(along, side);
    for (int s = 0; s <= sides; ++s) {
      const vec2 around(spoke(s, sides));
      const vec3 normal = side * around.x + other * around.y;
      add_vertex(part, path[i] + normal * radii[i], normal, {static_cast<float>(s) / static_cast<float>(sides), -v});
    }
  }
  for (uint32_t i = 0; i + 1 < count; ++i) {
    for (uint32_t s = 0; s + 1 < stride; ++s) add_cell(part, first + i * stride + s, stride);
  }
  for (const bool end : {false, true}) {
    const size_t at = end ? count - 1 : 0;
    const vec3 normal = end ? glm::normalize(path[at] - path[at - 1]) : glm::normalize(path[0] - path[1]);
    const uint32_t ring = first + static_cast<uint32_t>(at) * stride, fan = static_cast<uint32_t>(part.positions.size());
    for (uint32_t s = 0; s + 1 < stride; ++s) {
      const vec3 rim = part.positions[ring + s];
      add_vertex(part, rim, normal, uv_scale * vec2(rim.x, rim.z));
    }
    for (uint32_t s = 1; s + 2 < stride; ++s) {
      end ? add_triangle(part, fan, fan + s, fan + s + 1) : add_triangle(part, fan, fan + s + 1, fan + s);
    }
  }
}

void append(MeshPart& part, const MeshPart& other, const mat4& transform) {
  const auto first = static_cast<uint32_t>(part.positions.size());
  for (const vec3& position : other.positions) part.positions.push_back(vec3(transform * vec4(position, 1.0f)));
  for (const vec3& normal : other.normals) part.normals.push_back(glm::normalize(mat3(transform) * normal));
  part.uvs.insert(part.uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const uint32_t index : other.indices) part.indices.push_back(first + index);
}

void finish(MeshPart& part) {
  part.colours.assign(part.positions.size(), vec4(1.0f));
  make_tangents(part);
}

int add_texture(Scene& scene, const std::string& name, Image8 image, bool srgb, Wrap wrap) {
  scene.textures.push_back({name, std::move(image), srgb, wrap, wrap});
  return static_cast<int>(scene.textures.size() - 1);
}

int add_material(Scene& scene, Material material) {
  scene.materials.push_back(std::move(material));
  return static_cast<int>(scene.materials.size() - 1);
}

int add_mesh(Scene& scene, const std::string& name, std::vector<MeshPart> parts) {
  for (MeshPart& part : parts) finish(part);
  scene.meshes.push_back({name, std::move(parts)});
  return static_cast<int>(scene.meshes.size() - 1);
}

void add_object(Scene& scene, const std::string& name, int mesh, const mat4& world_from_object) {
  scene.objects.push_back({name, mesh, world_from_object, true});
}

MeshPart part_of(int material) {
  MeshPart part;
  part.material = material;
  return part;
}

Light sun_light(const std::string& name, const vec3& direction, const vec3& colour, float intensity) {
  Light light;
  light.name = name, light.direction = glm::normalize(direction), light.colour = colour, light.intensity = intensity;
  light.angular_diameter = static_cast<float>(radians_of(0.533));
  return light;
}

Camera look_at(const std::string& name, const vec3& eye, const vec3& target, double vertical_fov_degrees) {
  const vec3 back = glm::normalize(eye - target);
  const vec3 right = glm::normalize(glm::cross(vec3(0, 1, 0), back));
  Camera camera;
  camera.name = name;
  camera.world_from_view = mat4(vec4(right, 0), vec4(glm::cross(back, right), 0), vec4(back, 0), vec4(eye, 1));
  camera.vertical_fov = static_cast<float>(radians_of(vertical_fov_degrees));
  return camera;
}

}  // namespace gnomon
