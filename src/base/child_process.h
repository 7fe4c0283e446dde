// Another program, run beside this one; what it writes is collected.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace gnomon {

class ChildProcess {
 public:
  // The program (a path, or a name that PATH finds) and its arguments. Its stdin is empty. Throws Error where it cannot be
  // started.
  explicit ChildProcess(const std::vector<std::string>& command);
  // Ends it where it still runs: SIGTERM, and waits.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Takes in what was written since; does not wait.
  bool running();
  void wait();
  void stop();  // SIGTERM; it runs until it heeds that

  // stdout and stderr, as they came.
  const std::string& output() const { return output_; }
  // Once it ended: of a program that a signal ended 128 + its number, as in a shell.
  int exit_code() const { return exit_code_; }

 private:
  void read(bool wait_for_end);
  void reap(bool wait_for_end);

  pid_t process_ = 0;
  int pipe_ = -1;
  bool ended_ = false;
  int exit_code_ = 0;
  std::string output_;
};

}  // namespace gnomon
