#include "app/viewer/shader_reload.h"

#include <fmt/ranges.h>

#include <vector>

#include "app/viewer/attempt.h"
#include "base/log.h"

namespace gnomon::viewer {

ShaderReload::ShaderReload() {
  if (!watch_.idle_reason().empty()) log_info("shaders are not watched for changes: {}", watch_.idle_reason());
}

void ShaderReload::update(const std::function<void()>& rebuild) {
  auto news = watch_.poll();
  if (!news) return;
  message_ = std::move(news->error);
  if (!message_.empty()) log_warning("{}", message_);
  if (news->compiled.empty()) return;
  ShaderWords before = replaced_shaders(), words = before;
  std::vector<std::string> names;
  for (auto& [name, code] : news->compiled) {
    names.push_back(name);
    words[name] = std::move(code);
  }
  set_replaced_shaders(std::move(words));
  std::string problem;
  if (attempt(problem, rebuild)) {
    log_info("compiled again: {}", fmt::join(names, ", "));
    return;
  }
  message_ = fmt::format("{}: {}", fmt::join(names, ", "), problem);
  log_warning("{}", message_);
  set_replaced_shaders(std::move(before));
  rebuild();
}

}  // namespace gnomon::viewer
