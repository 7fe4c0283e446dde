// GLSL to SPIR-V while the program runs, by the compiler and with the flags of the build.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gnomon {

// A source tree and what compiles it.
struct ShaderTree {
  std::filesystem::path root;  // holds src/
  std::filesystem::path compiler;

  // What this program was built from, and with. The environment variable GNOMON_SOURCE_TREE names a copy of the tree to use
  // instead.
  static ShaderTree of_this_build();
  std::filesystem::path src() const { return root / "src"; }
  // Empty where shaders can be compiled, else what is missing.
  std::string unusable() const;
};

// The words of a shader by its name (gpu/shader.h). Throws Error with the compiler's message: "frame/shading/shade.comp:12:
// error: ..."
std::vector<uint32_t> compile_shader(const ShaderTree& tree, const std::string& name);

}  // namespace gnomon
