#include "frames/story/story_words.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

Highlight split_of(std::uint32_t node, std::uint32_t age) {
  Highlight highlight;
  highlight.acted.op = Operator::split;
  highlight.acted.node.node = {node};
  highlight.age = age;
  return highlight;
}

/// The sentence of a moment stood until the next one, while other operators were drawn.
TEST(StoryWords, AreOfWhatIsHighlightedAndOfNothingElse) {
  FramePlan<2> plan;
  StoryInsert nothing;
  tell_operator(plan, 90, {}, nothing);
  EXPECT_EQ(nothing.sentence, "");
  EXPECT_FALSE(nothing.acting);

  plan.highlights = {split_of(7, 3), split_of(5, 4)};
  StoryInsert newest;
  tell_operator(plan, 90, {}, newest);
  EXPECT_EQ(newest.sentence.rfind("Step 87: leaf n7 got crowded", 0), 0U) << newest.sentence;
  EXPECT_FALSE(newest.acting) << "it is no longer alive";

  StoryInsert moment;
  moment.moment.emplace();
  moment.moment->step = 12;
  moment.moment->acted = split_of(2, 0).acted;
  tell_operator(plan, 90, {}, moment);
  EXPECT_EQ(moment.sentence.rfind("Step 12: leaf n2 got crowded", 0), 0U) << moment.sentence;
  EXPECT_EQ(moment.acting, NodeId{2});
}

}  // namespace
}  // namespace kerf
