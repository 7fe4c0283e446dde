// Ctrl-C and SIGTERM in long work: the handler only sets a flag; the work asks for it where it may stop, so nothing is left half-written.
#pragma once

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

}  // namespace gnomon
