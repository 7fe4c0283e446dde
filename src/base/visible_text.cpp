#include "base/visible_text.h"

#include <fmt/format.h>

#include <cstdint>

namespace gnomon {
namespace {

struct Character {
  uint32_t code = 0;
  size_t length = 0;  // bytes; 0: no UTF-8
};

// RFC 3629: no surrogates, no longer form than needed, nothing above 0x10ffff.
Character first_character(std::string_view text) {
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
  const uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return {};
  uint32_t code = lead & (0x7fu >> length);
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3fu);
  }
  constexpr uint32_t k_least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < k_least[length] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {};
  return {code, length};
}

// C0, DEL, C1 (of which 0x9b opens a terminal sequence as ESC [ does), and what turns the direction of the text around it.
bool is_control(uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x202a && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

std::string visible(std::string_view text, std::string_view kept) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_character(text);
    const size_t length = character.length == 0 ? 1 : character.length;
    if (character.length == 0) {
      result += fmt::format("\\x{:02x}", static_cast<uint8_t>(text.front()));
    } else if (is_control(character.code) && kept.find(text.front()) == kept.npos) {
      result += character.code < 0x100 ? fmt::format("\\x{:02x}", character.code) : fmt::format("\\u{:04x}", character.code);
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return result;
}

}  // namespace

std::string visible_text(std::string_view text) { return visible(text, "\n\t"); }

std::string visible_line(std::string_view text) { return visible(text, ""); }

}  // namespace gnomon
