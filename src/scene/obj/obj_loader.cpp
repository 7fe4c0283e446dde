// Wavefront OBJ: one object for each o/g group, in it one part for each material.
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <unordered_map>

#include "base/error.h"
#include "base/file.h"
#include "base/log.h"
#include "scene/finish_file_scene.h"
#include "scene/load.h"
#include "scene/material_variants.h"
#include "scene/obj/obj_materials.h"
#include "scene/obj/obj_mesh.h"
#include "scene/obj/obj_polygon.h"
#include "scene/obj/obj_remarks.h"
#include "scene/obj/obj_text.h"
#include "scene/parallel.h"

namespace gnomon {
namespace {

struct Group {
  std::string name;
  std::vector<ObjFaces> faces;
};

class ObjLoader {
 public:
  ObjLoader(std::string_view text, const ObjSource& source)
      : text_(text), file_(source), source_(source.name), progress_("reading " + source_, 2 * text.size()) {}

  Scene load() {
    refuse_other_encodings();
    read_vertices();
    read_faces();
    if (vertices_.positions.empty()) fail_at(1, "no vertices (lines that start with v) in the whole file; is it an OBJ file?");
    Scene scene;
    scene.source = source_;
    scene.name = std::filesystem::path(source_).filename().string();
    if (materials_.empty()) materials_.emplace_back();
    add_obj_materials(scene, file_, libraries_, materials_);
    build(scene);
    return scene;
  }

 private:
  template <class... Args>
  [[noreturn]] void fail_at(size_t line, fmt::format_string<Args...> format, Args&&... args) const {
    fail("{}:{}: {}", source_, line, fmt::format(format, std::forward<Args>(args)...));
  }

  void refuse_other_encodings() const {
    if (text_.starts_with("\xfe\xff") || text_.starts_with("\xff\xfe")) fail_at(1, "UTF-16 text; valid: ASCII or UTF-8");
  }

  // --- first pass: v, vt, vn ---

  template <int N>
  glm::vec<N, float> numbers(const ObjStatement& statement, int required) const {
    glm::vec<N, float> values(0.0f);
    std::string_view rest = statement.rest;
    for (int i = 0; i < N; ++i) {
      const std::string_view word = next_word(rest);
      if (word.empty() && i >= required) break;
      if (word.empty()) fail_at(statement.line, "{} has {} numbers; valid: at least {}", statement.keyword, i, required);
      const auto value = parse_number(word);
      if (!value) {
        fail_at(statement.line, "\"{}\" is not a coordinate; valid: a finite number that fits 32 bits{}", word,
                word.find(',') == word.npos ? "" : ", with a decimal point, not a comma");
      }
      values[i] = *value;
    }
    return values;
  }

  void read_vertices() {
    ObjStatements statements(text_);
    for (ObjStatement s; statements.next(s);) {
      if (s.keyword == "v") {
        add_position(s);
      } else if (s.keyword == "vt") {
        const vec2 uv = numbers<2>(s, 1);
        vertices_.uvs.emplace_back(uv.x, 1.0f - uv.y);  // v runs upward in OBJ
      } else if (s.keyword == "vn") {
        vertices_.normals.push_back(numbers<3>(s, 3));
      }
      progress_.update(s.offset);
    }
  }

  // x y z [w], or x y z r g b: the colours that scanners write, taken as linear. A weight w is of curves only.
  void add_position(const ObjStatement& statement) {
    const auto values = vertex_numbers(statement);
    vertices_.positions.emplace_back(values.xyz);
    if (!values.has_colour && vertices_.colours.empty()) return;
    vertices_.colours.resize(vertices_.positions.size() - 1, vec4(1.0f));
    vertices_.colours.emplace_back(values.has_colour ? values.rgb : vec3(1.0f), 1.0f);
  }

  struct VertexNumbers {
    vec3 xyz{0.0f}, rgb{1.0f};
    bool has_colour = false;
  };
  VertexNumbers vertex_numbers(const ObjStatement& statement) const {
    VertexNumbers result;
    result.xyz = numbers<3>(statement, 3);
    std::string_view rest = statement.rest;
    for (int i = 0; i < 3; ++i) next_word(rest);
    float more[3];
    for (float& value : more) {
      const auto parsed = parse_number(next_word(rest));
      if (!parsed) return result;
      value = *parsed;
    }
    result.rgb = vec3(more[0], more[1], more[2]);
    result.has_colour = next_word(rest).empty();
    return result;
  }

  // --- second pass: faces, groups, materials ---

