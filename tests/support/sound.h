#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "core/tree/validate.h"

namespace kerf::test {

/// For EXPECT_TRUE: the tree keeps every promise of `validate`, or the message lists those that it breaks.
template <int D>
testing::AssertionResult is_sound(const Tree<D>& tree) {
  constexpr std::size_t kShown = 10;
  const std::vector<Violation> violations = validate(tree);
  if (violations.empty()) return testing::AssertionSuccess();
  testing::AssertionResult result = testing::AssertionFailure() << violations.size() << " violations\n";
  for (std::size_t i = 0; i < std::min(violations.size(), kShown); ++i) {
    const NodeId node = violations[i].node;
    result << (node.is_none() ? "tree" : "n" + std::to_string(node.value)) << ": " << violations[i].what
           << "\n";
  }
  return result;
}

}  // namespace kerf::test
