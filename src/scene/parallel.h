// Independent pieces of work on all cores: pictures to decode, mesh parts to finish.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

#include "base/interrupt.h"
#include "base/log.h"

namespace gnomon {

// Calls work(i) once for each i below count, in any order, on several threads. Of several exceptions the one with the
// lowest i is thrown again, so that an error message does not depend on timing. Counts `progress` up to `count`. Threads heed
// the caller's cancellation.
template <class Work>
void parallel_for(size_t count, Progress& progress, const Work& work) {
  std::vector<std::exception_ptr> errors(count);
  std::atomic<size_t> next = 0;
  const auto worker = [&, cancellation = Cancellation::of_this_thread()](bool reports) {
    Cancellation::heed(cancellation);
    for (size_t i; (i = next++) < count;) {
      if (reports) progress.update(i);
      try {
        check_cancelled();
        work(i);
      } catch (...) {
        errors[i] = std::current_exception();
      }
    }
  };
  const size_t helpers = std::min<size_t>(std::max(std::thread::hardware_concurrency(), 1u), std::max<size_t>(count, 1)) - 1;
  std::vector<std::jthread> threads;
  for (size_t i = 0; i < helpers; ++i) threads.emplace_back(worker, false);
  worker(true);
  threads.clear();  // joins
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace gnomon
