// Staging, the swap, and what is left of an unfinished run.
#include "base/result_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>

#include "base/error.h"
#include "base/file.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* k_unfinished = "gnomon.unfinished";  // a run writes here
constexpr const char* k_replacing = "gnomon.replacing";    // the same folder, finished, on its way to where the result belongs
constexpr const char* k_lines = "results.jsonl";
constexpr const char* k_report = "report.html";
constexpr const char* k_images = "images";

// The lines that can be read: a damaged one is as good as absent here.
std::vector<json> readable_lines(const fs::path& path) {
  std::vector<json> lines;
  if (!fs::is_regular_file(path)) return lines;
  const std::string text = read_text_file(path);
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    json line = json::parse(text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(end),
                            nullptr, false);
    if (line.is_object()) lines.push_back(std::move(line));
    begin = end + 1;
  }
  return lines;
}

void add_pictures(const json& value, std::set<fs::path>& pictures) {
  if (value.is_structured()) {
    for (const json& item : value) add_pictures(item, pictures);
  } else if (value.is_string()) {
    const fs::path name = fs::path(value.get<std::string>()).lexically_normal();
    // Whatever a damaged file says: nothing outside images/ is a picture of a result.
    if (name.begin() != name.end() && *name.begin() == k_images) pictures.insert(name);
  }
}

std::set<fs::path> pictures_of(const std::vector<json>& lines) {
  std::set<fs::path> pictures;
  for (const json& line : lines) {
    if (line.contains("images")) add_pictures(line["images"], pictures);
  }
  return pictures;
}

[[noreturn]] void cannot(const fs::path& path, const char* what, const std::error_code& error) {
  fail("{}: {}: {}", path.string(), what, error.message());
}

void move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) cannot(to, "cannot be replaced", error);
}

void drop(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) cannot(path, "cannot be removed", error);
}

// Each step may be the last one before the power fails: what is done is not done again, and the folder `replacing` goes last.
void replace(const fs::path& folder) {
  const fs::path from = folder / k_replacing;
  if (!fs::is_directory(from)) return;
  std::error_code ignored;
  if (fs::exists(from / k_lines)) {
    // No picture of the new result has moved as long as the old lines are there: they go last.
    if (fs::exists(folder / k_lines)) {
      fs::remove(folder / k_report, ignored);
      for (const fs::path& picture : pictures_of(readable_lines(folder / k_lines))) fs::remove(folder / picture, ignored);
      fs::remove(folder / k_images, ignored);  // where nothing else is in it
      drop(folder / k_lines);
    }
    if (fs::is_directory(from / k_images)) {
      make_folder(folder / k_images);
      for (const auto& picture : fs::directory_iterator(from / k_images))
        move(picture.path(), folder / k_images / picture.path().filename());
    }
    move(from / k_lines, folder / k_lines);
  }
  if (fs::exists(from / k_report)) move(from / k_report, folder / k_report);
  drop(from);
}

}  // namespace

ResultFolder::Made::Made(const fs::path& folder) : anew(!fs::exists(folder)) { make_folder(folder); }

// On the folder itself: no file of ours is left behind, and the system frees it when the program ends, however it does.
ResultFolder::Lock::Lock(const fs::path& folder) : file_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (file_ >= 0 && flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(file_);
    fail("{}: another run of gnomon writes into this folder; valid: another -o, or wait for it", folder.string());
  }
}

ResultFolder::Lock::~Lock() {
  if (file_ >= 0) close(file_);
}

ResultFolder::ResultFolder(fs::path folder, bool resume)
    : folder_(std::move(folder)), unfinished_(folder_ / k_unfinished), made_(folder_), lock_(folder_) {
  replace(folder_);
  if (resume) {
    kept_ = readable_lines(unfinished_ / k_lines);
  } else {
    drop(unfinished_);
  }
  make_folder(unfinished_);
}

ResultFolder::~ResultFolder() {
  if (published_ || !lines_.empty() || !kept_.empty()) return;
  std::error_code ignored;
  fs::remove_all(unfinished_, ignored);
  if (made_.anew) fs::remove(folder_, ignored);
}

std::optional<json> ResultFolder::take_kept(const json& line, std::span<const char* const> keys) {
  const auto equal = [&](const json& kept) {
    if (!kept.contains("status") || kept["status"] != "ok") return false;  // asking again costs nothing
    for (const char* key : keys) {
      // By their text: what went through the file and what did not.
      if (!kept.contains(key) || !line.contains(key) || kept[key].dump() != line[key].dump()) return false;
    }
    const auto pictures = pictures_of(std::vector<json>(1, kept));
    return std::all_of(pictures.begin(), pictures.end(),
                       [&](const fs::path& picture) { return fs::is_regular_file(unfinished_ / picture); });
  };
  const auto found = std::find_if(kept_.begin(), kept_.end(), equal);
  if (found == kept_.end()) return std::nullopt;
  json taken = std::move(*found);
  kept_.erase(found);
  return taken;
}

void ResultFolder::add(json line) {
  lines_.push_back(std::move(line));
  write_lines();
}

void ResultFolder::write_lines() const {
  std::string text;
  for (const auto& list : {&lines_, &kept_}) {
    for (const json& line : *list) text += line.dump() + "\n";
  }
  write_file(unfinished_ / k_lines, text);
}

void ResultFolder::complete() {
  kept_.clear();
  write_lines();
  const auto named = pictures_of(lines_);
  if (!fs::is_directory(unfinished_ / k_images)) return;
  std::vector<fs::path> unnamed;
  for (const auto& file : fs::directory_iterator(unfinished_ / k_images)) {
    if (!named.contains(fs::path(k_images) / file.path().filename())) unnamed.push_back(file.path());
  }
  for (const fs::path& path : unnamed) drop(path);
}

void ResultFolder::publish() {
  move(unfinished_, folder_ / k_replacing);
  published_ = true;
  replace(folder_);
}

std::optional<UnfinishedRun> unfinished_run(const fs::path& folder) {
  const fs::path path = folder / k_unfinished;
  if (!fs::is_directory(path)) return std::nullopt;
  return UnfinishedRun{path, readable_lines(path / k_lines).size()};
}

void settle_results(const fs::path& folder) {
  if (fs::is_directory(folder / k_replacing)) ResultFolder(folder, true);
}

}  // namespace gnomon
