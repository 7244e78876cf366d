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

/// The times of many steps of one thing: of each step the least of all rounds counts, since what else the
/// machine does only ever adds.
class StepTimes {
 public:
  /// Begins a round.
  void restart() { step_ = 0; }
  /// The next step of this round took so long.
  void add(double nanoseconds);
  /// Over so many objects: the times of one.
  [[nodiscard]] Times over(double objects) const;

 private:
  std::vector<double> least_;
  std::size_t step_ = 0;
};

/// The middle of some numbers; 0 if there are none.
double median(std::vector<double> numbers);

}  // namespace kerf
