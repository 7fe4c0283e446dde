// Finding and reading material libraries.
#include "scene/obj/obj_libraries.h"

#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/lower_case.h"
#include "scene/obj/obj_text.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

// "b\ c.mtl" is one word.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::string_view word; !(word = next_word(text)).empty();) {
    std::string name(word);
    while (name.ends_with('\\') && !text.empty()) {
      name.back() = ' ';
      name += next_word(text);
    }
    words.push_back(std::move(name));
  }
  return words;
}

std::string joined(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace

std::vector<std::string> split_library_names(std::string_view statement,
                                             const std::function<bool(const std::string&)>& is_file) {
  constexpr size_t k_longest = 16;  // words of a name; a line of a damaged file has millions
  const std::vector<std::string> words = words_of(statement);
  std::vector<std::string> names;
  for (size_t first = 0; first < words.size();) {
    size_t end = std::min(words.size(), first + k_longest);
    while (end > first && !is_file(joined(std::span(words).subspan(first, end - first)))) --end;
    if (end == first) {
      const auto library = std::find_if(words.begin() + static_cast<ptrdiff_t>(first), words.end(),
                                        [](const std::string& word) { return lower_case(word).ends_with(".mtl"); });
      end = library == words.end() ? words.size() : static_cast<size_t>(library - words.begin()) + 1;
    }
    names.push_back(joined(std::span(words).subspan(first, end - first)));
    first = end;
  }
  return names;
}

ObjLibraries::ObjLibraries(const std::string& source, const fs::path& folder, const std::vector<std::string>& statements,
                           FileFinder& finder) {
  const std::span<const fs::path> folders(&folder, 1);
  const auto is_file = [&](const std::string& name) { return finder.find_exactly(name, folders).has_value(); };
  for (const std::string& statement : statements) {
    const bool is_one_name = is_file(statement);
    for (const std::string& name : is_one_name ? std::vector{statement} : split_library_names(statement, is_file)) {
      if (const auto file = finder.find(name, folders)) {
        read(*file, source);
      } else {
        log_warning("{}: the material library {} is not there; its materials are plain white", source, name);
      }
    }
  }
}

void ObjLibraries::read(const fs::path& path, const std::string& source) {
  try {
    for (MtlMaterial& material : read_mtl(read_text_file(path), path.string())) {
      const std::string name = material.name;
      entries_.try_emplace(name, Entry{std::move(material), path.parent_path()});
    }
  } catch (const Interrupted&) {
    throw;
  } catch (const Error& error) {
    log_warning("{}: a material library cannot be read: {}; its materials are plain white", source, error.what());
  }
}

const ObjLibraries::Entry* ObjLibraries::find(const std::string& name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second;
}

}  // namespace gnomon
