#include "core/base/append_buffer.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace kerf::test {
namespace {

struct alignas(4) Plain {
  std::uint32_t number;
};
struct alignas(64) Aligned {
  std::uint32_t number;
};

template <class T>
class AppendBufferOf : public testing::Test {};
using Values = testing::Types<Plain, Aligned>;
TYPED_TEST_SUITE(AppendBufferOf, Values);

TYPED_TEST(AppendBufferOf, KeepsItsValuesWhileItGrows) {
  AppendBuffer<TypeParam> buffer;
  for (std::uint32_t k = 0; k < 100000; ++k) buffer.push_back({k});
  ASSERT_EQ(buffer.size(), 100000U);
  for (std::uint32_t k = 0; k < 100000; ++k) ASSERT_EQ(buffer.all()[k].number, k);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.all().data()) % alignof(TypeParam), 0U);
}

TYPED_TEST(AppendBufferOf, GivesRoomForAsManyAsAreReserved) {
  AppendBuffer<TypeParam> buffer;
  buffer.push_back({7});
  for (const std::size_t count : {1U, 10U, 5000U, 3U}) {
    TypeParam* const room = buffer.reserve(count);
    for (std::uint32_t k = 0; k < count; ++k) room[k] = {k};
    buffer.commit(count / 2);
  }
  EXPECT_EQ(buffer.size(), 1U + 0 + 5 + 2500 + 1);
  EXPECT_EQ(buffer.all().front().number, 7U);
  EXPECT_EQ(buffer.all()[1].number, 0U);
  EXPECT_EQ(buffer.all()[2505].number, 2499U);
}

TYPED_TEST(AppendBufferOf, ForgetsAndAppends) {
  AppendBuffer<TypeParam> buffer;
  AppendBuffer<TypeParam> other;
  for (std::uint32_t k = 0; k < 9; ++k) other.push_back({k});
  buffer.append(other.all());
  buffer.truncate(3);
  buffer.append(other.all());
  ASSERT_EQ(buffer.size(), 12U);
  EXPECT_EQ(buffer.all()[2].number, 2U);
  EXPECT_EQ(buffer.all()[3].number, 0U);
  buffer.clear();
  EXPECT_TRUE(buffer.all().empty());
}

}  // namespace
}  // namespace kerf::test
