#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace kerf::test {

template <int D>
using Dimension = std::integral_constant<int, D>;

/// For TYPED_TEST_SUITE(Split, Dimensions, DimensionNames): the tests are called Split/2D and Split/3D.
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;

struct DimensionNames {
  template <class T>
  static std::string GetName(int /*index*/) {  // NOLINT(readability-identifier-naming): GoogleTest's name
    return std::to_string(T::value) + "D";
  }
};

}  // namespace kerf::test
