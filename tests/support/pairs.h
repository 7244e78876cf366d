#pragma once

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "core/base/ids.h"

namespace kerf::test {

std::vector<Pair> sorted(std::span<const Pair> pairs);

/// The mistakes of `found`, in any order of either: pairs missed, pairs invented and pairs reported twice,
/// the first few of each by name. Empty if nothing.
std::string difference(std::span<const Pair> found, std::span<const Pair> expected);

/// For EXPECT_TRUE: fails with the text of `difference`.
testing::AssertionResult same_pairs(std::span<const Pair> found, std::span<const Pair> expected);

}  // namespace kerf::test
