// The text of OBJ and MTL files as statements, and their numbers. tinyobjloader is not used: it turns what is no number (nan
// included) into 0, takes the name of a picture for the third number of -s, and cannot say on which line something is wrong.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gnomon {

struct ObjStatement {
  std::string_view keyword, rest;  // "f", "1 2 3"; trimmed, without comment
  size_t line = 0;                 // 1 for the first
  size_t offset = 0;               // bytes of the file behind it
};

// Statement after statement; lines that end in a backslash are joined.
class ObjStatements {
 public:
  explicit ObjStatements(std::string_view text);
  // Views in the statement live until the next call.
  bool next(ObjStatement& statement);

 private:
  std::string_view next_line();

  std::string_view text_;
  std::string joined_;
  size_t position_ = 0, line_ = 0;
};

// Cuts the next word (up to a blank) off the text; empty at the end.
std::string_view next_word(std::string_view& text);

// Finite numbers only; nullopt for anything else.
std::optional<float> parse_number(std::string_view word);

}  // namespace gnomon
