// A tree is driven through each transition of the table of modes, and docs/MODES.md has the same table and
// the same diagram as the code.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "core/base/tuning.h"
#include "core/bsp/bsp.h"
#include "core/replay/oracle.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

/// A crowd of cubes in a tuned tree, whose steps are compared with the oracle's.
template <int D>
class Drive {
 public:
  explicit Drive(std::uint32_t count = 600) : count_(count), tree_(tuned()) {
    const double side = 1.5 * std::pow(count, 1.0 / D);
    for (std::uint32_t id = 0; id < count; ++id) {
      const Vector<D> low = random_point<D>(random_, 0, side);
      boxes_.push_back({low, low + random_point<D>(random_, 1, 1)});
      EXPECT_EQ(tree_.insert({id}, boxes_.back(), Mobility::moving), Status::ok);
    }
  }
  /// Each object between two shares of all goes up to `way` along each axis, in any direction.
  void shake(double from, double to, double way) {
    for (auto id = static_cast<std::uint32_t>(from * count_); id < to * count_; ++id) {
      const Vector<D> by = random_point<D>(random_, -way, way);
      boxes_[id] = {boxes_[id].min + by, boxes_[id].max + by};
      EXPECT_EQ(tree_.move({id}, boxes_[id]), Status::ok);
    }
  }
  void step() {
    tree_.step();
    ASSERT_EQ(difference(tree_.pairs(), oracle_pairs(tree_.objects())), "") << "in step " << tree_.steps();
  }
  void rest(int steps) {
    for (int k = 0; k < steps; ++k) step();
  }
  void set(const char* parameter, const char* value) {
    Config config = tree_.config();
    kerf::set(config, parameter, value);
    tree_.set_config(config);
  }
  /// The first two steps of objects that stand still, or nearly, where bits would do for so few.
  void begin_keeping() {
    for (int k = 0; k < 2; ++k) {
      if (count_ <= tuning::kMostRows) shake(0, 1, 0.001);
      step();
    }
    ASSERT_EQ(tree_.mode(), Mode::kept);
  }
  [[nodiscard]] const Bsp<D>& tree() const { return tree_; }

 private:
  static Config tuned() {
    Config config = tuned_config();
    config.min_threshold = config.max_threshold = 64;
    return config;
  }

  std::uint32_t count_;
  Random random_{5};
  Bsp<D> tree_;
  std::vector<Box<D>> boxes_;
};

/// Brings a new tree to the step before which the transition is due, and does that step.
template <int D>
void go_through(const Transition& transition, Drive<D>& drive) {
  const auto was_kept = transition.from == Mode::kept;
  if (was_kept) drive.begin_keeping();
  switch (transition.condition) {
    case Condition::bytes_on:
      break;
    case Condition::bytes_off:
      if (!was_kept) drive.step();
      drive.set("byte_sweep", "0");
      break;
    case Condition::skins_off:
      drive.set("skin", "0");
      break;
    case Condition::slow_at_first:
      drive.step();
      break;
    case Condition::slow_for_long:
      drive.step();
      drive.shake(0, 1, 0.5);
      drive.rest(4);  // the first of them are the steps of the shake
      break;
    case Condition::keeping_is_costly:
      drive.shake(0, 0.6, 3);
      drive.step();
      drive.shake(0, 0.6, 3);
      drive.step();
      break;
    case Condition::many_leave:
      drive.rest(30);
      drive.shake(0, 0.2, 0.1);
      drive.step();
      drive.shake(0.2, 0.4, 0.1);
      drive.step();
      drive.shake(0.4, 0.6, 0.1);
      break;
    case Condition::rows_pay:
      drive.rest(3);
      break;
    case Condition::uproar:
      drive.rest(30);
      drive.shake(0, 1, 3);
      break;
  }
  ASSERT_EQ(drive.tree().mode(), transition.from);
  drive.step();
}

template <class T>
class Modes : public testing::Test {};
TYPED_TEST_SUITE(Modes, Dimensions, DimensionNames);

TYPED_TEST(Modes, ATreeGoesThroughEachTransitionAndItsPairsAreTheOracles) {
  constexpr int kD = TypeParam::value;
  for (const Transition& transition : kTransitions) {
    SCOPED_TRACE(std::string(to_string(transition.from)) + " -> " + std::string(to_string(transition.to)) +
                 ": " + std::string(to_string(transition.condition)));
    const bool is_small = transition.condition == Condition::rows_pay;  // one leaf
    Drive<kD> drive(is_small ? 60 : 600);
    go_through(transition, drive);
    ASSERT_FALSE(this->HasFatalFailure());
    ASSERT_NE(drive.tree().transition(), nullptr);
    EXPECT_EQ(*drive.tree().transition(), transition)
        << "it was " << to_string(drive.tree().transition()->condition);
    EXPECT_EQ(drive.tree().mode(), transition.to);
    drive.shake(0, 0.3, 0.05);
    drive.rest(3);
  }
}

TYPED_TEST(Modes, NoConditionHoldsWhereNothingHappens) {
  constexpr int kD = TypeParam::value;
  Drive<kD> drive;
  drive.begin_keeping();
  for (int k = 0; k < 100; ++k) {
    drive.step();
    ASSERT_EQ(drive.tree().transition(), nullptr) << "in step " << drive.tree().steps();
  }
}

/// The lines of the page that match, each as the texts of the pattern's groups.
std::vector<std::vector<std::string>> lines_of_page(const std::regex& pattern) {
  std::ifstream page(KERF_SOURCE_DIR "/docs/MODES.md");
  EXPECT_TRUE(page.good());
  std::vector<std::vector<std::string>> found;
  std::smatch match;
  for (std::string line; std::getline(page, line);)
    if (std::regex_match(line, match, pattern)) found.emplace_back(match.begin() + 1, match.end());
  return found;
}

TEST(ModesPage, ItsTableAndItsDiagramAreTheCodes) {
  std::vector<std::vector<std::string>> table;
  std::vector<std::vector<std::string>> diagram;
  for (const Transition& transition : kTransitions) {
    const std::vector<std::string> names{std::string(to_string(transition.from)),
                                         std::string(to_string(transition.to)),
                                         std::string(to_string(transition.condition))};
    diagram.push_back(names);
    table.push_back(names);
    table.back().emplace_back(meaning(transition.condition));
  }
  EXPECT_EQ(lines_of_page(std::regex(R"(\| (\w+) \| (\w+) \| `(\w+)` \| (.*) \|)")), table);
  EXPECT_EQ(lines_of_page(std::regex(R"(    (\w+) --> (\w+): (\w+))")), diagram);
}

TEST(ModesPage, EachModeAndEachConditionIsInTheTable) {
  std::set<Mode> modes;
  std::set<Condition> conditions;
  for (const Transition& transition : kTransitions) {
    modes.insert({transition.from, transition.to});
    conditions.insert(transition.condition);
    EXPECT_NE(transition.from, transition.to);
  }
  EXPECT_EQ(modes.size(), kModeCount);
  EXPECT_EQ(conditions.size(), kConditionCount);
}

}  // namespace
}  // namespace kerf::test
