// A house is four walls of bays, each with one opening, under a gable roof whose ridge runs along the street.
#include "scene/builtin/parts/house.h"

#include <algorithm>
#include <array>

#include "scene/builtin/parts/noise.h"

namespace gnomon {
namespace {

constexpr float k_uv = 0.4f;       // texture repeats a metre
constexpr float k_reveal = 0.22f;  // depth of an opening [m]

// An upright plane; `right` is horizontal, and the outside is right x up.
struct Wall {
  vec3 foot, right;
  vec3 at(float x, float y, float out = 0.0f) const {
    return foot + right * x + vec3(0, y, 0) + glm::cross(right, vec3(0, 1, 0)) * out;
  }
};

void add_flat(MeshPart& part, const std::array<vec3, 4>& corners, const vec3& u_axis, const vec3& v_axis) {
  const vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  std::array<uint32_t, 4> index;
  for (size_t i = 0; i < 4; ++i) {
    index[i] = add_vertex(part, corners[i], normal, k_uv * vec2(glm::dot(corners[i], u_axis), -glm::dot(corners[i], v_axis)));
  }
  add_triangle(part, index[0], index[1], index[2]);
  add_triangle(part, index[0], index[2], index[3]);
}

// A box in a wall's coordinates (x along, y up, z outward).
void add_wall_box(MeshPart& part, const Wall& wall, const vec3& min, const vec3& max) {
  MeshPart box;
  add_box(box, min, max, k_uv);
  const vec3 out = glm::cross(wall.right, vec3(0, 1, 0));
  append(part, box, mat4(vec4(wall.right, 0), vec4(0, 1, 0, 0), vec4(out, 0), vec4(wall.foot, 1)));
}

struct Rect {
  float x0, x1, y0, y1;
};

struct Builder {
  MeshPart wall, trim, roof, brick, wood, glass, iron, cloth;
  HouseStyle style;
  Random random;

  Builder(const HouseMaterials& m, const HouseStyle& s)
      : wall(part_of(m.wall)),
        trim(part_of(m.trim)),
        roof(part_of(m.roof)),
        brick(part_of(m.brick)),
        wood(part_of(m.wood)),
        glass(part_of(m.glass)),
        iron(part_of(m.iron)),
        cloth(part_of(m.cloth)),
        style(s),
        random(s.seed) {}

  // Wall around an opening, its reveals, and what fills it. The frame's four trapezoids meet their neighbours at corners
  // only: no vertex lies on another's edge, where rasterisers leave cracks.
  void opening(const Wall& w, const Rect& o, const Rect& i, MeshPart& filling) {
    const std::array<vec2, 4> outer = {{{o.x0, o.y0}, {o.x1, o.y0}, {o.x1, o.y1}, {o.x0, o.y1}}},
                              inner = {{{i.x0, i.y0}, {i.x1, i.y0}, {i.x1, i.y1}, {i.x0, i.y1}}};
    const vec3 up(0, 1, 0), out = glm::cross(w.right, up);
    for (size_t k = 0; k < 4; ++k) {
      const size_t n = (k + 1) % 4;
      add_flat(wall,
               {w.at(outer[k].x, outer[k].y), w.at(outer[n].x, outer[n].y), w.at(inner[n].x, inner[n].y),
                w.at(inner[k].x, inner[k].y)},
               w.right, up);
      const bool level = k % 2 == 0;
      add_flat(wall,
               {w.at(inner[k].x, inner[k].y), w.at(inner[n].x, inner[n].y), w.at(inner[n].x, inner[n].y, -k_reveal),
                w.at(inner[k].x, inner[k].y, -k_reveal)},
               level ? w.right : out, level ? out : up);
    }
    add_flat(
        filling,
        {w.at(i.x0, i.y0, -k_reveal), w.at(i.x1, i.y0, -k_reveal), w.at(i.x1, i.y1, -k_reveal), w.at(i.x0, i.y1, -k_reveal)},
        w.right, up);
  }

