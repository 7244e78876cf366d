#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf {

/// Chooses by trial among several ways to do the same in each step, as a user of a library would. Each way is
/// tried for two steps, of which the last is timed: what a way leaves behind counts in its time. Then the
/// fastest is used, and timed in each second step. What is known of the others loses weight, so that each
/// is tried again, the sooner the less it was behind.
class FastestWay {
 public:
  static constexpr std::uint32_t kSpan = 2;

  explicit FastestWay(std::size_t ways) : costs_(ways, 0) {}

  /// The way of this step.
  [[nodiscard]] std::size_t way() const { return way_; }
  /// Whether `end_step` needs the time of this step. No other reads a clock.
  [[nodiscard]] bool is_timed() const { return costs_.size() > 1 && step_ % kSpan == kSpan - 1; }
  void end_step(std::uint64_t nanoseconds) {
    if (is_timed()) {
      constexpr double kForgotten = 0.985;
      for (double& cost : costs_) cost *= kForgotten;
      costs_[way_] = static_cast<double>(nanoseconds) + 1;  // 0 is a way that was never tried
      way_ = static_cast<std::size_t>(std::ranges::min_element(costs_) - costs_.begin());
    }
    ++step_;
  }

 private:
  std::vector<double> costs_;  ///< by way
  std::size_t way_ = 0;
  std::uint32_t step_ = 0;
};

}  // namespace kerf
