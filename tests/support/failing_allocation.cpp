// Replaces `operator new` of the program that links this.
#include "support/failing_allocation.h"

#include <execinfo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <new>

#include "base/error.h"

extern "C" {
extern const char __executable_start;  // by the linker
extern const char etext;
}

namespace {

std::atomic<bool> armed{false};
std::atomic<size_t> calls{0}, failing{0};  // `failing`: 0 for none, else the call that fails, from 1

// Templates that this program instantiates are taken by libraries too (strings, for one), so the caller alone says little.
bool called_by_the_program() {
  void* frames[10];
  const int count = backtrace(frames, static_cast<int>(std::size(frames)));
  return std::all_of(frames, frames + count, [](const void* frame) {
    const auto at = reinterpret_cast<uintptr_t>(frame);
    return at >= reinterpret_cast<uintptr_t>(&__executable_start) && at < reinterpret_cast<uintptr_t>(&etext);
  });
}

bool must_fail() {
  if (!armed.load(std::memory_order_relaxed) || !called_by_the_program()) return false;
  return calls.fetch_add(1) + 1 == failing.load(std::memory_order_relaxed);
}

void* allocate(size_t bytes, size_t alignment) {
  if (must_fail()) return nullptr;
  if (bytes == 0) bytes = 1;
  if (alignment == 0) return std::malloc(bytes);
  return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

void* allocate_or_throw(size_t bytes, size_t alignment) {
  void* memory = allocate(bytes, alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(size_t bytes) { return allocate_or_throw(bytes, 0); }
void* operator new[](size_t bytes) { return allocate_or_throw(bytes, 0); }
void* operator new(size_t bytes, std::align_val_t alignment) {
  return allocate_or_throw(bytes, static_cast<size_t>(alignment));
}
void* operator new[](size_t bytes, std::align_val_t alignment) {
  return allocate_or_throw(bytes, static_cast<size_t>(alignment));
}
void* operator new(size_t bytes, const std::nothrow_t&) noexcept { return allocate(bytes, 0); }
void* operator new[](size_t bytes, const std::nothrow_t&) noexcept { return allocate(bytes, 0); }
void* operator new(size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(bytes, static_cast<size_t>(alignment));
}
void* operator new[](size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(bytes, static_cast<size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, size_t, std::align_val_t) noexcept { std::free(memory); }

namespace gnomon::test {
namespace {

enum class End { same_result, told, other_result };

End run_with_failure(const std::function<uint64_t()>& action, size_t at, uint64_t expected) {
  calls = 0;
  failing = at;
  armed = true;
  End end = End::told;
  try {
    end = action() == expected ? End::same_result : End::other_result;
  } catch (const std::bad_alloc&) {
  } catch (const Error& error) {
    armed = false;
    EXPECT_NE(std::string(error.what()).find("memory"), std::string::npos) << error.what();
  }
  armed = false;
  return end;
}

}  // namespace

size_t count_allocations(const std::function<void()>& action) {
  called_by_the_program();  // the first call loads what it needs
  calls = failing = 0;
  armed = true;
  action();
  armed = false;
  return calls;
}

void try_without_memory(const std::string& what, const std::function<uint64_t()>& action, size_t tries, size_t but_the_last) {
  called_by_the_program();             // the first call loads what it needs
  const uint64_t expected = action();  // what is made once in a process is there after this
  ASSERT_EQ(run_with_failure(action, SIZE_MAX, expected), End::same_result) << what;
  ASSERT_GT(calls, but_the_last) << what;
  const size_t count = calls - but_the_last;
  ASSERT_GE(count, 10u) << what << ": the allocator is not the one of this program";
  const size_t first = std::min<size_t>(tries / 2, 64), rest = tries - first;
  size_t told = 0, tried = 0;
  for (size_t i = 0; i < tries && tried < count; ++i) {
    const size_t at = i < first || count <= tries ? i + 1 : first + 1 + (count - first - 1) * (i - first) / rest;
    const End end = run_with_failure(action, at, expected);
    EXPECT_NE(end, End::other_result) << what << ": nobody was told that call " << at << " of " << count << " got no memory";
    told += end == End::told ? 1 : 0;
    ++tried;
  }
  EXPECT_GE(told * 10, tried * 8) << what << ": most failures must be seen";
  EXPECT_EQ(action(), expected) << what << ": a failure leaves nothing behind";
}

}  // namespace gnomon::test
