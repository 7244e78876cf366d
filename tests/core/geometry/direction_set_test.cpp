#include "core/geometry/direction_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/geometry/usual_directions.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

template <int D>
double cosine(const Vector<D>& a, const Vector<D>& b) {
  double product = 0;
  double aa = 0;
  double bb = 0;
  for (int i = 0; i < D; ++i) {
    product += double{a[i]} * double{b[i]};
    aa += double{a[i]} * double{a[i]};
    bb += double{b[i]} * double{b[i]};
  }
  return std::min(1.0, std::abs(product) / std::sqrt(aa * bb));
}

/// The smallest angle between two of the first `count` directions, taken as lines, in radians.
template <int D>
double smallest_angle(const DirectionSet<D>& set, std::uint32_t count) {
  double nearest = 0;
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t j = 0; j < i; ++j) nearest = std::max(nearest, cosine(set[i], set[j]));
  return std::acos(nearest);
}

/// The angle at which `count` lines would be if nothing were better spread: in 2D exactly, in 3D for a
/// hexagonal pattern, which no set can reach.
template <int D>
double ideal_angle(std::uint32_t count) {
  if (D == 2) return std::numbers::pi / count;
  return std::sqrt(4 * std::numbers::pi / (std::sqrt(3.0) * count));
}

/// FNV-1a of the bits of all components.
template <int D>
std::uint64_t bits_of(const DirectionSet<D>& set) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const Vector<D>& direction : set.all())
    for (const Scalar x : direction.value) hash = (hash ^ std::bit_cast<std::uint32_t>(x)) * 0x100000001b3U;
  return hash;
}

template <class T>
class Directions : public testing::Test {};
TYPED_TEST_SUITE(Directions, Dimensions, DimensionNames);

TYPED_TEST(Directions, BeginWithTheAxesExactly) {
  constexpr int kD = TypeParam::value;
  for (const std::uint32_t size : {kD + 0U, kD + 1U, 64U}) {
    const DirectionSet<kD> set(size, 1);
    EXPECT_EQ(set.size(), size);
    for (int axis = 0; axis < kD; ++axis)
      EXPECT_EQ(set[static_cast<std::uint32_t>(axis)], axis_vector<kD>(axis));
  }
}

TYPED_TEST(Directions, HaveLengthOneAndComponentsUpToOne) {
  constexpr int kD = TypeParam::value;
  const DirectionSet<kD> set(256, 1);
  for (const Vector<kD>& direction : set.all()) {
    double square = 0;
    for (const Scalar x : direction.value) {
      square += double{x} * double{x};
      EXPECT_LE(std::abs(x), 1.0F);
    }
    EXPECT_NEAR(square, 1, 4 * 0x1p-24);
  }
}

TYPED_TEST(Directions, LieInOneHemisphere) {
  constexpr int kD = TypeParam::value;
  const DirectionSet<kD> set(256, 1);
  for (const Vector<kD>& direction : set.all()) {
    int last = kD - 1;
    while (last > 0 && direction[last] == 0) --last;
    EXPECT_GT(direction[last], 0);
  }
}

TYPED_TEST(Directions, AreSpreadAlmostAsFarAsTheyCanBe) {
  constexpr int kD = TypeParam::value;
  for (const std::uint32_t size : {8U, 16U, 64U, 256U}) {
    const DirectionSet<kD> set(size, 1);
    EXPECT_GT(smallest_angle(set, size), 0.6 * ideal_angle<kD>(size)) << size;
  }
}

TYPED_TEST(Directions, AreSpreadInEveryPrefix) {
  constexpr int kD = TypeParam::value;
  const DirectionSet<kD> set(256, 1);
  for (const std::uint32_t count : {4U, 8U, 16U, 32U, 64U, 128U})
    EXPECT_GT(smallest_angle(set, count), 0.45 * ideal_angle<kD>(count)) << count;
}

TYPED_TEST(Directions, AreNeverNearlyEqualForAnySeedOrSize) {
  constexpr int kD = TypeParam::value;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::uint32_t size = kD + static_cast<std::uint32_t>(seed) * 4;
    EXPECT_GT(smallest_angle(DirectionSet<kD>(size, seed), size), 0.4 * ideal_angle<kD>(size)) << seed;
  }
}

