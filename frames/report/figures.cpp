#include "frames/report/figures.h"

#include <algorithm>
#include <numeric>

#include "core/base/median.h"
#include "frames/bench/bench_row.h"

namespace kerf {

void StepTimes::add(double nanoseconds) {
  if (step_ == least_.size()) least_.push_back(nanoseconds);
  least_[step_] = std::min(least_[step_], nanoseconds);
  if (rounds_.empty()) rounds_.push_back(0);
  rounds_.back() += nanoseconds;
  ++step_;
}

Times StepTimes::over(double objects) const {
  std::vector<double> sorted = least_;
  std::sort(sorted.begin(), sorted.end());
  const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  const double steps = std::max<double>(1, static_cast<double>(sorted.size()));
  const auto [fastest, slowest] = std::minmax_element(rounds_.begin(), rounds_.end());
  const bool any = !rounds_.empty();
  return {sum / steps / objects,
          median(sorted) / objects,
          percentile(sorted, 0.99) / objects,
          percentile(sorted, 1) / objects,
          any ? *fastest / steps / objects : 0,
          any ? *slowest / steps / objects : 0};
}

Json as_json(const Times& times) {
  return {{"mean_ns", times.mean},
          {"mean_ns_low", times.round_low},
          {"mean_ns_high", times.round_high},
          {"median_ns", times.median},
          {"p99_ns", times.p99},
          {"max_ns", times.max}};
}

double quantile(std::vector<double> numbers, double share) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[static_cast<std::size_t>(share * static_cast<double>(numbers.size() - 1) + 0.5)];
}

}  // namespace kerf