  void window(const Wall& w, const Rect& bay, bool front) {
    const float middle = 0.5f * (bay.x0 + bay.x1), half = std::min(0.55f, 0.32f * (bay.x1 - bay.x0));
    const float height = bay.y1 - bay.y0;
    const Rect hole{middle - half, middle + half, bay.y0 + 0.30f * height, bay.y0 + 0.82f * height};
    opening(w, bay, hole, glass);
    if (!style.joinery) return;
    add_wall_box(trim, w, {hole.x0 - 0.12f, hole.y0 - 0.09f, -k_reveal}, {hole.x1 + 0.12f, hole.y0, 0.14f});
    add_wall_box(wood, w, {middle - 0.03f, hole.y0, -k_reveal}, {middle + 0.03f, hole.y1, -k_reveal + 0.05f});
    const float rail = glm::mix(hole.y0, hole.y1, 0.66f);
    add_wall_box(wood, w, {hole.x0, rail - 0.03f, -k_reveal}, {hole.x1, rail + 0.03f, -k_reveal + 0.045f});
    if (!front) return;
    add_wall_box(wood, w, {hole.x0 - half - 0.02f, hole.y0, 0.01f}, {hole.x0 - 0.02f, hole.y1, 0.06f});
    add_wall_box(wood, w, {hole.x1 + 0.02f, hole.y0, 0.01f}, {hole.x1 + half + 0.02f, hole.y1, 0.06f});
  }

  void door(const Wall& w, const Rect& bay) {
    const float middle = 0.5f * (bay.x0 + bay.x1);
    opening(w, bay, {middle - 0.6f, middle + 0.6f, bay.y0 + 0.15f, bay.y0 + 2.4f}, wood);
    add_wall_box(trim, w, {middle - 0.85f, 0.0f, -0.05f}, {middle + 0.85f, 0.15f, 0.45f});
    add_wall_box(trim, w, {middle - 0.95f, bay.y0 + 2.5f, -0.05f}, {middle + 0.95f, bay.y0 + 2.62f, 0.55f});
  }

  void shop_window(const Wall& w, const Rect& bay) {
    opening(w, bay, {bay.x0 + 0.35f, bay.x1 - 0.35f, bay.y0 + 0.5f, bay.y0 + 2.4f}, glass);
    // An awning on two arms.
    const float y0 = bay.y0 + 2.25f, y1 = bay.y0 + 2.75f, reach = 1.3f;
    add_flat(cloth,
             {w.at(bay.x0 + 0.2f, y0, reach), w.at(bay.x1 - 0.2f, y0, reach), w.at(bay.x1 - 0.2f, y1, 0.03f),
              w.at(bay.x0 + 0.2f, y1, 0.03f)},
             w.right, vec3(0, 1, 0));
    add_flat(cloth,
             {w.at(bay.x0 + 0.2f, y0 - 0.22f, reach), w.at(bay.x1 - 0.2f, y0 - 0.22f, reach), w.at(bay.x1 - 0.2f, y0, reach),
              w.at(bay.x0 + 0.2f, y0, reach)},
             w.right, vec3(0, 1, 0));
    for (const float x : {bay.x0 + 0.22f, bay.x1 - 0.26f})
      add_wall_box(iron, w, {x, y0 - 0.03f, 0.0f}, {x + 0.04f, y0 + 0.01f, reach});
  }

  void balcony(const Wall& w, const Rect& bay) {
    const float x0 = bay.x0 + 0.15f, x1 = bay.x1 - 0.15f, y = bay.y0 + 0.05f, reach = 0.95f, high = 1.0f;
    add_wall_box(trim, w, {x0, y - 0.14f, -0.1f}, {x1, y, reach});
    for (const float x : {x0 + 0.15f, x1 - 0.3f}) add_wall_box(trim, w, {x, y - 0.45f, -0.1f}, {x + 0.15f, y - 0.14f, 0.45f});
    add_wall_box(iron, w, {x0, y + high - 0.04f, reach - 0.05f}, {x1, y + high, reach});
    const int bars = static_cast<int>((x1 - x0) / 0.14f), sides = 6;
    for (int i = 0; i <= bars; ++i) {
      const float x = glm::mix(x0 + 0.01f, x1 - 0.03f, static_cast<float>(i) / static_cast<float>(bars));
      add_wall_box(iron, w, {x, y, reach - 0.04f}, {x + 0.02f, y + high - 0.04f, reach - 0.02f});
    }
    for (const float x : {x0, x1 - 0.04f}) {
      add_wall_box(iron, w, {x, y + high - 0.04f, 0.0f}, {x + 0.04f, y + high, reach - 0.05f});
      for (int i = 0; i < sides; ++i) {
        const float z = reach * (static_cast<float>(i) + 0.5f) / static_cast<float>(sides + 1);
        add_wall_box(iron, w, {x + 0.01f, y, z}, {x + 0.03f, y + high - 0.04f, z + 0.02f});
      }
    }
  }

