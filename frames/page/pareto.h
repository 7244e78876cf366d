#pragma once

#include <vector>

namespace kerf {

/// A point of two things of which less is better: an error and a time.
struct Cost {
  double error = 0;
  double time = 0;
};

/// For each point whether it is on the Pareto front: none is better in one and as good in the other. Of equal
/// points all are on it.
std::vector<bool> pareto_front(const std::vector<Cost>& points);

}  // namespace kerf
