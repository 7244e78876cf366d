// The pairs of small worlds are kept as rows of bits: by themselves, and in a tree that turns to them and
// from them as its world changes.

#include "core/bsp/pair_bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "core/base/tuning.h"
#include "core/bsp/bsp.h"
#include "core/bsp/bsp_state.h"
#include "core/replay/oracle.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/every_kernel.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

/// Boxes of which many touch: their ends lie on a grid. `least`: the least extent.
template <int D>
Box<D> draw_box(Random& random, std::uint32_t cells, Scalar least = 0) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    box.min[i] = static_cast<Scalar>(random.below(cells));
    box.max[i] = box.min[i] + least + static_cast<Scalar>(random.below(2));
  }
  return box;
}

template <class T>
class PairBitsOfTable : public EveryKernel<T> {};
TYPED_TEST_SUITE(PairBitsOfTable, Dimensions, DimensionNames);

/// Moves, removes, inserts or quarantines an object.
template <int D>
void change(ObjectTable<D>& table, ObjectId object, Random& random) {
  const Mobility mobility = random.below(3) == 0 ? Mobility::fixed : Mobility::moving;
  Box<D> box = draw_box<D>(random, 6);
  if (random.below(8) == 0) box.min[0] = std::numeric_limits<Scalar>::quiet_NaN();
  if (table.state(object) == ObjectState::absent) {
    (void)table.insert(object, box, mobility);
  } else if (random.below(4) == 0) {
    (void)table.remove(object);
  } else {
    (void)table.move(object, box);
  }
}

template <int D>
std::vector<ObjectId> change_some(ObjectTable<D>& table, Random& random) {
  const auto bound = static_cast<std::uint32_t>(table.bound());
  std::vector<ObjectId> changed;
  for (std::uint32_t k = random.below(6); k > 0; --k) {
    const ObjectId object{random.below(bound)};
    if (std::ranges::find(changed, object) == changed.end()) changed.push_back(object);
    change(table, object, random);
  }
  return changed;
}

template <int D>
std::vector<ObjectId> all_there(const ObjectTable<D>& table) {
  std::vector<ObjectId> all;
  for (std::uint32_t id = 0; id < table.bound(); ++id)
    if (table.state({id}) != ObjectState::absent) all.push_back({id});
  return all;
}

/// All that are there, in the order of their ids; some of them go.
template <int D>
std::vector<ObjectId> change_all(ObjectTable<D>& table, Random& random) {
  std::vector<ObjectId> changed = all_there(table);
  for (const ObjectId object : changed) {
    (void)table.move(object, draw_box<D>(random, 6));
    if (random.below(16) == 0) (void)table.remove(object);
  }
  return changed;
}

/// The same without the first or the last, or with the last one in the place of the first.
template <int D>
std::vector<ObjectId> change_nearly_all(ObjectTable<D>& table, Random& random) {
  std::vector<ObjectId> changed = all_there(table);
  if (changed.size() < 2) return {};
  const std::uint32_t way = random.below(3);
  if (way == 0) changed.erase(changed.begin());
  if (way == 1) changed.pop_back();
  if (way == 2) changed.front() = changed.back();
  for (const ObjectId object : changed) (void)table.move(object, draw_box<D>(random, 6));
  return changed;
}

template <int D>
void change_and_compare(std::uint32_t count) {
  Random random(count);
  ObjectTable<D> table;
  for (std::uint32_t id = 0; id < count; ++id)
    (void)table.insert({id}, draw_box<D>(random, 6), id % 5 == 0 ? Mobility::fixed : Mobility::moving);
  PairBits<D> bits;
  EXPECT_FALSE(bits.have_room(table));
  PairBuffer pairs;
  pairs.append(oracle_pairs(table));
  bits.take(table, pairs.all());
  ASSERT_TRUE(bits.have_room(table));
  for (int step = 0; step < 100; ++step) {
    bits.expect_changes(step % 5 == 3   ? change_all(table, random)
                        : step % 5 == 4 ? change_nearly_all(table, random)
                                        : change_some(table, random));
    if (step % 10 == 9) pairs.clear();  // the list was given away
    bits.find(table, pairs);
    ASSERT_EQ(difference(pairs.all(), oracle_pairs(table)), "") << "in step " << step;
  }
}

TYPED_TEST(PairBitsOfTable, AreTheOraclesWhateverComesGoesAndMoves) {
  constexpr int kD = TypeParam::value;
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    for (const std::uint32_t count : {1U, 2U, 7U, 8U, 9U, 63U, 64U, 65U, 130U}) {
      SCOPED_TRACE(testing::Message() << kernel << ", " << count << " objects");
      change_and_compare<kD>(count);
      ASSERT_FALSE(this->HasFatalFailure());
    }
  }
}

