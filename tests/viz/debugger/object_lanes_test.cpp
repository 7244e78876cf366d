#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/support/dimensions.h"
#include "tests/support/temporary_folder.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/debugger/model/run_of.h"

namespace kerf::test {
namespace {

constexpr std::uint32_t kStepsOfLanes = 60;

template <class T>
class DebuggerCourse : public testing::Test {};
TYPED_TEST_SUITE(DebuggerCourse, test::Dimensions, test::DimensionNames);

TYPED_TEST(DebuggerCourse, IsWhatTheTreeHasAtEachStep) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording file;
  test::record_crowd<kD>(file.path(), kStepsOfLanes, test::busy_config());
  RunOf<kD> run(file.path());
  std::size_t several = 0;
  for (const ObjectId object : {ObjectId{3}, ObjectId{40}, ObjectId{121}}) {
    const ObjectCourse course = run.course(object, {});
    std::optional<Box<kD>> last;
    for (std::uint32_t step = 1; step <= kStepsOfLanes; ++step) {
      run.go(Position::end_of(step));
      const bool placed = run.state().latest.is_placed(object);
      EXPECT_EQ(std::isnan(course.leaves[step - 1]), !placed);
      const std::optional<Box<kD>> before = last;
      last = placed ? std::optional(run.state().latest.box(object)) : std::nullopt;
      EXPECT_EQ(std::isnan(course.speed[step - 1]), !placed || !before);
      if (!placed) continue;
      EXPECT_EQ(course.leaves[step - 1], run.leaves_of(object).size()) << step;
      EXPECT_EQ(course.pairs[step - 1],
                std::ranges::count_if(run.pairs(),
                                      [&](const Pair& pair) { return pair.a == object || pair.b == object; }))
          << step;
      several += course.leaves[step - 1] > 1 ? 1 : 0;
      if (!before) continue;
      EXPECT_EQ(course.speed[step - 1] > 0, before->center() != last->center()) << step;
    }
  }
  EXPECT_GT(several, 0U);
}

TEST(DebuggerObjectLanes, TheyComeAndGoWithTheSelection) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
click "go to"
type 20
key Enter
key Escape
key J
expect message == "select an object to see its lanes"
expect lanes == 6
double object:40
expect selection ~ object
expect lanes == 9
key Up
expect lane == "its speed"
key M
remember fastest step
click "lane its pairs"
expect lane == "its pairs"
click "max its speed"
expect step == $fastest
click n0
expect lanes == 6
expect lane == operators
)"),
            "");
}

TEST(DebuggerObjectLanes, TheLifeOfAnObjectIsARibbon) {
  TimelineDriver driver;
  DebuggerModel& model = driver.debugger().model();
  std::size_t most = 0;
  for (std::uint32_t object = 0; object < 120; object += 3) {
    model.select(ObjectId{object});
    const Lane& leaves = model.lanes()[kLanesOfRun];
    for (std::uint32_t step = 1; step <= kStepsOfLanes; ++step) {
      const bool there = std::ranges::any_of(model.ribbons(), [&](const Ribbon& ribbon) {
        return ribbon.first_step <= step && step <= ribbon.last_step;
      });
      EXPECT_EQ(there, leaves.value(step).has_value()) << object << " in step " << step;
    }
    most = std::max(most, model.ribbons().size());
  }
  EXPECT_GT(most, 1U);  // one was in quarantine for a while
}

TEST(DebuggerObjectLanes, AreEndedByTheUser) {
  TimelineDriver driver;
  DebuggerModel& model = driver.debugger().model();
  model.on_long_work = [](std::uint32_t step) { return step <= 10; };
  model.select(ObjectId{3});
  const Lane& leaves = model.lanes()[kLanesOfRun];
  EXPECT_TRUE(leaves.value(10).has_value());
  EXPECT_FALSE(leaves.value(11).has_value());
  EXPECT_THAT(model.message, testing::HasSubstr("ended"));
}

TEST(DebuggerObjectLanes, BelongToOneOfTwoRuns) {
  const test::TemporaryFolder folder;
  TimelineDriver driver;
  DebuggerModel& model = driver.debugger().model();
  model.work_folder = folder.path();
  model.what_if({{}, {}, "balance=0", 1});
  model.select(ObjectId{3});
  EXPECT_EQ(model.lanes().size(), kLanesOfRun + 3);
  EXPECT_EQ(driver.play("wait 2"), "");  // the other run has no such lanes
  model.change_over();
  EXPECT_EQ(model.lanes().size(), kLanesOfRun);
  EXPECT_EQ(model.other_lanes().size(), kLanesOfRun);
}

}  // namespace
}  // namespace kerf::test
