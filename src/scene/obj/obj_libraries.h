// The material libraries that an OBJ file names.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/file_finder.h"
#include "scene/obj/mtl_text.h"

namespace gnomon {

class ObjLibraries {
 public:
  // `statements`: what follows each `mtllib`, one name or several. A library that is not there, or cannot be read, is a warning
  // that starts with `source`.
  ObjLibraries(const std::string& source, const std::filesystem::path& folder, const std::vector<std::string>& statements,
               FileFinder& finder);

  struct Entry {
    MtlMaterial material;
    std::filesystem::path folder;  // of its library: its pictures are named from there
  };
  // nullptr where no library has it. Of several of one name the first counts.
  const Entry* find(const std::string& name) const;

 private:
  void read(const std::filesystem::path& path, const std::string& source);

  std::map<std::string, Entry> entries_;
};

// The names in `statement`, which blanks separate and which hold blanks themselves: "my red.mtl my blue.mtl", "a\ b.mtl". A
// name is what is a file (`is_file`), else what ends in .mtl.
std::vector<std::string> split_library_names(std::string_view statement,
                                             const std::function<bool(const std::string&)>& is_file);

}  // namespace gnomon
