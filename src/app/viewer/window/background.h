// Work that the frame does not wait for: jobs one after another in a thread of their own.
#pragma once

#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <string>
#include <thread>

namespace gnomon::viewer {

class Background {
 public:
  Background();
  ~Background();  // after the last job
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  // Waits while many jobs are in front: none is dropped, and memory has an end.
  template <class Job>
  void add(Job job) {
    push(std::packaged_task<void()>(std::move(job)));
  }
  size_t waiting();
  // What the jobs threw since the last call; empty for nothing.
  std::string take_error();

 private:
  void push(std::packaged_task<void()> job);
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::packaged_task<void()>> jobs_;  // the first is at work
  bool stop_ = false;
  std::string error_;
  std::thread thread_;
};

}  // namespace gnomon::viewer
