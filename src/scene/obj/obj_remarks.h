// What of an OBJ file is not drawn as it stands there: counted while reading, said once for each kind.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace gnomon {

class ObjRemarks {
 public:
  // A statement that the reader has no use for: remembered where it would be seen (lines, points, curves, surfaces).
  void skipped(std::string_view keyword, size_t line);

  enum Face { too_few_corners, without_uv, without_normal };
  void face(Face kind, size_t line);

  void say(const std::string& source) const;

 private:
  struct Count {
    size_t count = 0, first_line = 0;
    void add(size_t line);
  };
  Count faces_[3];
  std::map<std::string_view, Count> skipped_;  // by a text that outlives all: what they are
};

}  // namespace gnomon
