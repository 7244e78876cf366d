#include "core/geometry/denormal.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

#include "core/base/random.h"
#include "tests/hard/flush_to_zero.h"

namespace kerf::test {
namespace {

/// Zero, a denormal, or up to 2^-90, often one of a few.
Scalar small_number(Random& random) {
  constexpr std::array kFew{0.0F, 0x1p-149F, 0x1p-127F, 0x1p-126F, 0x1.fffffep-126F, 0x1p-101F, 0x1p-100F};
  const Scalar size = random.below(2) == 0 ? kFew[random.below(kFew.size())]
                                           : std::ldexp(static_cast<Scalar>(random.unit()),
                                                        -static_cast<int>(90 + random.below(60)));
  return random.below(2) == 0 ? size : -size;
}

TEST(Denormals, CountThoughTheProcessorTakesThemForZero) {
  Random random(5);
  for (int k = 0; k < 100000 && !testing::Test::HasFailure(); ++k) {
    const volatile Scalar a = small_number(random);
    const volatile double wide_a = a;
    volatile double widened = 0;
    {
      const FlushToZero flush(true);
      widened = wide(a);
    }
    EXPECT_EQ(std::bit_cast<std::uint64_t>(double{widened}), std::bit_cast<std::uint64_t>(double{wide_a}));
  }
}

}  // namespace
}  // namespace kerf::test
