#include "scene/obj/obj_remarks.h"

#include <algorithm>

#include "base/log.h"

namespace gnomon {
namespace {

// Empty for what changes no shadow: smoothing groups, display hints, the parts of a surface between its head and `end`.
std::string_view what_is(std::string_view keyword) {
  constexpr std::pair<std::string_view, std::string_view> k_drawn[] = {
      {"l", "lines (l)"},          {"p", "points (p)"},
      {"curv", "curves (curv)"},   {"curv2", "curves (curv2)"},
      {"surf", "surfaces (surf)"}, {"bsp", "surfaces (bsp)"},
      {"bzp", "surfaces (bzp)"},   {"cdc", "curves (cdc)"},
      {"cdp", "surfaces (cdp)"},   {"call", "other files (call)"},
  };
  for (const auto& [name, what] : k_drawn) {
    if (name == keyword) return what;
  }
  return {};
}

}  // namespace

void ObjRemarks::Count::add(size_t line) {
  if (count++ == 0) first_line = line;
}

void ObjRemarks::skipped(std::string_view keyword, size_t line) {
  const std::string_view what = what_is(keyword);
  if (!what.empty()) skipped_[what].add(line);
}

void ObjRemarks::face(Face kind, size_t line) { faces_[kind].add(line); }

void ObjRemarks::say(const std::string& source) const {
  constexpr const char* k_of_faces[] = {
      "with fewer than three corners are left out",
      "name texture coordinates (vt) that are not there: they get none, and holes in their textures are lost",
      "name normals (vn) that are not there: theirs are made"};
  for (size_t kind = 0; kind < std::size(faces_); ++kind) {
    const Count& faces = faces_[kind];
    if (faces.count > 0)
      log_warning("{}:{}: {} face(s) {} (this is the first)", source, faces.first_line, faces.count, k_of_faces[kind]);
  }
  if (skipped_.empty()) return;
  std::string list;
  size_t first_line = skipped_.begin()->second.first_line;
  for (const auto& [what, counted] : skipped_) {
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", counted.count, what);
    first_line = std::min(first_line, counted.first_line);
  }
  log_warning("{}:{}: only faces (f) are drawn and cast shadows; left out: {} (this is the first)", source, first_line, list);
}

}  // namespace gnomon
