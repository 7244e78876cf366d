#include "core/query/node_lives.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/bsp/bsp.h"
#include "core/replay/cursor.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

/// A crowd in which nodes come and go, and their slots are used again.
template <class T>
class NodeLives : public testing::Test {
 protected:
  static constexpr int kD = T::value;
  static constexpr std::uint32_t kSteps = 60;

  NodeLives() {
    test::record_crowd<kD>(file_.path(), kSteps, test::busy_config());
    lives_ = find_node_lives(read_operators(file_.path()));
  }

  /// What the lives say of a slot right after an event.
  [[nodiscard]] const NodeLife* life_at(std::size_t slot, std::uint64_t event) const {
    if (slot >= lives_.size()) return nullptr;
    for (const NodeLife& life : lives_[slot])
      if (holds(life.span, event)) return &life;
    return nullptr;
  }
  static bool holds(const LifeSpan& span, std::uint64_t event) {
    return (span.first_step == 0 || span.first_event <= event) &&
           (!span.last_step || event < span.last_event);
  }

  test::TemporaryRecording file_;
  std::vector<std::vector<NodeLife>> lives_;
};
TYPED_TEST_SUITE(NodeLives, test::Dimensions, test::DimensionNames);

TYPED_TEST(NodeLives, AreThoseOfTheTreeAfterEachOperator) {
  constexpr int kDimension = TypeParam::value;
  Cursor<kDimension> cursor(std::make_shared<RecordingReader<kDimension>>(this->file_.path()));
  std::size_t moments = 0;
  while (cursor.forward(Granularity::op)) {
    const std::uint64_t event = cursor.position().event;
    const Tree<kDimension>& tree = cursor.state().tree;
    ++moments;
    for (std::uint32_t slot = 0; slot < tree.slots(); ++slot) {
      const Node<kDimension>& node = tree[NodeId{slot}];
      const NodeLife* const life = this->life_at(slot, event);
      ASSERT_EQ(life != nullptr, node.alive) << "n" << slot << " after e" << event;
      if (life == nullptr) continue;
      ASSERT_EQ(life->generation, node.generation) << "n" << slot << " after e" << event;
      const bool divided =
          std::ranges::any_of(life->divided, [&](const LifeSpan& span) { return this->holds(span, event); });
      ASSERT_EQ(divided, !node.is_leaf()) << "n" << slot << " after e" << event;
    }
  }
  EXPECT_GT(moments, 50U);
}

TYPED_TEST(NodeLives, SlotsAreUsedAgainAndTheRootIsThereFromTheBeginning) {
  EXPECT_EQ(this->lives_.at(0).front().span.first_step, 0U);
  EXPECT_TRUE(std::ranges::any_of(this->lives_, [](const auto& lives) { return lives.size() > 1; }));
}

TEST(NodeLivesOfOperators, WhatCannotHaveHappenedIsRefused) {
  using Kind = OperatorRow::Kind;
  const OperatorRow split{
      .event = 5, .step = 1, .kind = Kind::acted, .op = Operator::split, .node = {NodeId{0}, 0}};
  OperatorRow other = split;
  EXPECT_THROW((void)find_node_lives(std::vector{split, split}), std::runtime_error);
  other.node.node = NodeId{7};
  EXPECT_THROW((void)find_node_lives(std::vector{other}), std::runtime_error);
  other = {.event = 6, .step = 1, .kind = Kind::acted, .op = Operator::merge, .node = {NodeId{1}, 0}};
  EXPECT_THROW((void)find_node_lives(std::vector{split, other}), std::runtime_error);
  other.node = {NodeId{0}, 1};
  EXPECT_THROW((void)find_node_lives(std::vector{split, other}), std::runtime_error);
}

}  // namespace
}  // namespace kerf
