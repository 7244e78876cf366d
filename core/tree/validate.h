#pragma once

#include <string>
#include <vector>

#include "core/tree/tree.h"

namespace kerf {

/// A broken invariant. `node` is where; none if it concerns the whole tree.
struct Violation {
  NodeId node;
  std::string what;
};

/// Checks every invariant of `Tree` between steps and returns the violations: empty means sound. Always
/// compiled. O(entries * height).
template <int D>
std::vector<Violation> validate(const Tree<D>& tree);

}  // namespace kerf
