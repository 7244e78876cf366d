// HARD_CASES N5: calls of one tree may come from threads of which only some take denormals for zero, or round
// in another direction. Pairs are those of the boxes as they were given.

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cfenv>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/float_mode.h"
#include "core/base/random.h"
#include "core/bsp/bsp.h"
#include "core/replay/oracle.h"
#include "core/world/world.h"
#include "tests/hard/flush_to_zero.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

/// The floats of some caller.
class SomeFloats {
 public:
  explicit SomeFloats(Random& random) : flush_(random.below(2) == 0) {
    std::fesetround(std::array{FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}[random.below(4)]);
  }
  ~SomeFloats() { std::fesetround(FE_TONEAREST); }
  SomeFloats(const SomeFloats&) = delete;
  SomeFloats& operator=(const SomeFloats&) = delete;

 private:
  FlushToZero flush_;
};

/// The first few denormals, any of them, or an ordinary number.
Scalar draw_end(Random& random) {
  const std::uint32_t sign = random.below(2) << 31U;
  switch (random.below(6)) {
    case 0:
      return static_cast<Scalar>(random.uniform(-1, 1));
    case 1:
      return std::bit_cast<Scalar>(sign | (static_cast<std::uint32_t>(random.bits()) & 0x7FFFFFU));
    default:
      return std::bit_cast<Scalar>(sign | random.below(6));
  }
}

template <int D>
Box<D> draw_tiny_box(Random& random) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    box.min[i] = draw_end(random);
    box.max[i] = draw_end(random);
    if (box.max[i] < box.min[i]) std::swap(box.min[i], box.max[i]);
  }
  return box;
}

/// Leaves of few objects, with and without kept pairs.
Config config_of_few(bool keeps) {
  Config config = tuned_config();
  config.min_threshold = config.max_threshold = 8;
  config.schedule_interval = 1;
  if (!keeps) config.skin = 0;
  return config;
}

template <class T>
class FloatModes : public testing::Test {};
TYPED_TEST_SUITE(FloatModes, Dimensions, DimensionNames);

TYPED_TEST(FloatModes, PairsAreTheOraclesHoweverCallersCompute) {
  constexpr int kD = TypeParam::value;
  for (const std::uint32_t seed : {0U, 1U, 2U, 3U}) {
    Random random(seed);
    Random modes(seed + 10);
    Bsp<kD> tree(config_of_few(seed % 2 == 0));
    Bsp<kD> usual(config_of_few(seed % 2 == 0));
    for (std::uint32_t step = 0; step < 80; ++step) {
      for (std::uint32_t id = 0; id < 100; ++id) {
        Box<kD> box = draw_tiny_box<kD>(random);
        if (random.below(10) == 0) std::swap(box.min, box.max);  // no box then, perhaps by a denormal
        const std::uint32_t wish = step == 0 ? 0 : random.below(step % 20 < 10 ? 60 : 4);
        const auto ask = [&](Bsp<kD>& of) {
          if (wish == 0 && of.objects().state({id}) == ObjectState::absent)
            return of.insert({id}, box, Mobility::moving);
          return wish == 0 ? of.remove({id}) : wish == 1 ? of.move({id}, box) : Status::ok;
        };
        const Status status = ask(usual);
        const SomeFloats floats(modes);
        EXPECT_EQ(ask(tree), status);
      }
      const bool unswept = random.below(5) == 0;
      {
        const SomeFloats floats(modes);
        if (unswept) tree.step_unswept();
        tree.step();
      }
      ASSERT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "")
          << "seed " << seed << ", step " << step;
    }
  }
}

/// Boxes of all sizes of denormals, some with margins that are denormals.
TYPED_TEST(FloatModes, AWorldReportsTheSameHoweverCallersCompute) {
  constexpr int kD = TypeParam::value;
  Random random(5);
  Random modes(6);
  WorldOptions options;
  options.config = config_of_few(true);
  options.pairs_of = PairsOf::exact_boxes;
  World<kD> world(options);
  World<kD> usual(options);
  std::vector<Handle> objects;
  for (int id = 0; id < 100; ++id) {
    const Box<kD> box = draw_tiny_box<kD>(random);
    ObjectDef def;
    def.margin = id % 3 == 0 ? 0x1p-140F : 0;
    objects.push_back(usual.insert(box, def).handle);
    const SomeFloats floats(modes);
    (void)world.insert(box, def);
  }
  for (int step = 0; step < 80; ++step) {
    for (int k = 0; k < 10; ++k) {
      const Handle object = objects[random.below(100)];
      const Box<kD> box = draw_tiny_box<kD>(random);
      (void)usual.move(object, box);
      const SomeFloats floats(modes);
      (void)world.move(object, box);
    }
    usual.step();
    {
      const SomeFloats floats(modes);
      world.step();
    }
    const auto found = world.pairs();
    ASSERT_EQ(std::vector(found.begin(), found.end()),
              std::vector(usual.pairs().begin(), usual.pairs().end()))
        << "in step " << step;
    std::vector<std::uint8_t> bytes;
    ASSERT_EQ(world.save(bytes), WorldStatus::ok);
    const SomeFloats floats(modes);
    ASSERT_EQ(world.restore(bytes), WorldStatus::ok) << "in step " << step;
  }
}

TEST(DefaultFloats, EndAsTheCallerChose) {
  Random random(4);
  for (int k = 0; k < 40; ++k) {
    const SomeFloats floats(random);
    const volatile float least = 0x1p-126F;
    const volatile float third = 3;
    const auto look = [&] { return std::array<float, 3>{1 / third, -1 / third, least / 4}; };
    const auto bits_of = [](const std::array<float, 3>& numbers) {
      return std::bit_cast<std::array<std::uint32_t, 3>>(numbers);
    };
    const auto before = bits_of(look());
    {
      const DefaultFloats usual;
      EXPECT_EQ(bits_of(look()), bits_of({1.0F / 3, -1.0F / 3, 0x1p-128F}));
    }
    EXPECT_EQ(bits_of(look()), before);
  }
}

}  // namespace
}  // namespace kerf::test
