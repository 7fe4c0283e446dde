// Memory that runs out at a chosen call, so that a test can look at what becomes of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gnomon::test {

// Runs `action` once to count its calls of `operator new`, then again and again, each time with another one of them failing
// (all of the first 64, and evenly chosen ones after that, `tries` at most). It must then throw std::bad_alloc or an Error
// whose message says `memory`, or give the same result as ever; anything else fails the test, and an end of the process does
// anyhow. Only calls from the program's own code count: those within a library are not ours to mend, and some end the process
// (LLVM; libstdc++ 12 where it opens a folder).
void try_without_memory(const std::string& what, const std::function<uint64_t()>& action, size_t tries,
                        size_t but_the_last = 0);

// The calls of `operator new` that would count, for `but_the_last`: those never fail.
size_t count_allocations(const std::function<void()>& action);

// For results: mixes the bytes of `values` into `hash` (FNV-1a).
template <class T>
uint64_t mixed(uint64_t hash, const std::vector<T>& values) {
  for (const std::byte byte : std::as_bytes(std::span(values)))
    hash = (hash ^ std::to_integer<uint64_t>(byte)) * 0x100000001b3u;
  return hash;
}

}  // namespace gnomon::test
