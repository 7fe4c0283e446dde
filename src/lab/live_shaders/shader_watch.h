// Watches the source tree while the program runs, and compiles the shaders in use whose files change.
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "gpu/shader.h"
#include "lab/live_shaders/shader_compiler.h"

namespace gnomon {

// What happened since the last poll.
struct ShaderNews {
  // New words of every shader that a change reached; empty where none compiled. All or none of a change: shaders fit each
  // other.
  ShaderWords compiled;
  // Why the last change took no effect: the compiler's message. Empty again once the files are mended.
  std::string error;
};

class ShaderWatch {
 public:
  // Texts count as those of the build as they are now. Where the tree cannot be compiled nothing is watched.
  explicit ShaderWatch(ShaderTree tree = ShaderTree::of_this_build());
  ~ShaderWatch();
  ShaderWatch(const ShaderWatch&) = delete;
  ShaderWatch& operator=(const ShaderWatch&) = delete;

  // Empty where shaders are watched; else the reason why not.
  const std::string& idle_reason() const { return idle_reason_; }
  // Never waits. Nothing is replaced: that is for the caller, who has the pipelines (set_replaced_shaders).
  std::optional<ShaderNews> poll();

 private:
  using Stamps = std::map<std::string, std::pair<std::filesystem::file_time_type, uintmax_t>>;
  using Hashes = std::map<std::string, std::string>;

  void watch();
  bool wait_for_stop();
  Stamps stamps(const std::set<std::string>& names) const;
  void look(const std::set<std::string>& names);
  void compile(const std::map<std::string, Hashes>& stale);
  void tell(ShaderWords compiled, std::string error);

  ShaderTree tree_;
  std::string idle_reason_;

  // Of the thread alone.
  Hashes at_start_;
  std::set<std::string> shared_;
  std::map<std::string, Hashes> compiled_from_;  // per shader in its present form; else at_start_
  bool failed_ = false;

  std::mutex mutex_;
  std::condition_variable stopping_;
  bool stop_ = false;
  std::optional<ShaderNews> news_;
  std::thread thread_;
};

}  // namespace gnomon
