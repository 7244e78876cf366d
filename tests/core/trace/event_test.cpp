#include "core/trace/event.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/trace/reporter.h"

namespace kerf::test {
namespace {

TEST(DescribeEvent, SaysWhatHappenedInOneLine) {
  const NodeRef node{NodeId{5}, 2};
  const auto line = [](EventBody body) { return describe(Event{17, 20, body}, {}); };
  EXPECT_EQ(line(PhaseBegan{Phase::operate}), "e17 step 20 phase operate");
  EXPECT_EQ(line(ObjectPlaced{ObjectId{9}, 3}), "e17 step 20 object 9 in 3 leaves");
  EXPECT_EQ(line(OperatorScheduled{Operator::swap, node}), "e17 step 20 swap n5 scheduled");
  EXPECT_EQ(line(OperatorActed{Operator::split, node, {65, 0, 0}, {65, 33, 34}, 3, 0, 1.5F}),
            "e17 step 20 split n5: 65 -> 65 (33 | 34)");
  EXPECT_EQ(line(OperatorActed{Operator::balance, node, {65, 60, 5}, {65, 33, 34}, 3, 0, 1.5F}),
            "e17 step 20 balance n5: 65 (60 | 5) -> 65 (33 | 34)");
  EXPECT_EQ(line(OperatorRefused{Operator::split, node, Refusal::no_partitioner}),
            "e17 step 20 split n5 refused: no good partitioner");
  EXPECT_EQ(line(EventsDeferred{7}), "e17 step 20 7 events deferred");
}

TEST(DescribeEvent, NamesEveryOperatorPhaseAndRefusalApart) {
  std::set<std::string_view> names;
  for (int i = 0; i < kOperatorCount; ++i) names.insert(to_string(static_cast<Operator>(i)));
  EXPECT_EQ(names.size(), 5U);
  for (int i = 0; i < kPhaseCount; ++i) names.insert(to_string(static_cast<Phase>(i)));
  EXPECT_EQ(names.size(), 10U);
  for (int i = 0; i < kRefusalCount; ++i) names.insert(to_string(static_cast<Refusal>(i)));
  EXPECT_EQ(names.size(), std::size_t{kOperatorCount + kPhaseCount + kRefusalCount});
  EXPECT_FALSE(names.contains(""));
}

TEST(EventReporter, NumbersEventsOverTheStepsFromZero) {
  Reporter<EventLog> reporter;
  reporter.begin_step(4);
  reporter.report([] { return EventsDeferred{1}; });
  reporter.report([] { return PhaseBegan{Phase::place}; });
  reporter.begin_step(5);
  reporter.report([] { return EventsDeferred{2}; });
  const auto events = reporter.trace().take();
  ASSERT_EQ(events.size(), 3U);
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].id, i);
    EXPECT_EQ(events[i].step, i < 2 ? 4U : 5U);
  }
  EXPECT_TRUE(reporter.trace().events().empty()) << "taken";
  reporter.report([] { return EventsDeferred{3}; });
  EXPECT_EQ(reporter.trace().events().front().id, 3U) << "taking does not restart the count";
}

TEST(EventReporter, WithoutATraceBuildsNothing) {
  Reporter<NoTrace> reporter;
  bool built = false;
  reporter.report([&] {
    built = true;
    return EventsDeferred{1};
  });
  EXPECT_FALSE(built);
  static_assert(sizeof(Reporter<NoTrace>) == sizeof(Reporter<EventLog>) - sizeof(EventLog));
}

}  // namespace
}  // namespace kerf::test