  void wall_of_bays(const Wall& w, float width, int bays, bool front) {
    const float bay_width = width / static_cast<float>(bays);
    for (int floor = 0; floor < style.floors; ++floor) {
      for (int b = 0; b < bays; ++b) {
        const float x = bay_width * static_cast<float>(b), y = style.floor_height * static_cast<float>(floor);
        const Rect bay{x, x + bay_width, y, y + style.floor_height};
        const float chance = random.unit();
        if (front && floor == 0 && b == bays / 2) {
          door(w, bay);
        } else if (front && floor == 0 && style.shop) {
          shop_window(w, bay);
        } else {
          window(w, bay, front);
        }
        if (front && floor > 0 && style.balconies && chance < 0.45f) balcony(w, bay);
      }
    }
  }

  // From the tops of the bays to the ridge.
  void gable(const Wall& w, float width, int bays) {
    const float eaves = style.floor_height * static_cast<float>(style.floors);
    const vec3 apex = w.at(0.5f * width, eaves + style.roof_rise), out = glm::cross(w.right, vec3(0, 1, 0));
    const auto vertex = [&](const vec3& p) { return add_vertex(wall, p, out, k_uv * vec2(glm::dot(p, w.right), -p.y)); };
    for (int b = 0; b < bays; ++b) {
      const float step = width / static_cast<float>(bays), x = step * static_cast<float>(b);
      const uint32_t a = vertex(w.at(x, eaves)), c = vertex(w.at(x + step, eaves)), top = vertex(apex);
      add_triangle(wall, a, c, top);
    }
  }

  // One slope: a slab, and rows of tiles that overlap like real ones. side +1: toward the front.
  void slope(float side) {
    const float over = 0.45f, half = 0.5f * style.width + 0.35f, eaves = style.floor_height * static_cast<float>(style.floors);
    const float run = 0.5f * style.depth, pitch = style.roof_rise / run;
    const vec3 ridge(0, eaves + style.roof_rise + 0.12f, -run),
        low(0, eaves - over * pitch + 0.12f, side > 0 ? over : -style.depth - over);
    const vec3 right(side, 0, 0), thick(0, -0.12f, 0);
    const std::array<vec3, 4> top = {low - right * half, low + right * half, ridge + right * half, ridge - right * half};
    const vec3 rise = glm::normalize(ridge - low);
    add_flat(roof, top, right, rise);
    add_flat(wood, {top[1] + thick, top[0] + thick, top[3] + thick, top[2] + thick}, right, rise);
    add_flat(wood, {top[0] + thick, top[1] + thick, top[1], top[0]}, right, vec3(0, 1, 0));
    add_flat(wood, {top[1] + thick, top[2] + thick, top[2], top[1]}, rise, vec3(0, 1, 0));
    add_flat(wood, {top[3] + thick, top[0] + thick, top[0], top[3]}, rise, vec3(0, 1, 0));
    if (style.tile_rows < 1) return;
    const vec3 out = glm::normalize(glm::cross(right, rise));
    const int rows = style.tile_rows, tiles = std::max(1, style.tile_columns);
    for (int row = 0; row < rows; ++row) {
      const SurfaceGrid grid{tiles * 2, 1, false, false, {static_cast<float>(tiles) * 0.3f, 0.2f}};
      add_surface(roof, grid, [&](double u, double v) {
        const double up = (row + v * 1.12) / rows, wave = 0.5 - 0.5 * cosine(6.283185307179586 * u * tiles);
        const glm::dvec3 across = glm::dvec3(right) * ((2.0 * u - 1.0) * half);
        return glm::dvec3(low) + across + glm::dvec3(ridge - low) * up + glm::dvec3(out) * (0.10 - 0.07 * v + 0.06 * wave);
      });
    }
  }

