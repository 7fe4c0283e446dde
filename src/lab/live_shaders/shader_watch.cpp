// Asks for the times of some dozens of files ten times a second, which is cheap, and works on every file system.
#include "lab/live_shaders/shader_watch.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <span>
#include <utility>

#include "base/error.h"
#include "gpu/spirv.h"
#include "lab/live_shaders/shader_sources.h"

namespace gnomon {
namespace {

// A change counts when the files stayed the same for this long: editors write in several steps, and save by renaming.
constexpr std::chrono::milliseconds k_interval(100);

// Push constants are a struct of their own in C++ and in the shader: other offsets would read addresses out of other bytes.
void check_push_constants(const std::string& name, std::span<const uint32_t> words) {
  const auto now = push_constant_offsets(words), built = push_constant_offsets(built_in_shader(name));
  if (!now.empty() && !built.empty() && now != built) {
    fail("{}: its push constants have members at {} bytes, C++ code was built for {}; build the program and start it again",
         name, fmt::join(now, ", "), fmt::join(built, ", "));
  }
}

}  // namespace

ShaderWatch::ShaderWatch(ShaderTree tree) : tree_(std::move(tree)), idle_reason_(tree_.unusable()) {
  if (!idle_reason_.empty()) return;
  ShaderSources sources(tree_.src());
  for (const std::string& file : sources.all_files()) at_start_[file] = sources.hash(file);
  thread_ = std::thread([this] { watch(); });
}

ShaderWatch::~ShaderWatch() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  stopping_.notify_all();
  if (thread_.joinable()) thread_.join();
}

std::optional<ShaderNews> ShaderWatch::poll() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, std::nullopt);
}

void ShaderWatch::tell(ShaderWords compiled, std::string error) {
  const std::lock_guard lock(mutex_);
  if (!news_) news_.emplace();
  for (auto& [name, words] : compiled) news_->compiled[name] = std::move(words);
  news_->error = std::move(error);
}

bool ShaderWatch::wait_for_stop() {
  std::unique_lock lock(mutex_);
  return stopping_.wait_for(lock, k_interval, [&] { return stop_; });
}

void ShaderWatch::watch() {
  shared_ = ShaderSources(tree_.src()).shared_with_cpp();
  std::set<std::string> files, names;
  Stamps seen;
  bool settled = true;
  while (!wait_for_stop()) {
    try {
      // A shader that is used for the first time may have changed before.
      if (auto now = shaders_in_use(); now != names) {
        names = std::move(now);
        settled = false;
      }
      if (files.empty() || !settled) {
        ShaderSources sources(tree_.src());
        files.clear();
        for (const std::string& name : names) files.merge(sources.files_of(name));
      }
      const Stamps now = stamps(files);
      if (now != seen) {
        seen = now;
        settled = false;
      } else if (!settled) {
        settled = true;
        look(names);
      }
    } catch (const std::exception& error) {
      failed_ = true;
      tell({}, error.what());
    }
  }
}

ShaderWatch::Stamps ShaderWatch::stamps(const std::set<std::string>& files) const {
  Stamps stamps;
  for (const std::string& file : files) {
    std::error_code time_error, size_error;
    const auto time = std::filesystem::last_write_time(tree_.src() / file, time_error);
    const auto size = std::filesystem::file_size(tree_.src() / file, size_error);
    stamps[file] = {time_error ? std::filesystem::file_time_type::min() : time, size_error ? 0 : size};
  }
  return stamps;
}

void ShaderWatch::look(const std::set<std::string>& names) {
  ShaderSources sources(tree_.src());
  const auto hash_in = [](const Hashes& hashes, const std::string& file) {
    const auto found = hashes.find(file);
    return found != hashes.end() ? found->second : std::string();
  };
  std::map<std::string, Hashes> stale;
  std::set<std::string> of_cpp;
  for (const std::string& name : names) {
    const auto known = compiled_from_.find(name);
    const Hashes& before = known != compiled_from_.end() ? known->second : at_start_;
    Hashes now;
    bool changed = false;
    for (const std::string& file : sources.files_of(name)) {
      now[file] = sources.hash(file);
      changed = changed || now[file] != hash_in(before, file);
    }
    if (!changed) continue;
    for (const auto& [file, hash] : now) {
      if (shared_.contains(file) && hash != hash_in(at_start_, file)) of_cpp.insert(file);
    }
    stale[name] = std::move(now);
  }
  if (!of_cpp.empty()) {
    failed_ = true;
    tell({}, fmt::format("{}: C++ code was built with the former text of this; build the program and start it again. Shaders "
                         "that include it "
                         "are compiled again once its former text is back",
                         fmt::join(of_cpp, ", ")));
  } else if (!stale.empty()) {
    compile(stale);
  } else if (std::exchange(failed_, false)) {
    tell({}, {});
  }
}

void ShaderWatch::compile(const std::map<std::string, Hashes>& stale) {
  ShaderWords compiled;
  std::vector<const std::string*> names;
  for (const auto& [name, hashes] : stale) names.push_back(&name), compiled[name];
  std::vector<std::string> errors(names.size());
  std::atomic<size_t> next = 0;
  std::vector<std::thread> threads(std::min<size_t>(names.size(), std::max(1u, std::thread::hardware_concurrency())));
  for (std::thread& thread : threads) {
    thread = std::thread([&] {
      for (size_t i; (i = next++) < names.size();) {
        try {
          auto& words = compiled.find(*names[i])->second = compile_shader(tree_, *names[i]);
          check_push_constants(*names[i], words);
        } catch (const std::exception& error) {
          errors[i] = error.what();
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  // One mistake in an include is told by every shader that includes it.
  std::set<std::string> different(errors.begin(), errors.end());
  different.erase(std::string());
  failed_ = !different.empty();
  if (failed_) {
    tell({}, fmt::format("{}", fmt::join(different, "\n")));
    return;
  }
  for (const auto& [name, hashes] : stale) compiled_from_[name] = hashes;
  tell(std::move(compiled), {});
}

}  // namespace gnomon
