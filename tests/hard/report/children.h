#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

#include "tests/hard/report/verdict.h"

namespace kerf::test {

/// What a trial may use up.
struct Limits {
  unsigned seconds = 2;                            ///< of processor time in requests and steps
  unsigned processor_seconds = 30;                 ///< in all, the comparison with the truth included
  std::uint64_t memory = std::uint64_t{4} << 30U;  ///< bytes of address space
};

/// Runs trials in child processes, a few at a time, so that none can harm the others or go on for ever.
class Children {
 public:
  using Work = std::function<void(Trial&)>;
  using Done = std::function<void(const Outcome&)>;

  /// `at_once`: processes that run side by side, at least one.
  Children(Limits limits, unsigned at_once) : limits_(limits), at_once_(at_once) {}
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;
  ~Children();

  /// Starts `work` as soon as a place is free. Its trial is seen here even if it is killed. `done` is called
  /// in this process, in a later call of `run` or `finish`. Throws std::runtime_error if no process can be
  /// made.
  void run(const Work& work, bool extra_allowed, Done done);
  /// Waits for all.
  void finish();

 private:
  struct Child {
    pid_t process = -1;
    Trial* trial = nullptr;  ///< in memory that both processes share
    bool extra_allowed = false;
    Done done;
    std::chrono::steady_clock::time_point deadline;
  };

  void wait_for_one();
  void end(std::size_t index, int status);
  void kill_late();

  Limits limits_;
  unsigned at_once_;
  std::vector<Child> running_;
};

}  // namespace kerf::test
