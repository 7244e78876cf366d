#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/kernels/byte_sweep.h"
#include "core/kernels/machine.h"
#include "tests/support/leaf_views.h"
#include "tests/support/pairs.h"

namespace kerf::test {

/// By every kernel, in one order. Returns the last one's sweep.
template <int D>
ByteSweep<D> expect_swept_alike(const LeafView<D>& leaf) {
  ByteSweep<D> sweep;
  std::vector<Pair> first;
  for (const std::string& name : kernels()) {
    use_kernel(name);
    PairBuffer found;
    sweep.find(leaf, found);
    const std::vector<Pair> pairs(found.all().begin(), found.all().end());
    EXPECT_EQ(difference(pairs, expected_pairs(leaf)), "") << name;
    if (name == kernels().front()) first = pairs;
    EXPECT_EQ(pairs, first) << name << " gives another order";
  }
  return sweep;
}

}  // namespace kerf::test
