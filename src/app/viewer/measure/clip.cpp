#include "app/viewer/measure/clip.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/file.h"
#include "base/log.h"

namespace gnomon::viewer {

std::filesystem::path free_name(const std::string& base, const std::string& extension) {
  for (int number = 0;; ++number) {
    const std::filesystem::path path = fmt::format("{}_{:04}{}", base, number, extension);
    if (!std::filesystem::exists(path)) return path;
  }
}

void Clip::start(const std::string& base, float seconds) {
  folder_ = free_name(base);
  make_folder(folder_);
  wanted_s_ = seconds;
  count_ = 0;
  running_ = true;
  start_ = std::chrono::steady_clock::now();
}

double Clip::seconds() const {
  return running_ ? std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() : lasted_s_;
}

void Clip::stop() {
  if (!running_) return;
  lasted_s_ = seconds();
  running_ = false;
  // A player has to know the rate: as many frames as could be drawn.
  log_info("{}: {} pictures, {:.3g} a second", folder_.string(), count_, count_ / std::max(lasted_s_, 1e-3));
}

void Clip::add(Image8 picture) {
  if (!running_) return;
  const auto path = folder_ / fmt::format("{:04}.png", count_++);
  background_.add([path, picture = std::move(picture)] { write_png(path, picture); });
  if (wanted_s_ > 0.0f && seconds() >= static_cast<double>(wanted_s_)) stop();
}

}  // namespace gnomon::viewer
