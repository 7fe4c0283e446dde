// Ctrl-C and SIGTERM in long work: the handler only sets a flag; the work asks for it where it may stop, so nothing is left
// half-written.
#pragma once

#include <atomic>

#include "base/error.h"

namespace gnomon {

class Interrupted : public Error {
 public:
  Interrupted() : Error("interrupted", ExitCode::interrupted) {}
};

// While one lives, SIGINT and SIGTERM set the flag. A second signal ends the program as ever.
class InterruptScope {
 public:
  InterruptScope();
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;
};

bool interrupted();
void check_interrupted();  // throws Interrupted

// Gives up the work of one thread, and of those that work for it, from another thread. Must outlive them.
class Cancellation {
 public:
  void cancel() { cancelled_ = true; }

  static const Cancellation* of_this_thread();
  // What this thread does from now on heeds `cancellation`; null: nothing does.
  static void heed(const Cancellation* cancellation);

 private:
  friend void check_cancelled();
  std::atomic<bool> cancelled_ = false;
};
// Throws Interrupted where this thread's work was given up. Cheap: for loops over vertices; Progress calls it, too.
void check_cancelled();

}  // namespace gnomon
