// Escaping and the template.
#include "report/html.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/visible_text.h"

namespace gnomon {

std::string escape_html(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : visible_text(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string script_json(const nlohmann::json& value) {
  const std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string escaped;
  escaped.reserve(text.size());
  // These three occur in JSON inside strings only, where \u is valid.
  for (const char c : text) {
    switch (c) {
      case '<':
        escaped += "\\u003c";
        break;
      case '>':
        escaped += "\\u003e";
        break;
      case '&':
        escaped += "\\u0026";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string fill_template(std::string_view page, const std::vector<std::pair<std::string_view, std::string_view>>& values) {
  std::string filled;
  for (size_t at = 0;;) {
    const size_t open = page.find("{{", at);
    filled += page.substr(at, open - at);
    if (open == page.npos) return filled;
    const size_t close = page.find("}}", open);
    GNOMON_ASSERT(close != page.npos);
    const auto name = page.substr(open + 2, close - open - 2);
    bool known = false;
    for (const auto& [key, value] : values) {
      if (key == name) filled += value, known = true;
    }
    GNOMON_ASSERT(known);
    at = close + 2;
  }
}

}  // namespace gnomon
