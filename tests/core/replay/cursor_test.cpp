#include "core/replay/cursor.h"

#include <gtest/gtest.h>

#include <set>

#include "core/trace/event_facts.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/sound.h"

namespace kerf {
namespace {

template <class T>
class CursorTest : public testing::Test {
 protected:
  static constexpr int kD = T::value;

  Cursor<kD> cursor(const char* policy = "byte_sweep=0", std::uint32_t steps = 60) {
    Config config = test::busy_config();
    kerf::apply(config, policy);
    test::record_crowd<kD>(file_.path(), steps, config);
    return Cursor<kD>(std::make_shared<RecordingReader<kD>>(file_.path()));
  }

 private:
  test::TemporaryRecording file_;
};
TYPED_TEST_SUITE(CursorTest, test::Dimensions, test::DimensionNames);

template <int D>
std::uint64_t fingerprint(const Cursor<D>& cursor) {
  return cursor.state().hash() ^ hash_pairs(cursor.state().pairs);
}

/// 1,000 events forwards, then backwards.
template <int D>
void go_there_and_back(Cursor<D> cursor) {
  cursor.go_to_step(20);
  std::vector<std::pair<Position, std::uint64_t>> seen{{cursor.position(), fingerprint(cursor)}};
  for (int k = 0; k < 1000 && cursor.forward(Granularity::event); ++k)
    seen.emplace_back(cursor.position(), fingerprint(cursor));
  ASSERT_EQ(seen.size(), 1001U);
  std::set<std::uint64_t> different;
  for (const auto& [position, hash] : seen) different.insert(hash);
  EXPECT_GT(different.size(), 300U);  // states do differ from event to event
  for (std::size_t k = seen.size() - 1; k > 0; --k) {
    ASSERT_TRUE(cursor.backward(Granularity::event));
    ASSERT_EQ(cursor.position(), seen[k - 1].first);
    ASSERT_EQ(fingerprint(cursor), seen[k - 1].second) << "at " << to_string(cursor.position(), {});
  }
}

TYPED_TEST(CursorTest, TheSameStateForwardsAndBackwards) {
  go_there_and_back(this->cursor("byte_sweep=0", 90));
}

TYPED_TEST(CursorTest, TheSameStateForwardsAndBackwardsWithKeptPairs) {
  go_there_and_back(this->cursor("byte_sweep=1,skin=4,stream_share=0.5", 250));
}

TYPED_TEST(CursorTest, StepsEndAsTheyWereRecorded) {
  auto cursor = this->cursor();
  std::uint32_t step = 0;
  while (cursor.forward(Granularity::step)) {
    ++step;
    EXPECT_EQ(cursor.position(), Position::end_of(step));
    EXPECT_EQ(cursor.state().hash(), cursor.recording().row(step).state_hash);
    EXPECT_EQ(cursor.event(), std::nullopt);
  }
  EXPECT_EQ(step, 60U);
  EXPECT_FALSE(cursor.forward(Granularity::run));
  while (cursor.backward(Granularity::step)) --step;
  EXPECT_EQ(step, 0U);
  EXPECT_FALSE(cursor.backward(Granularity::event));
  EXPECT_TRUE(cursor.forward(Granularity::run));
  EXPECT_EQ(cursor.position().step, 60U);
}

TYPED_TEST(CursorTest, PhasesComeInTheirOrder) {
  auto cursor = this->cursor();
  cursor.go_to_step(30);
  for (int phase = 0; phase < kPhaseCount; ++phase) {
    ASSERT_TRUE(cursor.forward(Granularity::phase));
    EXPECT_EQ(phase_of(*cursor.event()), static_cast<Phase>(phase));
  }
  ASSERT_TRUE(cursor.forward(Granularity::phase));
  EXPECT_EQ(cursor.position(), Position::end_of(31));
  ASSERT_TRUE(cursor.backward(Granularity::phase));
  EXPECT_EQ(phase_of(*cursor.event()), Phase::sweep);
  ASSERT_TRUE(cursor.backward(Granularity::step));
  EXPECT_EQ(cursor.position(), Position::end_of(30));
}

/// In the middle of a step the tree is as the operator left it, and sound.
TYPED_TEST(CursorTest, OperatorsAreSeenAtWork) {
  auto cursor = this->cursor();
  std::set<Operator> seen;
  std::uint32_t checked = 0;
  while (cursor.forward(Granularity::op)) {
    const auto event = cursor.event();
    const auto* acted = acted_of(*event);
    if (acted == nullptr) continue;
    seen.insert(acted->op);
    EXPECT_TRUE(test::is_sound(cursor.state().tree)) << describe(*event, {});
    const bool divides = acted->op == Operator::split || acted->op == Operator::shift_split;
    if (!divides) continue;
    const NodeId node = acted->node.node;
    EXPECT_EQ(cursor.state().tree[node].plane.offset, acted->new_offset);
    ASSERT_TRUE(cursor.backward(Granularity::event));
    EXPECT_TRUE(cursor.state().tree[node].is_leaf());
    ASSERT_TRUE(cursor.forward(Granularity::event));
    ++checked;
  }
  EXPECT_GT(checked, 10U);
  EXPECT_GE(seen.size(), 4U);
}

TYPED_TEST(CursorTest, CandidatesAreThoseOfTheOperator) {
  auto cursor = this->cursor();
  std::uint32_t ballots = 0;
  while (cursor.forward(Granularity::candidate)) {
    if (cursor.candidate() != 0U) continue;
    const auto event = cursor.event();
    ASSERT_FALSE(cursor.candidates().empty());
    const BallotEntry& first = cursor.candidates().front();
    if (const auto* acted = acted_of(*event)) {
      EXPECT_EQ(first.result, Ballot::chosen) << describe(*event, {});
      EXPECT_EQ(first.direction, acted->direction) << describe(*event, {});
      EXPECT_EQ(first.offset, acted->new_offset) << describe(*event, {});
    } else {
      EXPECT_NE(first.result, Ballot::chosen) << describe(*event, {});
    }
    ++ballots;
  }
  EXPECT_GT(ballots, 10U);
  const Position last = cursor.position();
  const std::size_t candidates = cursor.candidates().size();
  EXPECT_EQ(cursor.candidate(), candidates - 1);
  for (std::size_t k = 1; k < candidates; ++k) ASSERT_TRUE(cursor.backward(Granularity::candidate));
  EXPECT_EQ(cursor.position(), last);
  ASSERT_TRUE(cursor.backward(Granularity::candidate));
  EXPECT_LT(cursor.position(), last);
}

TYPED_TEST(CursorTest, MomentsBeyondTheRecordingAreErrors) {
  auto cursor = this->cursor();
  EXPECT_THROW(cursor.go_to_step(61), std::runtime_error);
  EXPECT_THROW(cursor.go_to_event(1'000'000), std::runtime_error);
}

}  // namespace
}  // namespace kerf
