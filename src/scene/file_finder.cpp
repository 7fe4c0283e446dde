#include "scene/file_finder.h"

#include <algorithm>

#include "base/log.h"
#include "base/lower_case.h"
#include "scene/lost_pictures.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::string plain_name(std::string_view name) {
  constexpr std::string_view k_blanks = " \t";
  while (!name.empty() && k_blanks.find(name.front()) != k_blanks.npos) name.remove_prefix(1);
  while (!name.empty() && k_blanks.find(name.back()) != k_blanks.npos) name.remove_suffix(1);
  if (name.size() > 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  return std::string(name);
}

std::string with_slashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

std::vector<std::string> steps_of(const std::string& name) {
  std::vector<std::string> steps;
  for (size_t at = 0; at < name.size();) {
    const size_t end = std::min(name.find('/', at), name.size());
    if (end > at && name.compare(at, end - at, ".") != 0) steps.push_back(name.substr(at, end - at));
    at = end + 1;
  }
  return steps;
}

}  // namespace

FileFinder::~FileFinder() {
  try {
    say_what_was_guessed();
  } catch (...) {  // memory: what is lost is a hint
  }
}

std::optional<fs::path> FileFinder::find_exactly(const std::string& name, std::span<const fs::path> folders) const {
  const std::string plain = plain_name(name);
  if (plain.empty() || name.find('\0') != name.npos) return std::nullopt;
  for (const fs::path& folder : folders) {
    if (folder.empty()) continue;
    for (const std::string& spelling : {name, plain, with_slashes(plain)}) {
      if (is_file(folder / spelling)) return folder / spelling;
    }
  }
  return std::nullopt;
}

std::optional<fs::path> FileFinder::find(const std::string& name, std::span<const fs::path> folders) {
  if (const auto exact = find_exactly(name, folders)) return exact;
  constexpr size_t k_max_steps = 64;
  const std::vector<std::string> steps = steps_of(with_slashes(plain_name(name)));
  if (steps.empty() || steps.size() > k_max_steps || name.find('\0') != name.npos) return std::nullopt;
  for (size_t skipped = 0; skipped < steps.size(); ++skipped) {
    for (const fs::path& folder : folders) {
      if (folder.empty()) continue;
      const auto found = walk(folder, std::span(steps).subspan(skipped));
      if (!found) continue;
      guessed_.try_emplace(name, *found);
      return found;
    }
  }
  return std::nullopt;
}

// Step by step; an entry of exactly that name goes before one in another case.
std::optional<fs::path> FileFinder::walk(const fs::path& folder, std::span<const std::string> steps) {
  fs::path current = folder;
  for (const std::string& step : steps) {
    std::error_code error;
    if (fs::exists(current / step, error)) {
      current /= step;
    } else if (const auto like = entry_like(current, step)) {
      current /= *like;
    } else {
      return std::nullopt;
    }
  }
  return is_file(current) ? std::optional(current) : std::nullopt;
}

std::optional<std::string> FileFinder::entry_like(const fs::path& folder, const std::string& name) {
  const auto [known, is_new] = entries_.try_emplace(folder);
  if (is_new) {
    std::error_code error;
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
      const std::string found = entry->path().filename().string();
      std::string& kept = known->second[lower_case(found)];
      if (kept.empty() || found < kept) kept = found;  // not the order of the directory, which is none
    }
  }
  const auto found = known->second.find(lower_case(name));
  return found == known->second.end() ? std::nullopt : std::optional(found->second);
}

void FileFinder::say_what_was_guessed() const {
  if (guessed_.empty()) return;
  std::vector<std::string> found;
  for (const auto& [name, path] : guessed_) found.push_back(fmt::format("{} for '{}'", path.string(), name));
  log_info("{}: {} file{} found by looser rules (case of letters, folders): {}", source_, guessed_.size(),
           guessed_.size() == 1 ? " was" : "s were", first_names(found));
}

}  // namespace gnomon
