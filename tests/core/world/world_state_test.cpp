#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/random.h"
#include "core/tree/validate.h"
#include "core/world/seal.h"
#include "core/world/world.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

std::vector<WorldPair> list(std::span<const WorldPair> pairs) { return {pairs.begin(), pairs.end()}; }

/// Objects that come, move and go, the same for the same seed.
template <int D>
class Crowd {
 public:
  explicit Crowd(std::uint64_t seed) : random_(seed) {}

  void step(World<D>& world) {
    for (int k = 0; k < 4; ++k) {
      ObjectDef def;
      def.kind = static_cast<ObjectKind>(random_.below(kObjectKinds));
      def.margin = random_.below(3) == 0 ? 0.25F : 0;
      def.filter.group = static_cast<std::int32_t>(random_.below(3)) - 1;
      def.user_data = random_.below(100);
      handles_.push_back(world.insert(random_box<D>(random_, 10, 1), def).handle);
    }
    for (const Handle handle : handles_)
      if (random_.below(2) == 0) (void)world.move(handle, random_box<D>(random_, 10, 1));
    if (handles_.size() > 60) {
      EXPECT_EQ(world.remove(handles_[20]), WorldStatus::ok);
      handles_.erase(handles_.begin() + 20);
    }
    world.step();
  }

 private:
  Random random_;
  std::vector<Handle> handles_;
};

template <int D>
Bytes saved(const World<D>& world) {
  Bytes bytes;
  EXPECT_EQ(world.save(bytes), WorldStatus::ok);
  return bytes;
}

template <int D>
Bytes saved_crowd(int steps) {
  World<D> world;
  Crowd<D> crowd(5);
  for (int step = 0; step < steps; ++step) crowd.step(world);
  return saved(world);
}

void reseal(Bytes& bytes) {
  constexpr std::size_t kSeal = 8;
  ByteWriter seal;
  seal.u64(seal_of(std::span(bytes).first(bytes.size() - kSeal)));
  std::copy(seal.bytes().begin(), seal.bytes().end(), bytes.end() - kSeal);
}

template <class T>
class WorldState : public testing::Test {};
TYPED_TEST_SUITE(WorldState, Dimensions, DimensionNames);

TYPED_TEST(WorldState, ARestoredWorldGoesOnAsTheOther) {
  constexpr int kD = TypeParam::value;
  World<kD> world({.tag = 7});
  Crowd<kD> crowd(1);
  for (int step = 0; step < 40; ++step) crowd.step(world);
  World<kD> other({.threads = 2, .sharing = Sharing::always});
  std::string why;
  ASSERT_EQ(other.restore(saved(world), &why), WorldStatus::ok) << why;
  Crowd<kD> same = crowd;
  for (int step = 0; step < 40; ++step) {
    EXPECT_EQ(list(other.pairs()), list(world.pairs()));
    EXPECT_EQ(list(other.begun()), list(world.begun()));
    EXPECT_EQ(list(other.ended()), list(world.ended()));
    ASSERT_EQ(other.tree().state_hash(), world.tree().state_hash()) << "step " << step;
    ASSERT_EQ(saved(other), saved(world)) << "step " << step;
    crowd.step(world);
    same.step(other);
  }
}

TYPED_TEST(WorldState, AnEmptyWorldIsRestored) {
  constexpr int kD = TypeParam::value;
  World<kD> world;
  World<kD> other;
  EXPECT_EQ(other.restore(saved(world)), WorldStatus::ok);
  EXPECT_FALSE(other.insert(box_at<kD>({}, 1)).handle.is_none());
}

TYPED_TEST(WorldState, IsNotTakenBetweenARequestAndItsStep) {
  constexpr int kD = TypeParam::value;
  World<kD> world;
  const Handle handle = world.insert(box_at<kD>({}, 1)).handle;
  Bytes bytes{1, 2, 3};
  EXPECT_EQ(world.save(bytes), WorldStatus::unstepped);
  EXPECT_EQ(bytes.size(), 3U);
  world.step();
  EXPECT_EQ(world.save(bytes), WorldStatus::ok);
  EXPECT_EQ(world.set_filter(handle, {2, 2, 0}), WorldStatus::ok);
  EXPECT_EQ(world.save(bytes), WorldStatus::unstepped);
  world.step();
  EXPECT_EQ(world.set_user_data(handle, 9), WorldStatus::ok);
  EXPECT_EQ(world.save(bytes), WorldStatus::ok) << "no step does anything with user data";
  World<kD> other;
  EXPECT_EQ(other.restore(bytes), WorldStatus::ok);
  EXPECT_EQ(other.find(handle)->user_data, 9U);
}

TYPED_TEST(WorldState, IsTakenAfterRequestsOfNothing) {
  constexpr int kD = TypeParam::value;
  World<kD> world;
  Bytes bytes;
  EXPECT_EQ(world.shift_origin(all<kD>(1)), WorldStatus::ok);
  EXPECT_EQ(world.save(bytes), WorldStatus::ok);
  (void)world.insert(box_at<kD>({}, 1));
  world.step();
  const std::vector<Box<kD>> no_boxes;
  const std::vector<Handle> no_handles;
  EXPECT_EQ(world.move(no_handles, no_boxes), WorldStatus::ok);
  EXPECT_EQ(world.save(bytes), WorldStatus::ok);
}

