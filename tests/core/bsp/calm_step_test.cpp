// A step of a small world in which little or nothing moves does only what that asks for, if no trace sees it.
// Beside a tree that has a trace, and so takes every step in full, nothing else must differ, whatever is
// asked in between.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/bsp/bsp_state.h"
#include "core/replay/oracle.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

template <class T>
class CalmStep : public testing::Test {};
TYPED_TEST_SUITE(CalmStep, Dimensions, DimensionNames);

/// Two trees of one world: one may take short steps.
template <int D>
class Twins {
 public:
  explicit Twins(std::uint32_t count) : short_(tuned_config()), full_(tuned_config()) {
    for (std::uint32_t id = 0; id < count; ++id) insert({id});
  }
  void insert(ObjectId object) {
    const Box<D> box = random_box<D>(random_, 8, 1);
    of_both([&](auto& tree) { return tree.insert(object, box, Mobility::moving); });
  }
  void move(ObjectId object, double way) {
    if (!full_.objects().is_placed(object)) return;
    const Vector<D> by = random_point<D>(random_, -way, way);
    const Box<D> box{full_.objects().box(object).min + by, full_.objects().box(object).max + by};
    of_both([&](auto& tree) { return tree.move(object, box); });
  }
  void remove(ObjectId object) {
    of_both([&](auto& tree) { return tree.remove(object); });
  }
  void configure(const std::string& assignment) {
    of_both([&](auto& tree) {
      Config config = tree.config();
      kerf::apply(config, assignment);
      tree.set_config(config);
      return true;
    });
  }
  void restore() {
    of_both([&](auto& tree) {
      tree.restore(tree.state());
      return true;
    });
  }
  void give_pairs_away() {
    of_both([](auto& tree) {
      PairBuffer pairs;
      tree.exchange_pairs(pairs);
      return true;
    });
  }
  void step(bool unswept = false) {
    of_both([&](auto& tree) {
      unswept ? tree.step_unswept() : tree.step();
      return tree.statistics().placed;
    });
    const std::vector<Pair> expected = unswept ? std::vector<Pair>{} : oracle_pairs(full_.objects());
    ASSERT_EQ(difference(short_.pairs(), expected), "") << "in step " << full_.steps();
    ASSERT_EQ(difference(full_.pairs(), expected), "") << "in step " << full_.steps();
    ASSERT_EQ(look_at(short_), look_at(full_)) << "in step " << full_.steps();
  }
  [[nodiscard]] Bsp<D>& tree() { return short_; }

 private:
  template <class Tree>
  static auto look_at(const Tree& tree) {
    const auto state = tree.state();
    return std::tuple(state.hash(), state.modes.mode(), state.modes.memory(), tree.transition(), state.placed,
                      state.step);
  }
  template <class Ask>
  void of_both(const Ask& ask) {
    const auto first = ask(short_);
    EXPECT_EQ(first, ask(full_));
  }

  Random random_{11};
  Bsp<D> short_;
  Bsp<D, EventLog> full_;
};

TYPED_TEST(CalmStep, ShowsInNothingWhateverIsAskedInBetween) {
  Random random(3);
  for (const std::uint32_t count : {0U, 1U, 30U, 500U}) {
    Twins<TypeParam::value> twins(count);
    for (int step = 0; step < 400; ++step) {
      const ObjectId object{random.below(count + 2)};
      switch (random.below(24)) {
        case 0:
          twins.insert(object);
          break;
        case 1:
          twins.move(object, 0.5);
          break;
        case 2:
          twins.remove(object);
          break;
        case 3:
          twins.restore();
          break;
        case 4:
          twins.give_pairs_away();
          break;
        case 5:
          for (std::uint32_t id = 0; id < count; ++id) twins.move({id}, 0.01);
          break;
        case 6:
        case 7:
        case 8:
          for (std::uint32_t k = 0; k < 3; ++k) twins.move({random.below(count + 1)}, 0.3);
          break;
        default:
          break;
      }
      twins.step(random.below(20) == 0);
      ASSERT_FALSE(this->HasFatalFailure()) << count << " objects";
    }
  }
}

TYPED_TEST(CalmStep, EndsWithAnotherConfiguration) {
  Twins<TypeParam::value> twins(60);
  for (const char* assignment :
       {"rows=0", "rows=1", "skin=0", "skin=8", "min_threshold=8,max_threshold=8", "budget_divisor=0",
        "min_threshold=1024,max_threshold=1024", "budget_divisor=4", "byte_sweep=0", "byte_sweep=1",
        "bulk_factor=0.01", "bulk_factor=0", "bulk_factor=2", "skin=0", "byte_sweep=0", "skin=8",
        "byte_sweep=1"}) {
    twins.configure(assignment);
    for (std::uint32_t k = 0; k < 40; ++k) {
      if (k >= 20 && k < 30) twins.move({k % 3}, 0.5);
      twins.step();
      ASSERT_FALSE(this->HasFatalFailure()) << assignment;
    }
  }
}

/// The times of the phases are those of this step, not of an earlier one.
TYPED_TEST(CalmStep, IsTimedInFull) {
  Twins<TypeParam::value> twins(30);
  for (int k = 0; k < 20; ++k) twins.step();
  twins.tree().time_phases(true);
  twins.step();
  double sum = 0;
  for (const double seconds : twins.tree().statistics().phase_seconds) sum += seconds;
  EXPECT_GT(sum, 0);
}

}  // namespace
}  // namespace kerf::test