  void read_faces() {
    ObjStatements statements(text_);
    for (ObjStatement s; statements.next(s);) {
      if (s.keyword == "f" || s.keyword == "fo") {  // fo: its name in the first version of the format
        add_face(s);
      } else if (s.keyword == "v") {
        ++seen_.position;
      } else if (s.keyword == "vt") {
        ++seen_.uv;
      } else if (s.keyword == "vn") {
        ++seen_.normal;
      } else if (s.keyword == "usemtl") {
        material_name_ = s.rest;
        material_ = k_none_yet;
        faces_ = nullptr;
      } else if (s.keyword == "mtllib") {
        if (std::find(libraries_.begin(), libraries_.end(), s.rest) == libraries_.end()) libraries_.emplace_back(s.rest);
      } else if (s.keyword == "o" || s.keyword == "g") {
        if (s.keyword == "o") object_name_ = s.rest, group_name_.clear();
        if (s.keyword == "g") group_name_ = s.rest;
        faces_ = nullptr;
      } else {
        remarks_.skipped(s.keyword, s.line);
      }
      progress_.update(text_.size() + s.offset);
    }
    remarks_.say(source_);
  }

  int material_index(const std::string& name) {
    const auto [entry, is_new] = material_of_name_.try_emplace(name, static_cast<int>(materials_.size()));
    if (is_new) materials_.push_back({name});
    return entry->second;
  }

  // From 1, or negative: relative to the lines before this one. Vertices may follow the faces that use them. nullopt: there is
  // no such line.
  std::optional<int32_t> resolve(std::string_view digits, size_t count, int32_t seen, size_t line) const {
    int64_t index = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (result.ec == std::errc::invalid_argument || result.ptr != digits.data() + digits.size()) {
      fail_at(line, "\"{}\" is not an index; valid: v, v/vt, v//vn or v/vt/vn", digits);
    }
    const bool overflow = result.ec != std::errc();
    const int64_t absolute = index < 0 ? seen + index : index - 1;
    if (overflow || index == 0 || absolute < 0 || absolute >= static_cast<int64_t>(count)) return std::nullopt;
    return static_cast<int32_t>(absolute);
  }
  static std::string valid_indices(size_t count, int32_t seen) {
    if (count == 0) return "none, there are no such lines";
    return seen > 0 ? fmt::format("1 to {}, or -{} to -1", count, seen) : fmt::format("1 to {}", count);
  }

  int32_t position_index(std::string_view digits, size_t line) const {
    const size_t count = vertices_.positions.size();
    const auto index = resolve(digits, count, seen_.position, line);
    if (!index) fail_at(line, "vertex index {} is out of range; valid: {}", digits, valid_indices(count, seen_.position));
    return *index;
  }

  // Without a position there is no face; without the other two there is still a shadow.
  ObjCorner corner(std::string_view word, size_t line) {
    ObjCorner result;
    const size_t first = word.find('/'), second = first == word.npos ? word.npos : word.find('/', first + 1);
    result.position = position_index(word.substr(0, first), line);
    if (first == word.npos) return result;
    const auto uv = word.substr(first + 1, second == word.npos ? word.npos : second - first - 1);
    if (!uv.empty()) result.uv = or_lost(resolve(uv, vertices_.uvs.size(), seen_.uv, line), lost_.uv);
    if (second == word.npos || second + 1 == word.size()) return result;
    const auto normal = resolve(word.substr(second + 1), vertices_.normals.size(), seen_.normal, line);
    result.normal = or_lost(normal, lost_.normal);
    return result;
  }
  static int32_t or_lost(std::optional<int32_t> index, bool& lost) {
    lost = lost || !index;
    return index.value_or(k_absent);
  }

  void add_face(const ObjStatement& statement) {
    polygon_.clear(), polygon_positions_.clear(), triangles_.clear();
    lost_ = {};
    bool has_normals = true, has_uvs = true;
    std::string_view rest = statement.rest;
    for (std::string_view word; !(word = next_word(rest)).empty();) {
      polygon_.push_back(corner(word, statement.line));
      polygon_positions_.push_back(vertices_.positions[static_cast<size_t>(polygon_.back().position)]);
      has_uvs = has_uvs && polygon_.back().uv != k_absent;
      has_normals = has_normals && polygon_.back().normal != k_absent &&
                    vertices_.normals[static_cast<size_t>(polygon_.back().normal)] != vec3(0.0f);
    }
    if (polygon_.size() < 3) return remarks_.face(ObjRemarks::too_few_corners, statement.line);
    if (lost_.uv) remarks_.face(ObjRemarks::without_uv, statement.line);
    if (lost_.normal) remarks_.face(ObjRemarks::without_normal, statement.line);
    if (!triangulate(polygon_positions_, triangles_)) {
      fail_at(statement.line, "a concave polygon of {} corners; valid: at most {}", polygon_.size(), k_max_concave_corners);
    }
    std::vector<ObjCorner>& corners = current_faces(has_normals, has_uvs).corners;
    for (const auto& triangle : triangles_) {
      for (const uint32_t i : triangle) {
        corners.push_back(polygon_[i]);
        if (!has_normals) corners.back().normal = k_absent;
        if (!has_uvs) corners.back().uv = k_absent;  // of all corners: a picture between some of them would be smeared
      }
    }
  }