TYPED_TEST(WorldState, ChangedAndCutBytesAreRefused) {
  constexpr int kD = TypeParam::value;
  const Bytes bytes = saved_crowd<kD>(4);
  World<kD> world;
  (void)world.insert(box_at<kD>({}, 1));
  world.step();
  const Bytes before = saved(world);
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    Bytes changed = bytes;
    changed[k] ^= static_cast<std::uint8_t>(1U << (k % 8));
    std::string why;
    ASSERT_EQ(world.restore(changed, &why), WorldStatus::damaged) << "byte " << k;
    ASSERT_GT(why.size(), 40U);
    ASSERT_EQ(world.restore(std::span(bytes).first(k)), WorldStatus::damaged) << "cut to " << k;
  }
  EXPECT_EQ(saved(world), before) << "a refusal changes nothing";
}

TYPED_TEST(WorldState, TheMessageSaysWhatIsWrong) {
  constexpr int kD = TypeParam::value;
  World<kD> world;
  const auto why = [&](const Bytes& bytes) {
    std::string text;
    EXPECT_EQ(world.restore(bytes, &text), WorldStatus::damaged);
    return text;
  };
  const Bytes bytes = saved_crowd<kD>(2);
  Bytes later = bytes;
  later[4] = 2;
  EXPECT_NE(why(later).find("has version 2, and this Kerf reads version 1"), std::string::npos) << why(later);
  EXPECT_NE(why(saved_crowd<5 - kD>(2)).find("dimensions"), std::string::npos);
  EXPECT_NE(why(Bytes(100)).find("no world's"), std::string::npos);
  EXPECT_NE(why({}).find("too few"), std::string::npos);
  Bytes changed = bytes;
  changed[bytes.size() / 2] ^= 1U;
  EXPECT_NE(why(changed).find("checksum"), std::string::npos);
}

/// Three objects, of which the first two touch, and are a pair that began.
template <int D>
class SmallState {
 public:
  SmallState() {
    for (const Scalar corner : {0.0F, 1.0F, 50.0F})
      handles_.push_back(world_.insert({all<D>(corner), all<D>(corner + 1)}, {}).handle);
    world_.step();
    bytes_ = saved(world_);
    ByteWriter pair;
    pair.u64(handles_[0].value);
    pair.u64(handles_[1].value);
    for (auto at = bytes_.begin();; ++at) {
      at = std::search(at, bytes_.end(), pair.bytes().begin(), pair.bytes().end());
      if (at == bytes_.end()) break;
      places_.push_back(static_cast<std::size_t>(at - bytes_.begin()));
    }
    places_.erase(places_.begin());  // where handles are listed
  }
  /// What restoring says with other bytes in the first `lists` lists: those of the pairs and of what began.
  std::string with(std::size_t offset, std::initializer_list<std::size_t> lists, std::uint64_t value,
                   std::size_t size) {
    Bytes lying = bytes_;
    for (const std::size_t list : lists)
      for (std::size_t k = 0; k < size; ++k)
        lying[places_.at(list) + offset + k] = static_cast<std::uint8_t>(value >> 8U * k);
    reseal(lying);
    std::string why;
    (void)World<D>().restore(lying, &why);
    return why;
  }
  [[nodiscard]] Handle third() const { return handles_[2]; }

 private:
  World<D> world_;
  std::vector<Handle> handles_;
  Bytes bytes_;
  std::vector<std::size_t> places_;
};

TYPED_TEST(WorldState, ReportsMustBeThoseOfTheObjects) {
  SmallState<TypeParam::value> state;
  EXPECT_EQ(state.with(0, {}, 0, 0), "") << "it is a state";
  const std::uint64_t third = state.third().value;
  EXPECT_NE(state.with(8, {0, 1}, third, 8).find("a pair is none of its objects"), std::string::npos);
  EXPECT_NE(state.with(8, {1}, third, 8).find("a pair began that is none"), std::string::npos);
  EXPECT_NE(state.with(16, {0, 1}, 1, 1).find("a pair is none of its objects"), std::string::npos)
      << "none of them is a sensor";
}

/// Bytes that lie and have a fitting checksum: whatever is taken is a world that works.
TYPED_TEST(WorldState, SealedLiesDoNoHarm) {
  constexpr int kD = TypeParam::value;
  const Bytes bytes = saved_crowd<kD>(6);
  Random random(3);
  int refused = 0;
  constexpr int kCases = 3000;
  for (int k = 0; k < kCases; ++k) {
    Bytes lying = bytes;
    for (std::uint32_t change = 0; change <= random.below(3); ++change)
      lying[6 + random.below(static_cast<std::uint32_t>(bytes.size()) - 6)] =
          static_cast<std::uint8_t>(random.below(2) == 0 ? random.below(256) : 255);
    reseal(lying);
    World<kD> world;
    if (world.restore(lying) != WorldStatus::ok) {
      ++refused;
      continue;
    }
    Crowd<kD> crowd(9);
    for (int step = 0; step < 3; ++step) crowd.step(world);
    ASSERT_TRUE(validate(world.tree().tree()).empty()) << "case " << k;
    for (const WorldPair& pair : world.pairs()) ASSERT_TRUE(world.contains(pair.a) && world.contains(pair.b));
  }
  EXPECT_GT(refused, kCases / 4);
  EXPECT_LT(refused, kCases);
}

}  // namespace
}  // namespace kerf::test
