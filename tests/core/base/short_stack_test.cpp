#include "core/base/short_stack.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace kerf {
namespace {

TEST(ShortStack, GivesBackTheLastFirst) {
  ShortStack<std::uint32_t> stack(0);
  for (std::uint32_t k = 1; k < 10; ++k) stack.push(k);
  for (std::uint32_t k = 10; k-- > 0;) {
    ASSERT_FALSE(stack.empty());
    EXPECT_EQ(stack.pop(), k);
  }
  EXPECT_TRUE(stack.empty());
}

/// As the tree of a damaged file asks for.
TEST(ShortStack, IsAsDeepAsItMustBe) {
  constexpr std::uint32_t kDeep = 1000;
  ShortStack<std::uint32_t> stack(0);
  for (std::uint32_t round = 0; round < 3; ++round) {
    for (std::uint32_t k = 1; k < kDeep; ++k) stack.push(k);
    for (std::uint32_t k = kDeep; k-- > 1;) ASSERT_EQ(stack.pop(), k);
  }
  EXPECT_EQ(stack.pop(), 0U);
  EXPECT_TRUE(stack.empty());
}

}  // namespace
}  // namespace kerf
