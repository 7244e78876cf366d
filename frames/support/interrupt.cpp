#include "frames/support/interrupt.h"

#include <csignal>

namespace kerf {
namespace {

volatile std::sig_atomic_t interrupted = 0;
int guards = 0;  // that live

void note_interrupt(int) { interrupted = 1; }

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

/// A program started by nohup goes on when its terminal closes.
bool is_ignored(int signal) {
  struct sigaction action = {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

InterruptGuard::InterruptGuard() {
  if (guards++ > 0) return;
  interrupted = 0;
  const int once = static_cast<int>(SA_RESETHAND | SA_RESTART);
  handle(SIGINT, note_interrupt, once);
  handle(SIGTERM, note_interrupt, once);
  if (!is_ignored(SIGHUP)) handle(SIGHUP, note_interrupt, once);
  handle(SIGPIPE, SIG_IGN, 0);
}

InterruptGuard::~InterruptGuard() {
  if (--guards > 0) return;
  handle(SIGINT, SIG_DFL, 0);
  handle(SIGTERM, SIG_DFL, 0);
  if (!is_ignored(SIGHUP)) handle(SIGHUP, SIG_DFL, 0);
  handle(SIGPIPE, SIG_DFL, 0);
}

bool InterruptGuard::requested() const { return interrupted != 0; }

}  // namespace kerf