TYPED_TEST(PairBitsOfTable, NeedRoomForEachObject) {
  ObjectTable<TypeParam::value> table;
  PairBits<TypeParam::value> bits;
  Random random(1);
  for (std::uint32_t id = 0; id < kBlockWidth; ++id)
    (void)table.insert({id}, draw_box<TypeParam::value>(random, 6), Mobility::moving);
  bits.take(table, oracle_pairs(table));
  EXPECT_TRUE(bits.have_room(table));
  (void)table.insert({kBlockWidth}, draw_box<TypeParam::value>(random, 6), Mobility::moving);
  EXPECT_FALSE(bits.have_room(table));
}

/// A small world in a tuned tree, whose steps are compared with the oracle's.
template <int D>
class SmallWorld {
 public:
  explicit SmallWorld(std::uint32_t count, const Config& config = tuned_config()) : tree_(config) {
    for (std::uint32_t id = 0; id < count; ++id) insert(id);
  }
  void insert(std::uint32_t id) {
    if (boxes_.size() <= id) boxes_.resize(id + 1);
    boxes_[id] = draw_box<D>(random_, 8, 1);
    EXPECT_EQ(tree_.insert({id}, boxes_[id], id % 7 == 0 ? Mobility::fixed : Mobility::moving), Status::ok);
  }
  void move(std::uint32_t first, std::uint32_t count, double way) {
    for (std::uint32_t id = first; id < first + count; ++id) {
      const Vector<D> by = random_point<D>(random_, -way, way);
      boxes_[id] = {boxes_[id].min + by, boxes_[id].max + by};
      (void)tree_.move({id}, boxes_[id]);
    }
  }
  void step() {
    tree_.step();
    ASSERT_EQ(difference(tree_.pairs(), oracle_pairs(tree_.objects())), "") << "in step " << tree_.steps();
  }
  [[nodiscard]] Bsp<D>& tree() { return tree_; }

 private:
  Random random_{9};
  Bsp<D> tree_;
  std::vector<Box<D>> boxes_;
};

template <class T>
class PairBitsOfTree : public testing::Test {};
TYPED_TEST_SUITE(PairBitsOfTree, Dimensions, DimensionNames);

TYPED_TEST(PairBitsOfTree, WorldsThatRestMoveALittleOrAllAtOnceHaveTheOraclesPairs) {
  for (const std::uint32_t count : {3U, 20U, 60U, 200U, 500U}) {
    SmallWorld<TypeParam::value> world(count);
    for (std::uint32_t step = 0; step < 120; ++step) {
      const std::uint32_t some = step % 40 < 20 ? 1 + step % 2 : count;
      world.move(step % (count - some + 1), some, step % 3 == 0 ? 2 : 0.01);
      if (step % 30 == 11) world.tree().step_unswept();
      world.step();
      ASSERT_FALSE(this->HasFatalFailure());
    }
  }
}

TYPED_TEST(PairBitsOfTree, ObjectsComeAndGoBeyondTheMostThatHaveRows) {
  SmallWorld<TypeParam::value> world(500);
  for (std::uint32_t id = 500; id < tuning::kMostRows + 20; ++id) {
    world.insert(id);
    if (id % 3 == 0) {
      ASSERT_EQ(world.tree().remove({id - 1}), Status::ok);
    }
    world.step();
    ASSERT_FALSE(this->HasFatalFailure());
  }
}

TYPED_TEST(PairBitsOfTree, ARestoredWorldDoesNotTrustTheListThatCameWithIt) {
  SmallWorld<TypeParam::value> world(40);
  SmallWorld<TypeParam::value> other(40);
  other.move(0, 40, 3);
  for (int k = 0; k < 10; ++k) {
    world.step();
    other.step();
  }
  BspState<TypeParam::value> state = world.tree().state();
  ASSERT_FALSE(state.pairs.empty());
  state.pairs.pop_back();
  other.tree().restore(state);
  other.step();
}

/// A state from before there were fixed objects says that none is.
TYPED_TEST(PairBitsOfTree, ARestoredWorldHasTheFixedObjectsOfItsState) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> tree(tuned_config());
  const auto box_of = [](std::uint32_t id) {
    return box_at(all<kD>(static_cast<Scalar>(10 * id)), Scalar{1});
  };
  for (std::uint32_t id = 0; id < 4; ++id) (void)tree.insert({id}, box_of(id), Mobility::moving);
  tree.step();
  const BspState<kD> state = tree.state();
  (void)tree.remove({1});
  (void)tree.insert({1}, box_of(1), Mobility::fixed);
  tree.step();
  tree.restore(state);
  tree.step();
  (void)tree.insert({4}, box_of(1), Mobility::fixed);
  tree.step();
  EXPECT_EQ(difference(tree.pairs(), std::vector<Pair>{{{1}, {4}}}), "");
}

