// The text of OBJ and MTL files as statements, and their numbers.
#include "scene/obj/obj_text.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

#include "base/lower_case.h"

namespace gnomon {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool has_name(std::string_view keyword) {
  const std::string lower = lower_case(keyword);
  for (const std::string_view known : {"usemtl", "mtllib", "o", "g", "newmtl", "bump", "norm"}) {
    if (lower == known) return true;
  }
  return lower.starts_with("map_");
}

}  // namespace

ObjStatements::ObjStatements(std::string_view text) : text_(text) {
  if (text_.starts_with("\xef\xbb\xbf")) position_ = 3;  // UTF-8 byte order mark
}

// Ends at \n, \r\n or \r alone.
std::string_view ObjStatements::next_line() {
  const size_t start = position_;
  while (position_ < text_.size() && text_[position_] != '\n' && text_[position_] != '\r') ++position_;
  const std::string_view line = text_.substr(start, position_ - start);
  if (position_ < text_.size()) position_ += text_.substr(position_).starts_with("\r\n") ? 2 : 1;
  ++line_;
  return line;
}

bool ObjStatements::next(ObjStatement& statement) {
  while (position_ < text_.size()) {
    std::string_view line = next_line();
    statement.line = line_;
    if (line.ends_with('\\')) {
      joined_.clear();
      while (line.ends_with('\\')) {
        line.remove_suffix(1);
        joined_.append(line).push_back(' ');
        line = next_line();
      }
      line = joined_.append(line);
    }
    statement.rest = trimmed(line);
    if (statement.rest.empty() || statement.rest.front() == '#') continue;
    statement.keyword = next_word(statement.rest);
    // A comment may follow numbers; in a name # is a letter ("usemtl Material#25").
    if (!has_name(statement.keyword)) statement.rest = statement.rest.substr(0, statement.rest.find('#'));
    statement.rest = trimmed(statement.rest);
    statement.offset = position_;
    return true;
  }
  return false;
}

std::string_view next_word(std::string_view& text) {
  size_t start = 0;
  while (start < text.size() && is_blank(text[start])) ++start;
  size_t end = start;
  while (end < text.size() && !is_blank(text[end])) ++end;
  const std::string_view word = text.substr(start, end - start);
  text.remove_prefix(end);
  return word;
}

std::optional<float> parse_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  float value = 0.0f;
  const char* end = word.data() + word.size();
  auto result = std::from_chars(word.data(), end, value);
  if (result.ec == std::errc::result_out_of_range) {
    // Too small for a float is 0, too large is an error.
    const double wide = std::strtod(std::string(word).c_str(), nullptr);
    if (std::abs(wide) > 1.0) return std::nullopt;
    value = static_cast<float>(wide);
    result.ec = std::errc();
  }
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace gnomon
