#include "core/kernels/sort_found.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/base/sample_place.h"
#include "core/kernels/machine.h"

namespace kerf::test {
namespace {

/// Different ones; of hits every third t is 0.
std::vector<std::uint32_t> objects(std::size_t count, Random& random) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t k = 0; k < count; ++k) all.push_back(k * 5000 + random.below(5000));
  for (std::size_t k = count; k > 1; --k)
    std::swap(all[k - 1], all[random.below(static_cast<std::uint32_t>(k))]);
  return all;
}
std::vector<std::uint64_t> hits(std::size_t count, Random& random) {
  std::vector<std::uint64_t> all;
  for (const std::uint32_t object : objects(count, random)) {
    const auto t = random.below(3) == 0 ? 0.0F : static_cast<float>(random.unit());
    all.push_back(std::uint64_t{std::bit_cast<std::uint32_t>(t)} << 32U | object);
  }
  return all;
}

template <class Number>
void expect_sorted(std::vector<Number> numbers) {
  std::vector<Number> sorted = numbers;
  std::ranges::sort(sorted);
  sort_found(numbers);
  EXPECT_EQ(numbers, sorted);
}

TEST(SortFound, AnyNumberByEveryKernel) {
  Random random(1);
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    for (std::size_t count = 0; count < 200; ++count) {
      expect_sorted(objects(count, random));
      expect_sorted(hits(count, random));
      ASSERT_FALSE(testing::Test::HasFailure()) << kernel << ", " << count;
    }
  }
  use_kernel("");
}

/// Many are divided by samples, in the last case by the least of all.
TEST(SortFound, ManyInAnyOrder) {
  Random random(2);
  for (const std::size_t count : {97U, 130U, 193U, 400U, 700U, 1023U, 1024U, 1025U, 3000U}) {
    std::vector<std::uint32_t> numbers = objects(count, random);
    expect_sorted(numbers);
    expect_sorted(hits(count, random));
    std::ranges::sort(numbers);
    expect_sorted(numbers);
    std::rotate(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count / 3), numbers.end());
    expect_sorted(numbers);
    std::ranges::sort(numbers, std::greater());
    expect_sorted(numbers);
    std::ranges::sort(numbers);
    for (std::uint32_t k = 0; k < 9; ++k) std::swap(numbers[k], numbers[sample_place(k, count)]);
    expect_sorted(numbers);
    ASSERT_FALSE(testing::Test::HasFailure()) << count;
  }
}

}  // namespace
}  // namespace kerf::test
