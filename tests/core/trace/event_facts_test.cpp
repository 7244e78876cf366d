#include "core/trace/event_facts.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

constexpr NodeRef kNode{NodeId{5}, 2};

Event event(EventBody body) { return {17, 20, body}; }

TEST(EventFacts, OperatorsHaveADeed) {
  for (const EventBody& body : {EventBody(OperatorScheduled{Operator::swap, kNode}),
                                EventBody(OperatorRefused{Operator::swap, kNode, Refusal::height}),
                                EventBody(OperatorActed{Operator::swap, kNode, {}, {}, 0, 0, 0})}) {
    const auto deed = deed_of(event(body));
    ASSERT_TRUE(deed);
    EXPECT_EQ(deed->op, Operator::swap);
    EXPECT_EQ(node_of(event(body)), kNode);
    EXPECT_EQ(is_outcome(event(body)), body.index() != EventBody(OperatorScheduled{}).index());
  }
  for (const EventBody& body : {EventBody(PhaseBegan{}), EventBody(ObjectPlaced{}),
                                EventBody(EventsDeferred{}), EventBody(AllPlaced{})}) {
    EXPECT_FALSE(deed_of(event(body)));
    EXPECT_FALSE(node_of(event(body)));
    EXPECT_FALSE(is_outcome(event(body)));
  }
}

TEST(EventFacts, EachKindAnswersItsOwnQuestion) {
  const Event phase = event(PhaseBegan{Phase::sweep});
  const Event placed = event(ObjectPlaced{{3}, 2});
  const Event scheduled = event(OperatorScheduled{Operator::merge, kNode});
  const Event refused = event(OperatorRefused{Operator::split, kNode, Refusal::entries});
  const Event acted = event(OperatorActed{Operator::balance, kNode, {}, {}, 4, 1, 2});
  for (const Event& e :
       {phase, placed, scheduled, refused, acted, event(EventsDeferred{9}), event(AllPlaced{9})}) {
    EXPECT_EQ(phase_of(e), e == phase ? std::optional(Phase::sweep) : std::nullopt);
    EXPECT_EQ(object_of(e), e == placed ? std::optional(ObjectId{3}) : std::nullopt);
    EXPECT_EQ(begins_phase(e), e == phase);
    EXPECT_EQ(has_acted(e), e == acted);
    EXPECT_EQ(placed_of(e) != nullptr, e == placed);
    EXPECT_EQ(scheduled_of(e) != nullptr, e == scheduled);
    EXPECT_EQ(refused_of(e) != nullptr, e == refused);
  }
  EXPECT_EQ(acted_of(acted)->direction, 4U);
  EXPECT_EQ(refused_of(refused)->reason, Refusal::entries);
}

}  // namespace
}  // namespace kerf
