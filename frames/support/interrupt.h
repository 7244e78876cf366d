#pragma once

namespace kerf {

/// From now on the first SIGINT, SIGTERM or SIGHUP ends the process with this code, outside of every
/// InterruptGuard: for what has nothing to lose. What another program had us ignore stays ignored.
void exit_when_interrupted(int code);

/// While it lives, the first SIGINT, SIGTERM or SIGHUP only sets a flag, so that the work at hand ends in
/// order; the second one kills. SIGPIPE is ignored, so that a closed pipe is an error that can be reported.
/// Afterwards signals do what they did before. Within one, others change nothing: what was requested of one
/// is requested of all. Not for several threads, as signal handlers belong to the process.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] bool requested() const;
};

}  // namespace kerf