  // Of the current group and material; the last answer is kept, since it is asked for every face.
  ObjFaces& current_faces(bool has_normals, bool has_uvs) {
    if (faces_ && faces_->has_normals == has_normals && faces_->has_uvs == has_uvs) return *faces_;
    const std::string separator = object_name_.empty() || group_name_.empty() ? "" : "/";
    const std::string name = object_name_ + separator + group_name_;
    const auto [entry, is_new] = group_of_name_.try_emplace(name, groups_.size());
    if (is_new) groups_.push_back({name, {}});
    if (material_ == k_none_yet) material_ = material_index(material_name_);
    auto& all = groups_[entry->second].faces;
    auto found = std::find_if(all.begin(), all.end(), [&](const ObjFaces& f) {
      return f.material == material_ && f.has_normals == has_normals && f.has_uvs == has_uvs;
    });
    if (found == all.end()) found = all.insert(all.end(), ObjFaces{material_, has_normals, has_uvs, {}});
    bool& any_has_uvs = materials_[static_cast<size_t>(material_)].has_uvs;
    any_has_uvs = any_has_uvs || has_uvs;
    faces_ = &*found;
    return *faces_;
  }

  // --- from faces to meshes ---

  void build(Scene& scene) {
    std::vector<std::pair<const ObjFaces*, MeshPart*>> work;
    MaterialVariants variants(scene);
    for (Group& group : groups_) {
      Mesh mesh;
      mesh.name = group.name.empty() ? scene.name : group.name;
      mesh.parts.resize(group.faces.size());
      for (ObjFaces& faces : group.faces) {
        if (!faces.has_uvs) faces.material = variants.without_uvs(faces.material, mesh.name);
      }
      Object object;
      object.name = mesh.name;
      object.mesh = static_cast<int>(scene.meshes.size());
      scene.objects.push_back(object);
      scene.meshes.push_back(std::move(mesh));
    }
    variants.say(source_);
    for (size_t g = 0; g < groups_.size(); ++g) {
      for (size_t i = 0; i < groups_[g].faces.size(); ++i) work.emplace_back(&groups_[g].faces[i], &scene.meshes[g].parts[i]);
    }
    Progress progress("preparing " + source_, work.size());
    parallel_for(work.size(), progress, [&](size_t i) { *work[i].second = build_obj_part(vertices_, *work[i].first); });
  }

  std::string_view text_;
  const ObjSource& file_;
  const std::string& source_;
  Progress progress_;

  ObjVertices vertices_;

  struct {
    int32_t position = 0, uv = 0, normal = 0;
  } seen_;  // lines so far, in the second pass
  std::string object_name_, group_name_;
  // Numbered with its first face: what no face uses is not read.
  static constexpr int k_none_yet = -1;
  std::string material_name_;
  int material_ = k_none_yet;
  ObjFaces* faces_ = nullptr;
  std::vector<Group> groups_;
  std::unordered_map<std::string, size_t> group_of_name_;
  std::unordered_map<std::string, int> material_of_name_;
  std::vector<ObjMaterialUse> materials_;
  std::vector<std::string> libraries_;
  ObjRemarks remarks_;

  struct {
    bool uv = false, normal = false;
  } lost_;                          // indices of the current face that point at nothing
  std::vector<ObjCorner> polygon_;  // scratch of add_face
  std::vector<vec3> polygon_positions_;
  std::vector<std::array<uint32_t, 3>> triangles_;
};

}  // namespace

Scene load_obj_from_memory(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                           const SceneFileOptions& options) {
  const ObjSource source{name, folder, options};
  Scene scene = ObjLoader(text, source).load();
  finish_file_scene(scene, options);
  return scene;
}

Scene load_obj(const std::filesystem::path& path, const SceneFileOptions& options) {
  const std::string text = read_text_file(path);
  const auto folder = path.parent_path();
  return load_obj_from_memory(text, path.string(), folder.empty() ? "." : folder, options);
}

}  // namespace gnomon
