#pragma once

#include <gtest/gtest.h>

#include "core/kernels/machine.h"

namespace kerf::test {

/// Tests that go through the machine's kernels by `use_kernel`: afterwards the best one is in use again.
template <class T>
class EveryKernel : public testing::Test {
 protected:
  void TearDown() override { use_kernel(""); }
};

}  // namespace kerf::test