/// What one step of a run shows of it.
struct Shown {
  std::vector<Event> events;
  std::uint64_t hash = 0;
  std::uint64_t placed = 0;
  Mode mode = Mode::ordered;
  friend bool operator==(const Shown&, const Shown&) = default;
};

/// A small world that first rests and then goes through all that decides how its pairs are found.
template <int D>
class Seeker {
 public:
  Seeker() : tree_(tuned_config()) {
    for (std::uint32_t id = 0; id < 20; ++id) (void)tree_.insert({id}, draw(), Mobility::moving);
  }
  Shown step(bool unswept) {
    const std::uint32_t number = tree_.steps();
    for (std::uint32_t id = 0; id < (number % 12 < 6 ? 1U + number % 3 : 20U); ++id)
      (void)tree_.move({id}, draw());
    (void)tree_.move({77}, draw());  // there is none
    if (number % 10 == 9) (void)tree_.remove({5});
    if (number % 10 == 2 && number > 9) (void)tree_.insert({5}, draw(), Mobility::moving);
    unswept ? tree_.step_unswept() : tree_.step();
    if (!unswept) {
      EXPECT_EQ(difference(tree_.pairs(), oracle_pairs(tree_.objects())), "");
    }
    return {tree_.trace().take(), tree_.state_hash(), tree_.statistics().placed, tree_.mode()};
  }
  void seek() { tree_.restore(tree_.state()); }

 private:
  Box<D> draw() { return draw_box<D>(random_, 8, 1); }

  Random random_{4};
  Bsp<D, EventLog> tree_;
};

/// A debugger goes on from a keyframe, and passes over steps without their pairs.
TYPED_TEST(PairBitsOfTree, ShowTheSameStepsWhereverARunGoesOn) {
  Seeker<TypeParam::value> whole;
  Seeker<TypeParam::value> sought;
  Seeker<TypeParam::value> skipping;
  for (int step = 0; step < 80; ++step) {
    const Shown shown = whole.step(false);
    if (step % 3 == 2) sought.seek();
    ASSERT_EQ(sought.step(false), shown) << "from the state before step " << step + 1;
    ASSERT_EQ(skipping.step(step % 3 != 0), shown) << "without pairs in step " << step + 1;
  }
}

/// The recording of a run has no requests for objects that are not there.
TYPED_TEST(PairBitsOfTree, WhatIsRefusedDecidesNothing) {
  SmallWorld<TypeParam::value> world(60);
  const std::vector<ObjectId> unknown(400, ObjectId{1000});
  const std::vector<Box<TypeParam::value>> boxes(unknown.size(), slab<TypeParam::value>(0, 1));
  for (int k = 0; k < 40; ++k) {
    if (k > 2) {
      EXPECT_EQ(world.tree().move_many(unknown, boxes), Status::unknown_id);
    }
    world.move(0, k > 2 ? 2 : 60, 0.001);
    world.step();
  }
  EXPECT_EQ(world.tree().mode(), Mode::swept) << "it has rows";
}

TYPED_TEST(PairBitsOfTree, AParameterMayChangeInBetween) {
  SmallWorld<TypeParam::value> world(60);
  for (const char* assignment : {"rows=0", "rows=1", "min_threshold=8,max_threshold=8", "byte_sweep=0",
                                 "byte_sweep=1,min_threshold=1024,max_threshold=1024"}) {
    Config config = world.tree().config();
    apply(config, assignment);
    world.tree().set_config(config);
    for (std::uint32_t k = 0; k < 20; ++k) {
      world.move(k, 2, 0.5);
      world.step();
      ASSERT_FALSE(this->HasFatalFailure()) << assignment;
    }
  }
}

/// One whose pairs are bits has no fat boxes; one that would keep pairs has.
TYPED_TEST(PairBitsOfTree, AreWhatASmallWorldHasInWhichLittleMoves) {
  for (const auto& [count, moved, mode] : {std::tuple{60U, 2U, Mode::swept},
                                           {60U, 60U, Mode::kept},
                                           {400U, 1U, Mode::swept},
                                           {400U, 20U, Mode::kept},
                                           {600U, 1U, Mode::kept}}) {
    SmallWorld<TypeParam::value> world(count);
    for (std::uint32_t k = 0; k < 40; ++k) {
      world.move(0, moved, 0.001);
      world.step();
    }
    EXPECT_EQ(world.tree().mode(), mode) << moved << " of " << count;
  }
}

}  // namespace
}  // namespace kerf::test
