#pragma once

#include <cstdint>

namespace kerf {

/// The time of one step. With a single thread, time that the system gives to other processes does not count:
/// the lesser of wall time and the thread's processor time is taken. (Only wall time where no process
/// interferes, since reading the other clock takes a quarter of a microsecond.)
class StepTimer {
 public:
  explicit StepTimer(bool one_thread);
  [[nodiscard]] std::uint64_t nanoseconds() const;
  [[nodiscard]] double milliseconds() const { return static_cast<double>(nanoseconds()) * 1e-6; }

 private:
  bool one_thread_;
  std::uint64_t processor_;
  std::uint64_t wall_;
};

}  // namespace kerf
