#include "app/viewer/notice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace gnomon::viewer {
namespace {

constexpr size_t k_shown_warnings = 3;
constexpr size_t k_shown_files = 3;
constexpr size_t k_most_notices = 4;

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

void Notices::add(std::string text, double seconds) {
  if (text.empty()) return;
  if (notices_.size() == k_most_notices) notices_.erase(notices_.begin());
  notices_.push_back({std::move(text), seconds});
}

void Notices::pass(double seconds) {
  for (Notice& notice : notices_) {
    if (notice.seen) notice.left_s -= seconds;
    notice.seen = true;
  }
  std::erase_if(notices_, [](const Notice& notice) { return notice.left_s <= 0.0; });
}

std::string Notices::text() const {
  std::string text;
  for (const Notice& notice : notices_) text += (text.empty() ? "" : "\n") + notice.text;
  return text;
}

std::string warnings_notice(const std::string& scene, std::span<const std::string> warnings) {
  if (warnings.empty()) return {};
  std::string text = fmt::format("opening {} gave {} warning{}:", scene, warnings.size(), warnings.size() == 1 ? "" : "s");
  for (size_t i = 0; i < warnings.size() && i < k_shown_warnings; ++i) text += "\n" + warnings[i];
  if (warnings.size() > k_shown_warnings)
    text += fmt::format("\nand {} more, in the terminal", warnings.size() - k_shown_warnings);
  return text;
}

std::string drop_notice(std::span<const std::string> paths) {
  if (paths.size() < 2) return {};
  std::vector<std::string> others;
  for (const std::string& path : paths.subspan(1, std::min(paths.size() - 1, k_shown_files))) others.push_back(file_name(path));
  if (paths.size() > 1 + k_shown_files) others.push_back(fmt::format("{} more", paths.size() - 1 - k_shown_files));
  return fmt::format("one scene at a time: {} is opened, not {}", file_name(paths.front()), fmt::join(others, ", "));
}

std::string picture_notice(const std::string& path, const PictureContent& content) {
  std::string text = fmt::format("{} is written{}", path, content.first_side_alone ? ", of the first side alone" : "");
  if (!content.drawn_over.empty())
    text += fmt::format("; it also shows {}, which its command does not draw", content.drawn_over);
  return text;
}

}  // namespace gnomon::viewer
