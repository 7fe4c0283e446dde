// Assertion failure: says where, then aborts.
#include "base/error.h"

#include <cstdio>
#include <cstdlib>

namespace gnomon {

void assertion_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "gnomon: bug: %s does not hold at %s:%d\n", condition, file, line);
  std::abort();
}

}  // namespace gnomon
