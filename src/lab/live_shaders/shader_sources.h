// The shaders of a source tree: which text belongs to a name, which files it includes, which of those C++ code reads too.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace gnomon {

// What the files say is read once, when it is first asked for: a new object sees new texts. Paths are relative to the tree's
// src/.
class ShaderSources {
 public:
  explicit ShaderSources(std::filesystem::path src) : src_(std::move(src)) {}

  // Where a shader is written: its own file, or the template that kernels of its kind are made from.
  std::string file_of(const std::string& name) const;
  // What the compiler reads for a generated kernel: the template with the names of its technique.
  std::string kernel_text(const std::string& name);
  bool is_kernel(const std::string& name) const { return file_of(name) != name; }

  // The file of the shader and everything that it includes, whether it is there or not.
  std::set<std::string> files_of(const std::string& name);
  // Identifies a file's text; empty where there is no such file.
  const std::string& hash(const std::string& file) { return read(file).hash; }

  // Every shader file, include and parameter table below src/.
  std::set<std::string> all_files() const;
  // Those that C++ code includes, in however many steps: structs in them are laid out when the program is built.
  std::set<std::string> shared_with_cpp();

 private:
  struct File {
    std::string text, hash;
    std::set<std::string> includes;
  };
  const File& read(const std::string& file);
  void add_includes(const std::string& file, const std::string& text, std::set<std::string>& includes) const;
  void add_closure(const std::string& file, std::set<std::string>& files);

  std::filesystem::path src_;
  std::map<std::string, File> files_;
};

}  // namespace gnomon
