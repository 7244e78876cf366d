#include "frames/story/story_course.h"

#include <gtest/gtest.h>

#include "core/recording/recording_reader.h"
#include "frames/sequence/record_scene.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

StoryMoment moment(std::uint32_t step, Operator op, std::uint32_t population) {
  StoryMoment made;
  made.step = step;
  made.acted.op = op;
  made.acted.after.population = population;
  return made;
}

TEST(StoryMoments, EachKindComesFirstAndNoneIsNearToAnother) {
  const std::vector<StoryMoment> operators{
      moment(10, Operator::split, 900), moment(12, Operator::split, 800), moment(14, Operator::merge, 5),
      moment(50, Operator::split, 700), moment(60, Operator::merge, 4),   moment(90, Operator::balance, 20)};
  const auto chosen = choose_moments(operators, {1, 101, 1}, 3);
  ASSERT_EQ(chosen.size(), 3U);
  EXPECT_EQ(chosen[0].step, 10U) << "the largest split";
  EXPECT_EQ(chosen[1].step, 60U) << "the larger merge is too near to the split";
  EXPECT_EQ(chosen[2].step, 90U);
  EXPECT_EQ(choose_moments(operators, {1, 101, 1}, 1).size(), 1U);
  EXPECT_TRUE(choose_moments({}, {1, 101, 1}, 3).empty());
}

/// The tree's tests are those that its ordered lists leave, between the true pairs and all of them.
TEST(StoryCourse, CountsTheTestsOfEachStep) {
  const TemporaryFolder folder;
  RenderTexts texts;
  texts.scene = "pile";
  texts.steps = "60";
  texts.objects = "150";
  texts.grow = "40";
  texts.record = (folder.path() / "pile.kerf").string();
  record_scene(parse_request(texts));
  std::uint32_t last = 0;
  const StoryCourse course = follow_course(texts.record, {1, 60, 1}, "loose-octree", [&](std::uint32_t step) {
    last = step;
    return true;
  });
  EXPECT_EQ(last, 60U);
  ASSERT_EQ(course.curves.size(), 3U);
  for (const StoryCurve& curve : course.curves) ASSERT_EQ(curve.values.size(), 60U) << curve.name;
  const RecordingReader<2> reader(texts.record);
  for (std::uint32_t step = 1; step <= 60; ++step) {
    const StepRow& row = reader.row(step);
    const auto value = [&](std::size_t k) { return course.curves[k].values[step - 1]; };
    const float objects = static_cast<float>(row.statistics.objects);
    EXPECT_EQ(value(0), objects * (objects - 1) / 2);
    EXPECT_GE(value(1), static_cast<float>(row.pairs));
    EXPECT_GE(value(2), static_cast<float>(row.pairs));
    EXPECT_LE(value(2), 2 * value(0)) << "in few leaves twice";
    EXPECT_GE(course.levels, row.statistics.height + 1);
  }
  std::uint64_t acted = 0;
  for (const std::uint64_t count : reader.row(60).statistics.operators) acted += count;
  EXPECT_EQ(course.operators.size(), acted);
  EXPECT_EQ(follow_course(texts.record, {1, 60, 1}, "none", [](std::uint32_t) { return true; }).curves.size(),
            2U);
}

}  // namespace
}  // namespace kerf::test
