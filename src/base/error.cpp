// Messages of errors; a failed assertion says where, then aborts.
#include "base/error.h"

#include <cstdio>
#include <cstdlib>

#include "base/visible_text.h"

namespace gnomon {

Error::Error(const std::string& message, ExitCode code) : std::runtime_error(visible_text(message)), code_(code) {}

void assertion_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "gnomon: bug: %s does not hold at %s:%d\n", condition, file, line);
  std::abort();
}

}  // namespace gnomon
