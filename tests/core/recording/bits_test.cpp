#include "core/recording/bits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace kerf {
namespace {

TEST(Bits, NumbersOfAnyLengthComeBack) {
  Random random(1);
  std::vector<std::pair<std::uint32_t, unsigned>> numbers;
  for (int k = 0; k < 1000; ++k) {
    const unsigned bits = random.below(33);
    numbers.emplace_back(static_cast<std::uint32_t>(random.bits() & ((std::uint64_t{1} << bits) - 1)), bits);
  }
  BitWriter writer;
  std::size_t sum = 0;
  for (const auto& [number, bits] : numbers) {
    writer.put(number, bits);
    sum += bits;
  }
  const Bytes bytes = writer.take();
  EXPECT_EQ(bytes.size(), (sum + 7) / 8);
  BitReader reader(bytes);
  for (const auto& [number, bits] : numbers) EXPECT_EQ(reader.get(bits), number);
}

TEST(Bits, ReadingBeyondTheEndIsAnError) {
  BitWriter writer;
  writer.put(5, 3);
  const Bytes bytes = writer.take();
  BitReader reader(bytes);
  EXPECT_EQ(reader.get(8), 5U);
  EXPECT_THROW((void)reader.get(1), std::runtime_error);
}

TEST(Bytes, NumbersComeBack) {
  ByteWriter writer;
  for (const std::uint64_t x : {std::uint64_t{0}, std::uint64_t{127}, std::uint64_t{128}, UINT64_MAX})
    writer.varint(x);
  writer.f32(-0.0F);
  writer.u64(UINT64_MAX - 1);
  writer.text("abc");
  ByteReader reader(writer.bytes());
  for (const std::uint64_t x : {std::uint64_t{0}, std::uint64_t{127}, std::uint64_t{128}, UINT64_MAX})
    EXPECT_EQ(reader.varint(), x);
  EXPECT_TRUE(std::signbit(reader.f32()));
  EXPECT_EQ(reader.u64(), UINT64_MAX - 1);
  EXPECT_EQ(reader.blob().size(), 3U);
  EXPECT_TRUE(reader.empty());
  EXPECT_THROW((void)reader.u8(), std::runtime_error);
}

TEST(Bytes, AListCannotBeLongerThanWhatFollows) {
  ByteWriter writer;
  writer.varint(1000000);
  ByteReader reader(writer.bytes());
  EXPECT_THROW((void)reader.count(), std::runtime_error);
}

TEST(Bytes, ZigzagHasTheSignInTheLowestBit) {
  for (const std::int32_t x : {0, 1, -1, 1000, INT32_MAX, INT32_MIN}) EXPECT_EQ(unzigzag(zigzag(x)), x);
  EXPECT_EQ(zigzag(-1), 1U);
  EXPECT_EQ(zigzag(1), 2U);
}

}  // namespace
}  // namespace kerf
