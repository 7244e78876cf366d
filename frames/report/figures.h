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
};

/// {"mean_ns", "median_ns", "p99_ns", "max_ns"}
Json as_json(const Times& times);

/// The times of many steps: the least of all rounds counts for each step, since other work on the machine
/// only ever adds.
class StepTimes {
 public:
  /// Begins a round.
  void restart() { step_ = 0; }
  /// Adds the time of the next step of this round.
  void add(double nanoseconds);
  /// The times divided by a number of objects.
  [[nodiscard]] Times over(double objects) const;

 private:
  std::vector<double> least_;
  std::size_t step_ = 0;
};

/// The median of some numbers; 0 if there are none.
double median(std::vector<double> numbers);

}  // namespace kerf
