#pragma once

#include <chrono>
#include <exception>

namespace kerf::python {

/// Notices Ctrl-C in a long call that runs without Python's lock, and whatever else a signal's handler of
/// Python's raises.
class Interrupts {
 public:
  /// Asks Python some twenty times a second, in its main thread; cheap otherwise. True: the call should end,
  /// and `rethrow` says why.
  bool requested();
  /// Throws what the handler raised, if it did.
  void rethrow() const;

 private:
  std::chrono::steady_clock::time_point next_;
  std::exception_ptr raised_;
};

}  // namespace kerf::python
