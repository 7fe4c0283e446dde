// results.jsonl -> checked lines. Whatever the page, the CSV or the table would show wrongly is refused here.
#include <algorithm>

#include "base/error.h"
#include "base/file.h"
#include "report/report.h"
#include "report/result_set.h"

namespace gnomon {
namespace {

using nlohmann::json;
using Pointer = json::json_pointer;

enum class Kind { number, text, object, array };

struct Field {
  const char* pointer;
  Kind kind;
};

constexpr Field k_required[] = {
    {"/technique", Kind::text},  {"/status", Kind::text}, {"/command", Kind::text},
    {"/scene/name", Kind::text}, {"/size", Kind::array},  {"/samples", Kind::number},
};

constexpr Field k_optional[] = {
    {"/gnomon", Kind::object},          {"/gnomon/version", Kind::text},
    {"/gnomon/commit", Kind::text},     {"/scene/triangles", Kind::number},
    {"/camera", Kind::object},          {"/camera/name", Kind::text},
    {"/lights", Kind::array},           {"/device", Kind::object},
    {"/device/name", Kind::text},       {"/device/driver", Kind::text},
    {"/settings", Kind::object},        {"/reason", Kind::text},
    {"/visibility", Kind::object},      {"/artefacts", Kind::object},
    {"/image", Kind::object},           {"/image/psnr", Kind::number},
    {"/image/rmse", Kind::number},      {"/timing", Kind::object},
    {"/timing/frame_ms", Kind::number}, {"/timing/sum_of_passes_ms", Kind::number},
    {"/passes", Kind::array},           {"/gpu_ms", Kind::object},
    {"/gpu_ms/build", Kind::number},    {"/gpu_ms/resolve", Kind::number},
    {"/gpu_ms/total", Kind::number},    {"/memory_bytes", Kind::number},
    {"/reference", Kind::object},       {"/images", Kind::object},
    {"/bench", Kind::object},           {"/bench/run", Kind::text},
    {"/bench/rows", Kind::array},       {"/bench/plot", Kind::object},
};

constexpr Field k_of_visibility[] = {
    {"/mae", Kind::number},
    {"/rmse", Kind::number},
    {"/bias", Kind::number},
    {"/false_shadow", Kind::object},
    {"/false_shadow/area", Kind::number},
    {"/false_shadow/severity", Kind::number},
    {"/false_light", Kind::object},
    {"/false_light/area", Kind::number},
    {"/false_light/severity", Kind::number},
};

constexpr Field k_of_pass[] = {
    {"/stage", Kind::text},   {"/median_ms", Kind::number},  {"/p95_ms", Kind::number},    {"/mad_ms", Kind::number},
    {"/draws", Kind::number}, {"/dispatches", Kind::number}, {"/triangles", Kind::number},
};

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::number:
      return "a number";
    case Kind::text:
      return "a string";
    case Kind::object:
      return "an object";
    case Kind::array:
      return "an array";
  }
  return "";
}

bool is(const json& value, Kind kind) {
  switch (kind) {
    case Kind::number:
      return value.is_number();
    case Kind::text:
      return value.is_string();
    case Kind::object:
      return value.is_object();
    case Kind::array:
      return value.is_array();
  }
  return false;
}

