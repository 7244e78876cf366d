#pragma once

#include <vector>

#include "frames/page/cell.h"

namespace kerf {

/// Times of steps, in nanoseconds.
struct Times {
  double mean = 0;
  double median = 0;
  double p99 = 0;
  double max = 0;
  double round_low = 0;   ///< mean of the fastest round
  double round_high = 0;  ///< and of the slowest
};

/// {"mean_ns", "mean_ns_low", "mean_ns_high", "median_ns", "p99_ns", "max_ns"}
Json as_json(const Times& times);

/// The times of many steps: the least of all rounds counts for each step, since other work on the machine
/// only ever adds.
class StepTimes {
 public:
  /// Begins a round; so does the first step.
  void restart() {
    step_ = 0;
    rounds_.push_back(0);
  }
  /// Adds the time of the next step of this round.
  void add(double nanoseconds);
  /// The times divided by a number of objects.
  [[nodiscard]] Times over(double objects) const;

 private:
  std::vector<double> least_;
  std::vector<double> rounds_;  ///< the sum of each
  std::size_t step_ = 0;
};

/// The value that a quarter (or any other share) of the numbers do not exceed. There must be some.
double quantile(std::vector<double> numbers, double share);

}  // namespace kerf
