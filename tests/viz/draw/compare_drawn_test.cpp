#include "viz/draw/compare_drawn.h"

#include <gmock/gmock.h>

namespace kerf {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<std::string> compare_texts(std::vector<DrawnText> reference, std::vector<DrawnText> test) {
  FrameIds a;
  FrameIds b;
  a.list.texts = std::move(reference);
  b.list.texts = std::move(test);
  return compare_drawn(a, b);
}

TEST(CompareDrawn, TextsMayBeTwoPixelsAsideOfTheirPlaces) {
  EXPECT_THAT(compare_texts({{6, 29, "nodes"}, {50, 29, "pairs"}}, {{4, 29, "nodes"}, {52, 29, "pairs"}}),
              IsEmpty());
  EXPECT_THAT(compare_texts({{6, 29, "nodes"}}, {{6, 30, "nodes"}}), SizeIs(2)) << "another row";
  EXPECT_THAT(
      compare_texts({{6, 29, "nodes"}}, {{3, 29, "nodes"}}),
      ElementsAre(HasSubstr("(3, 29) is 'nodes' and not ''"), HasSubstr("(6, 29) is '' and not 'nodes'")));
}

TEST(CompareDrawn, OtherTextsAreFoundHoweverNear) {
  EXPECT_THAT(compare_texts({{6, 29, "nodes"}}, {{6, 29, "leaves"}}),
              ElementsAre(HasSubstr("is 'leaves' and not 'nodes'")));
  EXPECT_THAT(compare_texts({{6, 29, "nodes"}}, {}), ElementsAre(HasSubstr("is '' and not 'nodes'")));
  EXPECT_THAT(compare_texts({}, {{6, 29, "nodes"}}), ElementsAre(HasSubstr("is 'nodes' and not ''")));
}

TEST(CompareDrawn, ATextThatIsThereTwiceIsFound) {
  const std::vector<DrawnText> twice{{6, 29, "nodes"}, {8, 29, "nodes"}};
  EXPECT_THAT(compare_texts({{6, 29, "nodes"}}, twice), ElementsAre(HasSubstr("is 'nodes' and not ''")));
  EXPECT_THAT(compare_texts(twice, {{8, 29, "nodes"}}), ElementsAre(HasSubstr("is '' and not 'nodes'")));
  EXPECT_THAT(compare_texts(twice, twice), IsEmpty());
}

}  // namespace
}  // namespace kerf
