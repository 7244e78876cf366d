#include "core/spatial/divide_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/random.h"

namespace kerf::test {
namespace {

using Objects = std::vector<CenteredObject<2>>;

/// Coordinates number 0 to `count` - 1 of an order that is hard for a choice of pivots.
using Coordinate = Scalar (*)(std::uint32_t k, std::uint32_t count, Random& random);
constexpr Coordinate kOrders[] = {
    [](std::uint32_t, std::uint32_t, Random& random) { return static_cast<Scalar>(random.uniform(-1, 1)); },
    [](std::uint32_t k, std::uint32_t, Random&) { return static_cast<Scalar>(k); },
    [](std::uint32_t k, std::uint32_t, Random&) { return -static_cast<Scalar>(k); },
    [](std::uint32_t k, std::uint32_t count, Random&) { return static_cast<Scalar>(std::min(k, count - k)); },
    [](std::uint32_t, std::uint32_t, Random&) { return 7.0F; },
    [](std::uint32_t, std::uint32_t, Random& random) { return random.below(2) == 0 ? 0.0F : 1.0F; },
    [](std::uint32_t, std::uint32_t, Random& random) { return random.below(2) == 0 ? -0.0F : 0.0F; },
    // Each object of which the first pivot is chosen is one of the least.
    [](std::uint32_t k, std::uint32_t count, Random&) {
      const std::uint32_t stride = std::max(count / 9, 1U);
      return static_cast<Scalar>(k % stride == stride / 2 ? k : 2 * count - k);
    },
    [](std::uint32_t k, std::uint32_t, Random&) {
      return k % 2 == 0 ? std::numeric_limits<Scalar>::max() : std::numeric_limits<Scalar>::lowest();
    },
};

Objects make_objects(std::uint32_t count, Coordinate order, std::uint64_t seed) {
  Random random(seed);
  Objects objects;
  for (std::uint32_t k = 0; k < count; ++k)
    objects.push_back({{{static_cast<Scalar>(random.uniform(0, 9)), order(k, count, random)}}, k});
  return objects;
}

/// By coordinate, -0 first, then by id.
bool comes_before(const CenteredObject<2>& a, const CenteredObject<2>& b) {
  const Scalar x = a.center[1];
  const Scalar y = b.center[1];
  if (x != y) return x < y;
  if (std::signbit(x) != std::signbit(y)) return std::signbit(x);
  return a.object < b.object;
}

/// The ids of a part, ascending.
std::vector<std::uint32_t> ids(std::span<const CenteredObject<2>> part) {
  std::vector<std::uint32_t> all;
  for (const CenteredObject<2>& object : part) all.push_back(object.object);
  std::ranges::sort(all);
  return all;
}

void expect_divided(const Objects& given, std::size_t count) {
  Objects sorted = given;
  std::ranges::sort(sorted, comes_before);
  Objects divided = given;
  divide_objects<2>(divided, count, 1);
  ASSERT_EQ(ids(std::span(divided).first(count)), ids(std::span(sorted).first(count)));
  ASSERT_EQ(ids(divided), ids(given));
}

TEST(DivideObjects, PutsTheLeastFirstWhateverTheOrder) {
  for (const Coordinate order : kOrders)
    for (const std::uint32_t size : {1U, 2U, 31U, 32U, 33U, 34U, 100U, 1001U}) {
      const Objects objects = make_objects(size, order, size);
      for (std::uint32_t part = 0; part < 16; ++part)
        ASSERT_NO_FATAL_FAILURE(expect_divided(objects, part * size / 16));
      ASSERT_NO_FATAL_FAILURE(expect_divided(objects, size - 1));
    }
}

TEST(DivideObjects, TheLongestAxisIsThatOfTheFarthestCentres) {
  const std::vector<CenteredObject<3>> objects = {{{{1, -5, 2}}, 0}, {{{3, 4, 2}}, 1}, {{{-4, 0, 2}}, 2}};
  EXPECT_EQ(longest_axis<3>(objects), 1);
  EXPECT_EQ(longest_axis<3>(std::span(objects).first(1)), 0);
}

}  // namespace
}  // namespace kerf::test
