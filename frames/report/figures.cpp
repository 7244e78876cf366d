#include "frames/report/figures.h"

#include <algorithm>
#include <numeric>

#include "frames/bench/bench_row.h"

namespace kerf {

void StepTimes::add(double nanoseconds) {
  if (step_ == least_.size()) least_.push_back(nanoseconds);
  least_[step_] = std::min(least_[step_], nanoseconds);
  ++step_;
}

Times StepTimes::over(double objects) const {
  std::vector<double> sorted = least_;
  std::sort(sorted.begin(), sorted.end());
  const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  const double steps = std::max<double>(1, static_cast<double>(sorted.size()));
  return {sum / steps / objects, percentile(sorted, 0.5) / objects, percentile(sorted, 0.99) / objects,
          percentile(sorted, 1) / objects};
}

Json as_json(const Times& times) {
  return {{"mean_ns", times.mean}, {"median_ns", times.median}, {"p99_ns", times.p99}, {"max_ns", times.max}};
}

double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return percentile(numbers, 0.5);
}

}  // namespace kerf