  void chimney(int index) {
    const float eaves = style.floor_height * static_cast<float>(style.floors), top = eaves + style.roof_rise + 0.9f;
    const float x = style.width * (index == 0 ? random.range(0.15f, 0.4f) : random.range(-0.4f, -0.15f)),
                z = -0.38f * style.depth;
    add_box(brick, {x - 0.4f, eaves, z - 0.3f}, {x + 0.4f, top, z + 0.3f}, 0.8f);
    add_box(trim, {x - 0.47f, top, z - 0.37f}, {x + 0.47f, top + 0.12f, z + 0.37f}, 0.8f);
    for (const float side : {-0.2f, 0.2f}) {
      const std::vector<vec2> pot = {
          {0.15f, top + 0.12f}, {0.11f, top + 0.65f}, {0.08f, top + 0.65f}, {0.08f, top + 0.4f}, {0.0f, top + 0.4f}};
      MeshPart lathe;
      add_lathe(lathe, pot, style.joinery ? 10 : 5, {1, 1});
      append(brick, lathe, translation({x + side, 0, z}));
    }
  }
};

}  // namespace

std::vector<MeshPart> make_house(const HouseMaterials& materials, const HouseStyle& style) {
  Builder b(materials, style);
  const float w = style.width, d = style.depth;
  b.wall_of_bays({{-0.5f * w, 0, 0}, {1, 0, 0}}, w, style.bays, true);
  b.wall_of_bays({{0.5f * w, 0, -d}, {-1, 0, 0}}, w, style.bays, false);
  const Wall east{{0.5f * w, 0, 0}, {0, 0, -1}}, west{{-0.5f * w, 0, -d}, {0, 0, 1}};
  for (const Wall& wall : {east, west}) {
    b.wall_of_bays(wall, d, style.side_bays, false);
    b.gable(wall, d, style.side_bays);
  }
  for (const float side : {1.0f, -1.0f}) b.slope(side);
  if (style.tile_rows > 0) {
    const float ridge = style.floor_height * static_cast<float>(style.floors) + style.roof_rise + 0.17f,
                half = 0.5f * w + 0.36f;
    add_tube(b.roof, std::vector<vec3>{{-half, ridge, -0.5f * d}, {half, ridge, -0.5f * d}}, std::vector<float>{0.15f, 0.15f},
             8, 1.0f);
  }
  for (int i = 0; i < style.chimneys; ++i) b.chimney(i);
  if (style.joinery) {  // a string course below the eaves
    const float eaves = style.floor_height * static_cast<float>(style.floors);
    add_box(b.trim, {-0.5f * w - 0.08f, eaves - 0.35f, -0.1f}, {0.5f * w + 0.08f, eaves - 0.15f, 0.12f}, k_uv);
  }
  std::vector<MeshPart> parts;
  for (MeshPart* part : {&b.wall, &b.trim, &b.roof, &b.brick, &b.wood, &b.glass, &b.iron, &b.cloth}) {
    if (!part->indices.empty()) parts.push_back(std::move(*part));
  }
  return parts;
}

void add_prism(MeshPart& part, const std::vector<vec2>& outline, float z0, float z1, float uv_scale) {
  for (size_t i = 0; i < outline.size(); ++i) {
    const vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    add_quad(part, {a, z1}, {a, z0}, {b, z0}, {b, z1}, {0, 0}, uv_scale * vec2(z1 - z0, glm::length(b - a)));
  }
  for (const bool front : {true, false}) {
    const auto first = static_cast<uint32_t>(part.positions.size());
    for (const vec2& p : outline) add_vertex(part, {p, front ? z1 : z0}, {0, 0, front ? 1 : -1}, uv_scale * vec2(p.x, -p.y));
    for (uint32_t i = 1; i + 1 < outline.size(); ++i) {
      front ? add_triangle(part, first, first + i, first + i + 1) : add_triangle(part, first, first + i + 1, first + i);
    }
  }
}

}  // namespace gnomon
