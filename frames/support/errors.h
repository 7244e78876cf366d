#pragma once

#include <stdexcept>

namespace kerf {

/// An error of the user: an unknown name, a size of zero. The message says what is allowed.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user or the system asked the program to stop (SIGINT, SIGTERM, SIGHUP). Everything finished so far was
/// kept.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The answer to what the user asked is no: pictures differ, a replay diverges, there is no such moment. All
/// that prevents an answer is another exception.
class DoesNotHold : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What `kerf` returns to the shell (docs/EXIT_CODES.md).
inline constexpr int kExitHolds = 0;
inline constexpr int kExitDoesNotHold = 1;
inline constexpr int kExitUnusable = 2;
inline constexpr int kExitInterrupted = 130;

}  // namespace kerf
