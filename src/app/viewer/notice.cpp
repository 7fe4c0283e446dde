#include "app/viewer/notice.h"

#include <fmt/format.h>

namespace gnomon::viewer {
namespace {

constexpr size_t k_shown_warnings = 3;

}  // namespace

std::string warnings_notice(const std::string& scene, std::span<const std::string> warnings) {
  if (warnings.empty()) return {};
  std::string text = fmt::format("opening {} gave {} warning{}:", scene, warnings.size(), warnings.size() == 1 ? "" : "s");
  for (size_t i = 0; i < warnings.size() && i < k_shown_warnings; ++i) text += "\n" + warnings[i];
  if (warnings.size() > k_shown_warnings) text += fmt::format("\nand {} more, in the terminal", warnings.size() - k_shown_warnings);
  return text;
}

std::string picture_notice(const std::string& path, const std::string& drawn_over) {
  return fmt::format("{} also shows {}, which its command does not draw", path, drawn_over);
}

}  // namespace gnomon::viewer
