// posix_spawn and a pipe.
#include "base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/error.h"

namespace gnomon {

ChildProcess::ChildProcess(const std::vector<std::string>& command) {
  GNOMON_ASSERT(!command.empty());
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail("{}: cannot be started: {}", command.front(), std::strerror(errno));
  pipe_ = ends[0];
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  const int error = posix_spawnp(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (error == 0) return;
  close(pipe_);
  fail("{}: cannot be started: {}", command.front(), std::strerror(error));
}

ChildProcess::~ChildProcess() {
  if (!ended_) stop();
  close(pipe_);  // before it is waited for: it may be writing into a pipe that is full
  if (!ended_) reap(true);
}

void ChildProcess::read(bool wait_for_end) {
  for (;;) {
    pollfd ready = {pipe_, POLLIN, 0};
    const int count = poll(&ready, 1, wait_for_end ? -1 : 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    char chunk[4096];
    const ssize_t bytes = ::read(pipe_, chunk, sizeof chunk);
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes <= 0) return;  // the other end is closed
    output_.append(chunk, static_cast<size_t>(bytes));
  }
}

void ChildProcess::reap(bool wait_for_end) {
  int status = 0;
  pid_t found;
  while ((found = waitpid(process_, &status, wait_for_end ? 0 : WNOHANG)) < 0 && errno == EINTR) {
  }
  if (found == 0) return;
  ended_ = true;
  exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + (WIFSIGNALED(status) ? WTERMSIG(status) : 0);
}

bool ChildProcess::running() {
  if (ended_) return false;
  reap(false);
  read(false);  // after the end was seen: nothing is missed
  return !ended_;
}

void ChildProcess::wait() {
  if (ended_) return;
  read(true);
  reap(true);
}

void ChildProcess::stop() {
  if (!ended_) kill(process_, SIGTERM);
}

}  // namespace gnomon
