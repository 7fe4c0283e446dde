// Destruction that waits for the GPU, and cannot fail: the memory that it takes is taken when the thing is made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <new>
#include <type_traits>
#include <utility>

namespace gnomon {

// A call without arguments in its own memory.
class Destruction {
 public:
  Destruction() = default;
  ~Destruction() { reset(); }
  Destruction(const Destruction&) = delete;
  Destruction& operator=(const Destruction&) = delete;

  template <class Call>
  void set(Call&& call) noexcept {
    using Stored = std::decay_t<Call>;
    static_assert(sizeof(Stored) <= k_bytes && alignof(Stored) <= alignof(std::max_align_t));
    static_assert(std::is_nothrow_constructible_v<Stored, Call>);
    new (memory_) Stored(std::forward<Call>(call));
    run_ = [](void* stored) { (*static_cast<Stored*>(stored))(); };
    drop_ = [](void* stored) { static_cast<Stored*>(stored)->~Stored(); };
  }
  void run() { run_(memory_); }

 private:
  static constexpr size_t k_bytes = 128;
  void reset() {
    if (drop_) drop_(memory_);
  }
  alignas(std::max_align_t) std::byte memory_[k_bytes];
  void (*run_)(void*) = nullptr;
  void (*drop_)(void*) = nullptr;
};

class DeferredDestruction {
 public:
  // Once for each `add` that will come.
  void reserve() { spare_.emplace_back(); }

  // Runs `destroy` once the GPU has reached `value`, or, while `held`, the value that `release_held` will know.
  template <class Call>
  void add(uint64_t value, bool held, Call&& destroy) noexcept {
    Entry& entry = spare_.front();
    entry.value = value;
    entry.destruction.set(std::forward<Call>(destroy));
    auto& to = held ? held_ : waiting_;
    to.splice(to.end(), spare_, spare_.begin());
  }
  void release_held(uint64_t value) noexcept {
    for (Entry& entry : held_) entry.value = value;
    waiting_.splice(waiting_.end(), held_);
  }
  void run_up_to(uint64_t value) {
    while (!waiting_.empty() && waiting_.front().value <= value) {
      waiting_.front().destruction.run();
      waiting_.pop_front();
    }
  }

 private:
  struct Entry {
    uint64_t value = 0;
    Destruction destruction;
  };
  std::list<Entry> spare_, held_, waiting_;  // entries wander from list to list
};

}  // namespace gnomon
