// --overlay, --pick and --map.
#include <algorithm>
#include <charconv>

#include "app/viewer/explain/explain.h"
#include "base/error.h"

namespace gnomon::viewer {
namespace {

std::optional<uint32_t> number_of(std::string_view text) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

void add_overlay(std::string_view name, ExplainOptions& options) {
  if (name == "lines") {
    options.lines = true;
    return;
  }
  std::string valid = "lines";
  for (uint32_t overlay = k_overlay_none + 1; overlay < k_overlay_count; ++overlay) {
    valid += fmt::format(", {}", overlay_name(overlay));
    if (name != overlay_name(overlay)) continue;
    if (options.overlay != k_overlay_none) {
      fail_usage("--overlay: '{}' and '{}' cannot both be shown; valid: one of them, and lines", overlay_name(options.overlay),
                 name);
    }
    options.overlay = overlay;
    return;
  }
  fail_usage("--overlay {}: valid: {}", name, valid);
}

}  // namespace

ExplainOptions parse_explain_options(const std::string& overlay, const std::string& pick, const std::string& map) {
  ExplainOptions options;
  for (size_t begin = 0; begin < overlay.size();) {
    const size_t end = std::min(overlay.find(',', begin), overlay.size());
    add_overlay(std::string_view(overlay).substr(begin, end - begin), options);
    begin = end + 1;
  }
  if (!pick.empty()) {
    const size_t comma = std::min(pick.find(','), pick.size());
    const auto x = number_of(std::string_view(pick).substr(0, comma));
    const auto y = number_of(std::string_view(pick).substr(std::min(comma + 1, pick.size())));
    if (!x || !y) fail_usage("--pick {}: valid: a pixel of the picture, like 120,80", pick);
    options.pick = uvec2(*x, *y);
  }
  if (!map.empty()) {
    const auto layer = number_of(map);
    if (!layer) fail_usage("--map {}: valid: the number of a layer, from 0", map);
    options.map_open = options.map_layer_given = true;
    options.map_layer = *layer;
  }
  return options;
}

}  // namespace gnomon::viewer
