#include "app/viewer/window/background.h"

#include <exception>
#include <utility>

namespace gnomon::viewer {
namespace {

constexpr size_t k_most_waiting = 64;  // pictures of a window: some hundred MiB

}  // namespace

Background::Background() : thread_([this] { work(); }) {}

Background::~Background() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Background::push(std::packaged_task<void()> job) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return jobs_.size() <= k_most_waiting; });
  jobs_.push_back(std::move(job));
  changed_.notify_all();
}

size_t Background::waiting() {
  const std::lock_guard lock(mutex_);
  return jobs_.size();
}

std::string Background::take_error() {
  const std::lock_guard lock(mutex_);
  return std::exchange(error_, {});
}

void Background::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return stop_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    std::packaged_task<void()>& job = jobs_.front();  // a deque's elements stay in place
    lock.unlock();
    std::string error;
    try {
      job();
      job.get_future().get();  // throws what the job threw
    } catch (const std::exception& thrown) {
      error = thrown.what();
    }
    lock.lock();
    if (!error.empty()) error_ = error;
    jobs_.pop_front();
    changed_.notify_all();
  }
}

}  // namespace gnomon::viewer
