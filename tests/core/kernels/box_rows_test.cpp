#include "core/kernels/box_rows.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/kernels/machine.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

using Limits = std::numeric_limits<double>;

/// Numbers whose floats are difficult, and any others.
double number(Random& random) {
  constexpr std::array<double, 14> kHard{
      0.0,  -0.0,  0x1p-149, 0x1p-150, 0x1.8p-149, 0x1p-1000,          1e-39,
      1e39, 1e300, 0x1p128,  16777217, 0.1,        0x1.fffffefffffp10, Limits::infinity()};
  const std::uint32_t kind = random.below(28);
  const double size =
      kind < kHard.size() ? kHard[kind] : std::ldexp(random.unit(), static_cast<int>(random.below(60)) - 30);
  return random.below(2) == 0 ? size : -size;
}

template <int D>
std::vector<double> boxes(std::size_t count, Random& random) {
  std::vector<double> rows(count * 2 * D);
  for (std::size_t k = 0; k < rows.size(); k += 2 * D) {
    for (std::size_t i = k; i < k + D; ++i) {
      const double a = number(random);
      const double b = number(random);
      rows[i] = std::min(a, b);
      rows[i + D] = std::max(a, b);
    }
  }
  return rows;
}

Scalar at_most(double number) {
  const auto near = static_cast<Scalar>(number);
  return static_cast<double>(near) > number ? std::nextafter(near, -std::numeric_limits<Scalar>::infinity())
                                            : near;
}

template <class Dimension>
class BoxRows : public testing::Test {
 protected:
  ~BoxRows() override { use_kernel(""); }
  Random random_{20261129};
};
TYPED_TEST_SUITE(BoxRows, Dimensions, DimensionNames);

TYPED_TEST(BoxRows, AreRoundedOutward) {
  constexpr int kD = TypeParam::value;
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    for (std::size_t count = 0; count < 40; ++count) {
      const std::vector<double> rows = boxes<kD>(count, this->random_);
      std::vector<Box<kD>> rounded(count);
      ASSERT_TRUE(round_boxes<kD>(rows.data(), count, rounded.data())) << kernel;
      for (std::size_t k = 0; k < count; ++k) {
        for (int i = 0; i < kD; ++i) {
          const double min = rows[k * 2 * kD + static_cast<std::size_t>(i)];
          const double max = rows[k * 2 * kD + static_cast<std::size_t>(kD + i)];
          ASSERT_EQ(rounded[k].min[i], at_most(min)) << kernel << ' ' << min;
          ASSERT_EQ(rounded[k].max[i], -at_most(-max)) << kernel << ' ' << max;
        }
      }
    }
  }
}

TYPED_TEST(BoxRows, ABadNumberIsFoundWhereverItIs) {
  constexpr int kD = TypeParam::value;
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    for (std::size_t count = 1; count < 20; ++count) {
      const std::vector<double> good(count * 2 * kD, 1.5);
      for (std::size_t k = 0; k < good.size(); ++k) {
        const double beyond = k % (2 * kD) < kD ? 2 : 1;  // a lower end above the upper one, or the other way
        for (const double bad : {beyond, Limits::quiet_NaN()}) {
          std::vector<double> rows = good;
          rows[k] = bad;
          const std::vector<float> floats(rows.begin(), rows.end());
          std::vector<Box<kD>> rounded(count);
          ASSERT_FALSE(are_boxes<kD>(floats.data(), count)) << kernel << ' ' << k << " of " << count;
          ASSERT_FALSE(are_boxes<kD>(rows.data(), count)) << kernel << ' ' << k << " of " << count;
          ASSERT_FALSE(round_boxes<kD>(rows.data(), count, rounded.data())) << kernel << ' ' << k;
        }
      }
    }
  }
}

TYPED_TEST(BoxRows, AnyBoxIsOne) {
  constexpr int kD = TypeParam::value;
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    for (std::size_t count = 0; count < 40; ++count) {
      const std::vector<double> rows = boxes<kD>(count, this->random_);
      const std::vector<float> floats(rows.begin(), rows.end());
      EXPECT_TRUE(are_boxes<kD>(rows.data(), count)) << kernel;
      EXPECT_TRUE(are_boxes<kD>(floats.data(), count)) << kernel;
    }
  }
}

}  // namespace
}  // namespace kerf::test
