#include "frames/support/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <system_error>

namespace kerf {
namespace {

constexpr char kDone = '.';

using Pipe = std::array<int, 2>;

Pipe make_pipe() {
  Pipe ends;
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::runtime_error("no pipe: " + std::generic_category().message(errno));
  return ends;
}

void quieten() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

}  // namespace

ChildProcess::ChildProcess(const std::function<void(char)>& work) {
  const Pipe requests = make_pipe();
  const Pipe replies = make_pipe();
  const pid_t parent = getpid();
  std::fflush(nullptr);
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("no process: " + std::generic_category().message(errno));
  requests_ = requests[process_ == 0 ? 0 : 1];
  replies_ = replies[process_ == 0 ? 1 : 0];
  close(requests[process_ == 0 ? 1 : 0]);
  close(replies[process_ == 0 ? 0 : 1]);
  if (process_ != 0) return;
  // Ctrl-C reaches the whole process group; only the parent acts on it.
  signal(SIGINT, SIG_IGN);
  signal(SIGTERM, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
  quieten();
  serve(work);
}

/// The child's main loop.
void ChildProcess::serve(const std::function<void(char)>& work) const {
  try {
    char request = 0;
    while (read(requests_, &request, 1) == 1) {
      work(request);
      if (write(replies_, &kDone, 1) != 1) _exit(1);
    }
  } catch (const std::exception& error) {
    if (write(replies_, error.what(), std::strlen(error.what())) < 0) _exit(1);
  }
  _exit(0);
}

ChildProcess::~ChildProcess() { end({}); }

bool ChildProcess::end(const std::string& trouble) {
  if (process_ < 0) return false;
  trouble_ = trouble;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
  process_ = -1;
  close(requests_);
  close(replies_);
  return false;
}

/// After the child ended by itself: finds out why.
bool ChildProcess::bury() {
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = -1;
  close(requests_);
  close(replies_);
  if (trouble_.empty())
    trouble_ = WIFSIGNALED(status) ? "died: " + std::string(strsignal(WTERMSIG(status)))
                                   : "ended with exit code " + std::to_string(WEXITSTATUS(status));
  return false;
}

bool ChildProcess::ask(char request, std::chrono::duration<double> limit, const std::function<bool()>& stop) {
  if (process_ < 0) return false;
  constexpr int kPatienceMs = 50;
  const auto start = std::chrono::steady_clock::now();
  if (write(requests_, &request, 1) != 1) return bury();
  for (;;) {
    pollfd reply{replies_, POLLIN, 0};
    if (poll(&reply, 1, kPatienceMs) > 0) break;
    if (stop()) return end("interrupted");
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (taken > limit)
      return end("took longer than " + std::to_string(static_cast<int>(limit.count())) + " s");
  }
  std::array<char, PIPE_BUF> text{};  // as much as is written at once
  const ssize_t size = read(replies_, text.data(), text.size());
  if (size == 1 && text[0] == kDone) return true;
  if (size > 0) trouble_.assign(text.data(), static_cast<std::size_t>(size));
  return bury();
}

}  // namespace kerf
