#include "core/query/counterpart.h"

#include <gtest/gtest.h>

#include <vector>

namespace kerf {
namespace {

using Match = Counterpart::Match;

/// Numbers events of step 7 from `first` on.
std::vector<Event> events(std::uint64_t first, const std::vector<EventBody>& bodies) {
  std::vector<Event> result;
  for (const EventBody& body : bodies) result.push_back({first++, 7, body});
  return result;
}

NodeRef node(std::uint32_t id) { return {NodeId{id}, 0}; }
EventBody phase(Phase phase) { return PhaseBegan{phase}; }
EventBody placed(std::uint32_t object, std::uint32_t leaves = 1) { return ObjectPlaced{{object}, leaves}; }
EventBody split(std::uint32_t id, std::uint32_t left) {
  return OperatorActed{Operator::split, node(id), {}, {left, left, 0}, 0, 0, 0};
}
EventBody refused(Operator op, std::uint32_t id) { return OperatorRefused{op, node(id), Refusal::decided}; }

class CounterpartTest : public testing::Test {
 protected:
  /// Where the other run stands, as the index of its event; -1: before its step.
  int meets(std::size_t k, Match match) {
    const Counterpart found = find_counterpart({7, these_[k].id}, these_, those_, 9);
    EXPECT_EQ(found.match, match) << "of event " << k;
    if (found.position == Position::end_of(6)) return -1;
    EXPECT_EQ(found.position.step, 7U);
    return static_cast<int>(found.position.event - those_.front().id);
  }

  std::vector<Event> these_;
  std::vector<Event> those_;
};

TEST_F(CounterpartTest, EndsOfStepsBelongTogetherAsFarAsTheOtherRunGoes) {
  EXPECT_EQ(find_counterpart(Position::end_of(5), {}, {}, 9).position, Position::end_of(5));
  EXPECT_EQ(find_counterpart(Position::end_of(5), {}, {}, 9).match, Match::same);
  EXPECT_EQ(find_counterpart(Position::end_of(12), {}, {}, 9).position, Position::end_of(9));
  EXPECT_EQ(find_counterpart(Position::end_of(12), {}, {}, 9).match, Match::none);
}

TEST_F(CounterpartTest, TheSameEventsWithOtherNumbersBelongTogether) {
  const std::vector<EventBody> bodies{phase(Phase::place), placed(3), phase(Phase::operate), split(1, 4)};
  these_ = events(100, bodies);
  those_ = events(900, bodies);
  for (std::size_t k = 0; k < bodies.size(); ++k) EXPECT_EQ(meets(k, Match::same), static_cast<int>(k));
}

TEST_F(CounterpartTest, AnOperatorMeetsItsOtherOutcomeAndOneThatIsNotThereTheOneBefore) {
  these_ = events(100, {phase(Phase::operate), split(1, 4), split(2, 4), split(3, 4), split(4, 4)});
  those_ = events(200, {phase(Phase::operate), split(9, 1), refused(Operator::split, 1), split(3, 5)});
  EXPECT_EQ(meets(1, Match::different), 2);
  EXPECT_EQ(meets(2, Match::none), 2);
  EXPECT_EQ(meets(3, Match::different), 3);
  EXPECT_EQ(meets(4, Match::none), 3);
}

TEST_F(CounterpartTest, TheSecondTimeMeetsTheSecondTime) {
  these_ = events(100, {phase(Phase::operate), split(1, 4), refused(Operator::split, 1)});
  those_ = events(200, {phase(Phase::operate), split(1, 4), split(5, 5), split(1, 4)});
  EXPECT_EQ(meets(1, Match::same), 1);
  EXPECT_EQ(meets(2, Match::different), 3);
}

TEST_F(CounterpartTest, NothingOfAnotherPhaseIsMet) {
  these_ = events(100, {phase(Phase::schedule), refused(Operator::merge, 1), phase(Phase::operate),
                        refused(Operator::merge, 1)});
  those_ = events(200, {phase(Phase::operate), refused(Operator::merge, 1)});
  EXPECT_EQ(meets(0, Match::none), -1);
  EXPECT_EQ(meets(1, Match::none), -1);
  EXPECT_EQ(meets(3, Match::same), 1);
}

}  // namespace
}  // namespace kerf
