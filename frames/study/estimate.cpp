#include "frames/study/estimate.h"

#include <array>
#include <cmath>
#include <numeric>

namespace kerf {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double student_quantile(std::size_t degrees) {
  constexpr std::array<double, 10> kFew{12.7062, 4.30265, 3.18245, 2.77645, 2.57058,
                                        2.44691, 2.36462, 2.30600, 2.26216, 2.22814};
  if (degrees <= kFew.size()) return kFew.at(degrees - 1);
  // The first terms of its expansion around the quantile of the normal distribution.
  constexpr double kNormal = 1.959964;
  const double n = static_cast<double>(degrees);
  const double z3 = std::pow(kNormal, 3);
  const double z5 = std::pow(kNormal, 5);
  const double z7 = std::pow(kNormal, 7);
  return kNormal + (z3 + kNormal) / (4 * n) + (5 * z5 + 16 * z3 + 3 * kNormal) / (96 * n * n) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * kNormal) / (384 * n * n * n);
}

Estimate estimate_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  const std::size_t count = values.size();
  if (count < 2) return {mean, 0, count};
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double deviation = std::sqrt(squares / static_cast<double>(count - 1));
  return {mean, student_quantile(count - 1) * deviation / std::sqrt(static_cast<double>(count)), count};
}

Estimate estimate_of_seeds(const std::map<std::uint64_t, std::vector<double>>& repeats) {
  if (repeats.size() == 1) return estimate_of(repeats.begin()->second);
  std::vector<double> means;
  for (const auto& [seed, values] : repeats) means.push_back(mean_of(values));
  return estimate_of(means);
}

}  // namespace kerf
