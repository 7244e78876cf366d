#include <gmock/gmock.h>

#include "core/trace/event_facts.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/debugger/model/find_hits.h"

namespace kerf::test {
namespace {

std::vector<std::string> texts_of(const std::vector<SearchHit>& hits) {
  std::vector<std::string> texts;
  for (const SearchHit& hit : hits) texts.push_back(hit.text);
  return texts;
}

class DebuggerSearch : public testing::Test {
 protected:
  DebuggerSearch() { model().go(Position::end_of(20)); }
  DebuggerModel& model() { return driver.debugger().model(); }
  std::vector<std::string> found(std::string_view query) { return texts_of(find_hits(model(), query)); }
  /// Follows the first hit.
  void follow(std::string_view query) { find_hits(model(), query).at(0).go(model()); }

  TimelineDriver driver;
};

TEST_F(DebuggerSearch, AThingIsFoundByItsName) {
  EXPECT_THAT(found("n0"), testing::ElementsAre("n0"));
  EXPECT_THAT(found("40"), testing::ElementsAre("object 40", "step 40"));
  EXPECT_THAT(found("object 40"), testing::ElementsAre("object 40"));
  EXPECT_THAT(found("step 40"), testing::ElementsAre("step 40"));
  EXPECT_THAT(found("40,41"), testing::ElementsAre("pair 40,41"));
  EXPECT_THAT(found("e1"), testing::ElementsAre("e1"));
  for (const char* const nothing : {"n99999", "99999999", "40,40", "e99999999999", "no such thing"})
    EXPECT_THAT(found(nothing), testing::IsEmpty()) << nothing;
}

/// What has the number itself comes before a name that only contains it.
TEST(DebuggerLabels, AnObjectIsFoundByItsName) {
  TimelineDriver driver(
      60, "INSERT INTO object_marks VALUES(40, 'left wheel', NULL), (41, 'Crate 40', '#ff0000')");
  DebuggerModel& model = driver.debugger().model();
  model.go(Position::end_of(20));
  EXPECT_THAT(texts_of(find_hits(model, "WHEEL")), testing::ElementsAre("object 40 left wheel"));
  EXPECT_THAT(texts_of(find_hits(model, "40")),
              testing::ElementsAre("object 40", "step 40", "object 41 Crate 40"));
  find_hits(model, "wheel").at(0).go(model);
  EXPECT_EQ(model.selection(), Selection(ObjectId{40}));
  EXPECT_THAT(model.run().explain(ObjectId{40}), testing::StartsWith("object 40 left wheel moves"));
}

TEST_F(DebuggerSearch, ItLeadsThere) {
  follow("n0");
  EXPECT_EQ(model().selection(), Selection(NodeId{0}));
  follow("41,40");
  EXPECT_EQ(model().selection(), Selection(make_pair(ObjectId{40}, ObjectId{41})));
  follow("step 30");
  EXPECT_EQ(model().run().position(), Position::end_of(30));
  follow("colour by cost");
  EXPECT_EQ(model().view.tint, Tint::cost);
  follow("view from top");
  EXPECT_EQ(model().view.facing.direction, "top");
  follow("start of run");
  EXPECT_EQ(model().run().position(), Position());
  follow("next split");
  const auto event = model().run().event();
  ASSERT_TRUE(event);
  EXPECT_EQ(acted_of(*event)->op, Operator::split);
}

TEST_F(DebuggerSearch, CommandsAreFoundByTheirWords) {
  EXPECT_THAT(found("breakpoint run"),
              testing::ElementsAre("run to a breakpoint", "run back to a breakpoint"));
  EXPECT_THAT(found("NEXT merge"), testing::ElementsAre("next merge"));
  EXPECT_THAT(found("split"), testing::ElementsAre("next split", "previous split", "next shift-split",
                                                   "previous shift-split"));
  EXPECT_GT(found("").size(), 40U) << "all of them";
}

TEST_F(DebuggerSearch, AConditionIsGoneToOrBecomesABreakpoint) {
  EXPECT_THAT(found("pairs>0"), testing::ElementsAre("next moment where pairs>0",
                                                     "previous moment where pairs>0", "stop where pairs>0"));
  EXPECT_THAT(found("pairs>>0"), testing::IsEmpty()) << "no condition";
  model().go({});
  follow("step==25");
  EXPECT_EQ(model().run().position().step, 25U);
  find_hits(model(), "step==25").at(2).go(model());
  EXPECT_EQ(model().breakpoints.at(0).condition.text(), "step==25");
  follow("step==9999");
  EXPECT_THAT(model().message, testing::HasSubstr("holds nowhere further on"));
}

TEST(DebuggerSearchBox, IsDrivenByKeysAndRemembers) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
key P
expect search == "open: "
type n0
key Enter
expect search == closed
expect selection == n0
key P
type "colour"
key Down
key Down
key Enter
expect colour == redundancy
key P
key Down
key Enter
expect selection == n0
key P
type "next sp"
key Tab
wait 2
expect search == "open: next split"
key Enter
expect deed ~ split
click search
type "e1"
click "hit 0"
expect event == e1
key P
type "no such thing"
key Enter
expect search ~ "no such"
key Escape
expect search == closed
)"),
            "");
}

}  // namespace
}  // namespace kerf::test
