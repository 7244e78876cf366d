#pragma once

#include <stdexcept>
#include <string>

namespace kerf {

/// What the user asked for cannot be meant: an unknown name, a size of zero. The message says what would do.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user or the system asked the program to stop (SIGINT, SIGTERM). Everything finished so far was kept.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Pictures or files that were to be compared cannot be: nothing was proved, neither "same" nor "different".
class UnusableInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Pictures were compared and differ.
class PicturesDiffer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What `kerf` returns to the shell.
inline constexpr int kExitDone = 0;
inline constexpr int kExitFailure = 1;
inline constexpr int kExitUsage = 2;  ///< also for UnusableInput
inline constexpr int kExitInterrupted = 130;

}  // namespace kerf
