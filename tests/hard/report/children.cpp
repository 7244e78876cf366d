#include "tests/hard/report/children.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace kerf::test {
namespace {

constexpr int kThrown = 3;
constexpr int kOutOfMemory = 4;

Trial* shared_trial(const Limits& limits) {
  void* memory = mmap(nullptr, sizeof(Trial), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
    throw std::runtime_error("no shared memory: " + std::string(std::strerror(errno)));
  auto* trial = new (memory) Trial;
  trial->limit_ms = 1e3 * limits.seconds;
  return trial;
}

void set_limit(decltype(RLIMIT_CPU) what, rlim_t value) {
  const rlimit limit{value, value};
  setrlimit(what, &limit);
}

/// The child's whole life. What libraries print of their own troubles is not for the reader of the table.
[[noreturn]] void live(const Children::Work& work, Trial& trial, const Limits& limits) {
  set_limit(RLIMIT_CPU, limits.processor_seconds);
  set_limit(RLIMIT_AS, limits.memory);
  set_limit(RLIMIT_CORE, 0);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  try {
    work(trial);
    _exit(0);
  } catch (const std::bad_alloc&) {
    _exit(kOutOfMemory);
  } catch (const std::exception& error) {
    note(trial, error.what());
    _exit(kThrown);
  }
}

Outcome outcome_of(int status, const Trial& trial, bool extra_allowed, const Limits& limits) {
  Outcome outcome{Verdict::crash, trial, {}, false};
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    outcome.verdict = judge(trial, extra_allowed);
  } else if (WIFEXITED(status)) {
    const int code = WEXITSTATUS(status);
    outcome.reason = code == kOutOfMemory ? "out of memory"
                     : code == kThrown    ? trial.note.data()
                                          : "exit code " + std::to_string(code);
  } else if (WTERMSIG(status) == SIGPROF) {
    outcome.verdict = Verdict::time_out;
    outcome.reason = "more than " + std::to_string(limits.seconds) + " s of processor time in steps";
  } else if (WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGXCPU) {
    outcome.verdict = Verdict::time_out;
    outcome.reason = "more than " + std::to_string(limits.processor_seconds) + " s of processor time in all";
  } else {
    outcome.reason = strsignal(WTERMSIG(status));
  }
  return outcome;
}

}  // namespace

Children::~Children() {
  for (const Child& child : running_) {
    kill(child.process, SIGKILL);
    waitpid(child.process, nullptr, 0);
    munmap(child.trial, sizeof(Trial));
  }
}

void Children::run(const Work& work, bool extra_allowed, Done done) {
  while (running_.size() >= at_once_) wait_for_one();
  Child child;
  child.trial = shared_trial(limits_);
  child.extra_allowed = extra_allowed;
  child.done = std::move(done);
  // Only for what sleeps instead of working: others may want the processor, too.
  child.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(4 * limits_.processor_seconds);
  child.process = fork();
  if (child.process == 0) live(work, *child.trial, limits_);
  if (child.process < 0) {
    munmap(child.trial, sizeof(Trial));
    throw std::runtime_error("no process: " + std::string(std::strerror(errno)));
  }
  running_.push_back(std::move(child));
}

void Children::finish() {
  while (!running_.empty()) wait_for_one();
}

void Children::kill_late() {
  const auto now = std::chrono::steady_clock::now();
  for (const Child& child : running_)
    if (now > child.deadline) kill(child.process, SIGKILL);
}

/// Ends at least one child; it may be the first to be ready, in any order.
void Children::wait_for_one() {
  constexpr useconds_t kPause = 1000;
  for (;;) {
    for (std::size_t i = 0; i < running_.size(); ++i) {
      int status = 0;
      if (waitpid(running_[i].process, &status, WNOHANG) != running_[i].process) continue;
      end(i, status);
      return;
    }
    kill_late();
    usleep(kPause);
  }
}

void Children::end(std::size_t index, int status) {
  const Child child = std::move(running_[index]);
  running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(index));
  const Outcome outcome = outcome_of(status, *child.trial, child.extra_allowed, limits_);
  munmap(child.trial, sizeof(Trial));
  child.done(outcome);
}

}  // namespace kerf::test
