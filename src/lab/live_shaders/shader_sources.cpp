// Reads #include lines as they stand: one behind an #ifdef counts too, which costs a needless compilation at worst.
#include "lab/live_shaders/shader_sources.h"

#include <algorithm>
#include <span>
#include <vector>

#include "base/error.h"
#include "base/file.h"

namespace gnomon {
namespace {

constexpr std::string_view k_shader_suffixes[] = {".glsl", ".params", ".comp",  ".vert",  ".frag", ".geom",
                                                  ".rgen", ".rmiss",  ".rahit", ".rchit", ".in",   ".h"};

bool is_one_of(const std::string& suffix, std::span<const std::string_view> suffixes) {
  return std::find(suffixes.begin(), suffixes.end(), suffix) != suffixes.end();
}

std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts;
  const std::filesystem::path stem = std::filesystem::path(name).replace_extension();
  for (const auto& part : stem) parts.push_back(part.string());
  return parts;
}

void replace_all(std::string& text, std::string_view what, std::string_view with) {
  for (size_t at = 0; (at = text.find(what, at)) != text.npos; at += with.size()) text.replace(at, what.size(), with);
}

}  // namespace

// Kernels are named "resolve/single/pcf.comp", "convert/vsm.comp" (cmake/gnomon_techniques.cmake).
std::string ShaderSources::file_of(const std::string& name) const {
  if (std::filesystem::exists(src_ / name)) return name;
  const std::string kernel = "shadow/map/kernels/" + parts_of(name).front() + ".comp.in";
  return std::filesystem::exists(src_ / kernel) ? kernel : name;
}

std::string ShaderSources::kernel_text(const std::string& name) {
  std::string text = read(file_of(name)).text;
  const auto parts = parts_of(name);
  GNOMON_ASSERT(parts.size() == 2 || parts.size() == 3);
  // Of a kernel for one part, that is a projection or a filter: its text names but one of them.
  replace_all(text, "@FILTER@", parts.back());
  replace_all(text, "@PROJECTION@", parts[1]);
  return text;
}

void ShaderSources::add_includes(const std::string& file, const std::string& text, std::set<std::string>& includes) const {
  constexpr std::string_view k_include = "include";
  for (size_t at = 0; (at = text.find('#', at)) != text.npos; ++at) {
    const size_t word = text.find_first_not_of(" \t", at + 1);
    if (word == text.npos || text.compare(word, k_include.size(), k_include) != 0) continue;
    const size_t quote = text.find_first_not_of(" \t", word + k_include.size());
    if (quote == text.npos || text[quote] != '"') continue;  // <...> is not of the tree
    const size_t end = text.find_first_of("\"\n", quote + 1);
    if (end == text.npos || text[end] != '"') continue;
    const std::string name = text.substr(quote + 1, end - quote - 1);
    const std::filesystem::path beside = (std::filesystem::path(file).parent_path() / name).lexically_normal();
    includes.insert(std::filesystem::is_regular_file(src_ / beside) ? beside.string() : name);
  }
}

const ShaderSources::File& ShaderSources::read(const std::string& path) {
  const auto [found, is_new] = files_.try_emplace(path);
  File& file = found->second;
  if (!is_new) return file;
  try {
    file.text = read_text_file(src_ / path);
  } catch (const Error&) {
    return file;  // the compiler says what is missing, and where it is asked for
  }
  ContentHash hash;
  hash.add(std::as_bytes(std::span(file.text)));
  file.hash = hash.hex();
  add_includes(path, file.text, file.includes);
  return file;
}

void ShaderSources::add_closure(const std::string& path, std::set<std::string>& files) {
  if (!files.insert(path).second) return;
  for (const std::string& include : read(path).includes) add_closure(include, files);
}

std::set<std::string> ShaderSources::files_of(const std::string& name) {
  std::set<std::string> files;
  const std::string file = file_of(name);
  if (file == name) {
    add_closure(name, files);
    return files;
  }
  files.insert(file);
  std::set<std::string> includes;
  add_includes(file, kernel_text(name), includes);
  for (const std::string& include : includes) add_closure(include, files);
  return files;
}

std::set<std::string> ShaderSources::all_files() const {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(src_)) {
    if (is_one_of(entry.path().extension().string(), k_shader_suffixes))
      files.insert(entry.path().lexically_relative(src_).string());
  }
  return files;
}

std::set<std::string> ShaderSources::shared_with_cpp() {
  constexpr std::string_view k_cpp[] = {".h", ".cpp"};
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(src_)) {
    const std::string suffix = entry.path().extension().string();
    // A table is included under a macro, by the folder's name: all of them are C++ structs.
    if (is_one_of(suffix, k_cpp) || suffix == ".params") add_closure(entry.path().lexically_relative(src_).string(), files);
  }
  return files;
}

}  // namespace gnomon
