// One table for the whole program: a shader is asked for by name where its pipeline is made.
#include "gpu/shader.h"

#include <mutex>

namespace gnomon {
namespace {

struct Table {
  std::mutex mutex;
  ShaderWords replaced;
  std::set<std::string> in_use;
};

Table& table() {
  static Table the_table;
  return the_table;
}

}  // namespace

std::vector<uint32_t> find_shader(std::string_view name) {
  const auto built_in = built_in_shader(name);
  const std::lock_guard lock(table().mutex);
  table().in_use.emplace(name);
  const auto found = table().replaced.find(name);
  return found != table().replaced.end() ? found->second : std::vector<uint32_t>(built_in.begin(), built_in.end());
}

std::set<std::string> shaders_in_use() {
  const std::lock_guard lock(table().mutex);
  return table().in_use;
}

ShaderWords replaced_shaders() {
  const std::lock_guard lock(table().mutex);
  return table().replaced;
}

void set_replaced_shaders(ShaderWords words) {
  const std::lock_guard lock(table().mutex);
  table().replaced = std::move(words);
}

}  // namespace gnomon
