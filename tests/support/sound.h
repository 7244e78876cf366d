#pragma once

#include <gtest/gtest.h>

#include "core/tree/validate.h"

namespace kerf::test {

/// For EXPECT_TRUE: the tree keeps every promise of `validate`, or the message lists those that it breaks.
template <int D>
testing::AssertionResult is_sound(const Tree<D>& tree) {
  const std::vector<Violation> violations = validate(tree);
  if (violations.empty()) return testing::AssertionSuccess();
  testing::AssertionResult result = testing::AssertionFailure();
  for (const Violation& violation : violations)
    result << (violation.node.is_none() ? "tree" : "n" + std::to_string(violation.node.value)) << ": "
           << violation.what << "\n";
  return result;
}

}  // namespace kerf::test