// "/visibility/hard" + "/mae" -> visibility.hard.mae
std::string dotted(const std::string& pointer) {
  std::string name = pointer.substr(1);
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

// The value at the pointer, or nullptr. Unlike json::at it does not throw where a parent is no object.
const json* find(const json& value, const char* pointer) {
  const Pointer path(pointer);
  return value.contains(path) ? &value.at(path) : nullptr;
}

void check_required(const json& line, const std::string& where) {
  for (const auto& [pointer, kind] : k_required) {
    const json* value = find(line, pointer);
    if (!value) fail("{}: no key '{}'", where, dotted(pointer));
    if (!is(*value, kind)) fail("{}: '{}' is {}; valid: {}", where, dotted(pointer), value->dump(), name_of(kind));
  }
  const json& size = line["size"];
  const auto is_count = [](const json& value) { return value.is_number() && value.get<double>() >= 1; };
  if (size.size() != 2 || !is_count(size[0]) || !is_count(size[1])) {
    fail("{}: 'size' is {}; valid: [width, height]", where, size.dump());
  }
  if (!is_count(line["samples"])) fail("{}: 'samples' is {}; valid: 1 and above", where, line["samples"].dump());
  const auto& status = line["status"].get_ref<const std::string&>();
  if (status != "ok" && status != "unavailable") fail("{}: 'status' is '{}'; valid: ok, unavailable", where, status);
}

// null stands for "not measured": it is what a number that is not finite becomes in JSON.
template <size_t count>
void check_optional(const json& parent, const Field (&fields)[count], const std::string& prefix, const std::string& where) {
  for (const auto& [pointer, kind] : fields) {
    const json* value = find(parent, pointer);
    if (value && !value->is_null() && !is(*value, kind)) {
      fail("{}: '{}' is {}; valid: {}", where, dotted(prefix + pointer), value->dump(), name_of(kind));
    }
  }
}

void check_passes(const json& line, const std::string& where) {
  const json* passes = find(line, "/passes");
  if (!passes || passes->is_null()) return;
  for (size_t i = 0; i < passes->size(); ++i) {
    const json& pass = (*passes)[i];
    const std::string prefix = fmt::format("/passes/{}", i);
    if (!pass.is_object()) fail("{}: '{}' is {}; valid: an object", where, dotted(prefix), pass.dump());
    if (!pass.contains("name") || !pass["name"].is_string()) fail("{}: '{}' has no name", where, dotted(prefix));
    check_optional(pass, k_of_pass, prefix, where);
  }
}

void check_picture(const json& value, const std::string& key, const ResultOrigin& origin) {
  if (value.is_null()) return;
  if (value.is_structured()) {
    for (const auto& [name, item] : value.items()) check_picture(item, key + "." + name, origin);
    return;
  }
  if (!value.is_string()) fail("{}: '{}' is {}; valid: the name of a PNG", origin.text(), key, value.dump());
  const std::filesystem::path name(value.get<std::string>());
  // A report is made to be passed on: a results file must not pull other files into it.
  if (name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end()) {
    fail("{}: '{}' is {}, which lies outside the results' folder", origin.text(), key, value.dump());
  }
  if (!std::filesystem::is_regular_file(origin.folder / name)) {
    fail("{}: '{}' names {}, which is missing", origin.text(), key, (origin.folder / name).string());
  }
}

void check_line(const json& line, const ResultOrigin& origin) {
  const std::string where = origin.text();
  if (!line.is_object()) fail("{}: not a result; valid: one JSON object a line", where);
  check_required(line, where);
  check_optional(line, k_optional, "", where);
  for (const char* parent : {"/visibility/pixel", "/visibility/area", "/visibility/hard"}) {
    const json* value = find(line, parent);
    if (!value || value->is_null()) continue;
    if (!value->is_object()) fail("{}: '{}' is {}; valid: an object", where, dotted(parent), value->dump());
    check_optional(*value, k_of_visibility, parent, where);
  }
  check_passes(line, where);
  if (const json* images = find(line, "/images")) check_picture(*images, "images", origin);
}

json parse_line(std::string_view text, const ResultOrigin& origin, bool ends_with_newline) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    if (!ends_with_newline) {
      fail("{}: the last line is cut off, its run was interrupted; remove the line, or complete the run", origin.text());
    }
    // "[json.exception.parse_error.101] parse error at line 1, column 7: ...": the line is ours to name.
    const std::string_view what = error.what();
    const size_t colon = what.find(": ");
    fail("{}: not JSON (byte {}): {}", origin.text(), error.byte, what.substr(colon == what.npos ? 0 : colon + 2));
  }
}

void read_folder(const std::filesystem::path& folder, ResultSet& set) {
  const auto path = folder / "results.jsonl";
  const std::string text = read_text_file(path);
  const size_t before = set.lines.size();
  size_t number = 0;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    const auto content = std::string_view(text).substr(begin, end - begin);
    const ResultOrigin origin{folder, ++number};
    begin = end + 1;
    if (content.find_first_not_of(" \t\r") == content.npos) continue;
    json line = parse_line(content, origin, end < text.size());
    check_line(line, origin);
    set.lines.push_back(std::move(line));
    set.origins.push_back(origin);
  }
  if (set.lines.size() == before) fail("{}: holds no results", path.string());
}

}  // namespace

std::string ResultOrigin::text() const { return fmt::format("{}:{}", (folder / "results.jsonl").string(), line); }

std::vector<json> read_results(const std::filesystem::path& folder) {
  ResultSet set;
  read_folder(folder, set);
  return std::move(set.lines);
}

ResultSet read_result_folders(std::span<const std::filesystem::path> folders) {
  if (folders.empty()) fail_usage("a report needs at least one folder of results");
  ResultSet set;
  for (const auto& folder : folders) read_folder(folder, set);
  return set;
}

}  // namespace gnomon
