#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace kerf {

/// Of values of which there is at least one.
double mean_of(const std::vector<double>& values);

/// A mean with its 95 % confidence interval, mean +- half (Student's t).
struct Estimate {
  double mean = 0;
  double half = 0;          ///< 0 of a single sample: nothing is known of its spread
  std::size_t samples = 0;  ///< that count as independent
};

/// Of independent values, of which there is at least one.
Estimate estimate_of(const std::vector<double>& values);

/// Of repeats by seed. Repeats of one seed see the same boxes and are not independent of each other: with
/// several seeds the mean of each seed is one sample, with one seed each repeat is.
Estimate estimate_of_seeds(const std::map<std::uint64_t, std::vector<double>>& repeats);

/// The 97.5 % quantile of Student's t with so many degrees of freedom, at least 1; within 0.1 %.
double student_quantile(std::size_t degrees);

}  // namespace kerf
