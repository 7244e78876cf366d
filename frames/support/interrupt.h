#pragma once

namespace kerf {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP only sets a flag, so that the work at hand ends in
/// order; the second one kills as usual. SIGPIPE is ignored, so that a closed pipe is an error that can be
/// reported. Within one, others change nothing: what was
/// requested of one is requested of all. Not for several threads, as signal handlers belong to the process.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] bool requested() const;
};

}  // namespace kerf
