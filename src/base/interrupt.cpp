// Signal handlers: one atomic store, nothing else is safe there.
#include "base/interrupt.h"

#include <atomic>
#include <csignal>

namespace gnomon {
namespace {

std::atomic<bool> flag = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void set_flag(int) { flag.store(true, std::memory_order_relaxed); }

void handle(int number, void (*handler)(int), int flags) {
  struct sigaction old = {};
  // A shell starts what it runs in the background with SIGINT ignored: that is its wish.
  if (sigaction(number, nullptr, &old) == 0 && old.sa_handler == SIG_IGN) return;
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

thread_local const Cancellation* cancellation_of_thread = nullptr;

}  // namespace

InterruptScope::InterruptScope() {
  flag = false;
  // Reset by the first signal: the second one finds the default.
  for (const int number : {SIGINT, SIGTERM}) handle(number, set_flag, static_cast<int>(SA_RESETHAND) | SA_RESTART);
}

InterruptScope::~InterruptScope() {
  flag = false;
  for (const int number : {SIGINT, SIGTERM}) handle(number, SIG_DFL, 0);
}

bool interrupted() { return flag.load(std::memory_order_relaxed); }

void check_interrupted() {
  if (interrupted()) throw Interrupted();
}

const Cancellation* Cancellation::of_this_thread() { return cancellation_of_thread; }

void Cancellation::heed(const Cancellation* cancellation) { cancellation_of_thread = cancellation; }

void check_cancelled() {
  const Cancellation* cancellation = cancellation_of_thread;
  if (cancellation && cancellation->cancelled_.load(std::memory_order_relaxed)) throw Interrupted();
}

}  // namespace gnomon
