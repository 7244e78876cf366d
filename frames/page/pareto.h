#pragma once

#include <vector>

namespace kerf {

/// A point with two costs, less is better: an error and a time.
struct Cost {
  double error = 0;
  double time = 0;
};

/// For each point whether it is on the Pareto front: no other is better in one cost and as good in the other.
/// Equal points are all on it.
std::vector<bool> pareto_front(const std::vector<Cost>& points);

}  // namespace kerf
