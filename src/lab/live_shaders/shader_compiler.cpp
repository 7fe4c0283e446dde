// Runs glslc: the very program and flags of the build, so what compiles here compiles there.
#include "lab/live_shaders/shader_compiler.h"

#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <sstream>

#include "base/child_process.h"
#include "base/error.h"
#include "base/file.h"
#include "base/temporary_folder.h"
#include "lab/live_shaders/shader_sources.h"

namespace gnomon {
namespace {

void replace_all(std::string& text, const std::string& what, const std::string& with) {
  for (size_t at = 0; (at = text.find(what, at)) != text.npos; at += with.size()) text.replace(at, what.size(), with);
}

}  // namespace

ShaderTree ShaderTree::of_this_build() {
  const char* elsewhere = std::getenv("GNOMON_SOURCE_TREE");
  return {elsewhere && *elsewhere ? elsewhere : GNOMON_SOURCE_DIR, GNOMON_GLSLC};
}

std::string ShaderTree::unusable() const {
  if (!std::filesystem::is_directory(src()))
    return fmt::format("{}: the source tree of this program is not there", src().string());
  if (access(compiler.c_str(), X_OK) != 0)
    return fmt::format("{}: the compiler of the shaders is not there", compiler.string());
  return {};
}

std::vector<uint32_t> compile_shader(const ShaderTree& tree, const std::string& name) {
  const TemporaryFolder folder;
  ShaderSources sources(tree.src());
  std::filesystem::path input = tree.src() / name;
  if (sources.is_kernel(name)) {
    input = folder.path() / ("kernel" + std::filesystem::path(name).extension().string());
    write_file(input, sources.kernel_text(name));
  }
  const std::filesystem::path output = folder.path() / "words.spv";
  std::vector<std::string> command = {tree.compiler.string()};
  std::istringstream flags(GNOMON_GLSLC_FLAGS);
  for (std::string flag; flags >> flag;) command.push_back(flag);
  for (const auto& argument : {std::filesystem::path("-I"), tree.src(), std::filesystem::path("-o"), output, input}) {
    command.push_back(argument.string());
  }
  ChildProcess compiler(command);
  compiler.wait();
  if (compiler.exit_code() != 0) {
    std::string message = compiler.output();
    replace_all(message, input.string(), sources.file_of(name));
    replace_all(message, tree.src().string() + "/", "");
    // Behind its messages the compiler counts them.
    message.erase(message.find_last_of('\n', message.find_last_not_of('\n')) + 1);
    message.erase(message.find_last_not_of('\n') + 1);
    fail("{}", message.empty() ? fmt::format("{}: the compiler ended with {}", name, compiler.exit_code()) : message);
  }
  const auto bytes = read_file(output);
  std::vector<uint32_t> words(bytes.size() / sizeof(uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(uint32_t));
  return words;
}

}  // namespace gnomon