TYPED_TEST(Directions, FollowTheSeed) {
  constexpr int kD = TypeParam::value;
  EXPECT_EQ(bits_of(DirectionSet<kD>(32, 5)), bits_of(DirectionSet<kD>(32, 5)));
  EXPECT_NE(bits_of(DirectionSet<kD>(32, 5)), bits_of(DirectionSet<kD>(32, 6)));
}

// A change of these numbers means that recordings made elsewhere no longer replay.
TYPED_TEST(Directions, AreTheSameBitsWithEveryCompiler) {
  constexpr int kD = TypeParam::value;
  EXPECT_EQ(bits_of(DirectionSet<kD>(64, 1)), kD == 2 ? 1033441152153935017U : 6088588942436226330U);
}

/// What is kept in the program is what repulsion finds, bit by bit. If repulsion was changed on purpose, the
/// message has the new rows of usual_directions.cpp.
TYPED_TEST(Directions, TheUsualOnesAreKept) {
  constexpr int kD = TypeParam::value;
  const std::vector<Vector<kD>> spread = spread_directions<kD>(kUsualDirections<kD>, kUsualSeed);
  std::ostringstream rows;
  rows << std::hexfloat;
  for (const Vector<kD>& direction : spread) {
    rows << "    {{";
    for (int i = 0; i < kD; ++i) rows << (i > 0 ? ", " : "") << direction[i] << 'F';
    rows << "}},\n";
  }
  EXPECT_TRUE(std::ranges::equal(spread, usual_directions<kD>())) << rows.str();
  EXPECT_TRUE(std::ranges::equal(DirectionSet<kD>(kUsualDirections<kD>, kUsualSeed).all(), spread));
}

/// A tree that is not asked for others has the usual ones.
TYPED_TEST(Directions, ATreeHasTheUsualOnes) {
  constexpr int kD = TypeParam::value;
  for (const Config& config : {Config(), tuned_config()}) {
    const Bsp<kD> tree(config);
    EXPECT_TRUE(std::ranges::equal(tree.tree().directions().all(), usual_directions<kD>()));
  }
}

TYPED_TEST(Directions, RefuseASizeThatCannotBe) {
  constexpr int kD = TypeParam::value;
  EXPECT_THROW(DirectionSet<kD>(0, 1), std::invalid_argument);
  EXPECT_THROW(DirectionSet<kD>(kD - 1, 1), std::invalid_argument);
  EXPECT_THROW(DirectionSet<kD>(4097, 1), std::invalid_argument);
  EXPECT_THROW(DirectionSet<kD>(0xFFFFFFFFU, 1), std::invalid_argument);
}

// HARD_CASES S11: the axes come first, the rest is kept bit by bit.
TYPED_TEST(Directions, CanBeGiven) {
  constexpr int kD = TypeParam::value;
  Vector<kD> nearly = axis_vector<kD>(0);
  nearly[kD - 1] = 1e-45F;
  const std::array<Vector<kD>, 3> given{nearly, axis_vector<kD>(1) * -0.25F, nearly};
  const DirectionSet<kD> set{std::span<const Vector<kD>>(given)};
  ASSERT_EQ(set.size(), kD + 3U);
  for (int axis = 0; axis < kD; ++axis)
    EXPECT_EQ(set[static_cast<std::uint32_t>(axis)], axis_vector<kD>(axis));
  for (std::uint32_t k = 0; k < given.size(); ++k) EXPECT_EQ(set[kD + k], given[k]);
}

// HARD_CASES S12.
TYPED_TEST(Directions, RefuseOneThatCannotDivide) {
  constexpr int kD = TypeParam::value;
  constexpr Scalar kNoNumber = std::numeric_limits<Scalar>::quiet_NaN();
  for (const Scalar bad : {Scalar{0}, kNoNumber, Scalar{1.0001F}, std::numeric_limits<Scalar>::infinity()}) {
    const std::array<Vector<kD>, 1> given{axis_vector<kD>(0) * bad};
    EXPECT_THROW(DirectionSet<kD>(std::span<const Vector<kD>>(given)), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace kerf::test
