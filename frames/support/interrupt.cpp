#include "frames/support/interrupt.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <string_view>

namespace kerf {
namespace {

volatile std::sig_atomic_t interrupted = 0;
volatile std::sig_atomic_t exit_code = 0;
int guards = 0;  // that live

constexpr std::array kInterrupts{SIGINT, SIGTERM, SIGHUP};

void note_interrupt(int) { interrupted = 1; }

/// Calls only what may be called at any moment.
void end_at_once(int) {
  constexpr std::string_view kWords = "kerf: interrupted\n";
  static_cast<void>(!write(STDERR_FILENO, kWords.data(), kWords.size()));
  _exit(exit_code);
}

struct sigaction action_of(int signal) {
  struct sigaction action = {};
  sigaction(signal, nullptr, &action);
  return action;
}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

/// What the signals did before the first guard.
struct Earlier {
  std::array<struct sigaction, kInterrupts.size()> interrupts;
  struct sigaction pipe;
};
Earlier earlier;

/// A program started by nohup goes on when its terminal closes.
bool stays_ignored(int signal, const struct sigaction& action) {
  return signal == SIGHUP && action.sa_handler == SIG_IGN;
}

}  // namespace

void exit_when_interrupted(int code) {
  exit_code = code;
  for (const int signal : kInterrupts)
    if (action_of(signal).sa_handler == SIG_DFL) handle(signal, end_at_once, 0);
}

InterruptGuard::InterruptGuard() {
  if (guards++ > 0) return;
  interrupted = 0;
  for (std::size_t k = 0; k < kInterrupts.size(); ++k) {
    earlier.interrupts[k] = action_of(kInterrupts[k]);
    if (!stays_ignored(kInterrupts[k], earlier.interrupts[k]))
      handle(kInterrupts[k], note_interrupt, static_cast<int>(SA_RESETHAND | SA_RESTART));
  }
  earlier.pipe = action_of(SIGPIPE);
  handle(SIGPIPE, SIG_IGN, 0);
}

InterruptGuard::~InterruptGuard() {
  if (--guards > 0) return;
  for (std::size_t k = 0; k < kInterrupts.size(); ++k)
    sigaction(kInterrupts[k], &earlier.interrupts[k], nullptr);
  sigaction(SIGPIPE, &earlier.pipe, nullptr);
}

bool InterruptGuard::requested() const { return interrupted != 0; }

}  // namespace kerf
