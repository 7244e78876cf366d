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

/// A leaf of two items, a face and its outline of so many pixels, as panes of other structures draw it.
FrameIds leaf_with_outline(int outline, Color face) {
  FrameIds ids{{}, make_image(8, 8, 0x000000ffU)};
  Drawn drawn;
  drawn.kind = DrawnKind::leaf;
  drawn.a = 2;
  drawn.right = drawn.bottom = 8;
  drawn.color = face;
  ids.list.items.push_back(drawn);
  drawn.color = {60, 28, 113, 255};
  ids.list.items.push_back(drawn);
  for (int i = 0; i < outline; ++i) {
    const Color color = id_color(2);
    std::uint8_t* const pixel = ids.image.rgba.data() + 4 * static_cast<std::ptrdiff_t>(i);
    pixel[0] = color.r;
    pixel[1] = color.g;
    pixel[2] = color.b;
  }
  count_pixels(ids.image, ids.list);
  return ids;
}

TEST(CompareDrawn, ItemsOfOneMeaningAreEachComparedWithTheirOwn) {
  const Color face{33, 152, 137, 51};
  const FrameIds leaf = leaf_with_outline(40, face);
  EXPECT_THAT(compare_drawn(leaf, leaf), IsEmpty());
  EXPECT_THAT(compare_drawn(leaf, leaf_with_outline(8, face)), ElementsAre(HasSubstr("is not seen in")));
  FrameIds other = leaf;
  other.list.items[1].color = {0, 0, 0, 255};
  EXPECT_THAT(compare_drawn(leaf, other), ElementsAre(HasSubstr("tinted from #3c1c71 to #000000")));
  other = leaf;
  other.list.items.pop_back();
  EXPECT_THAT(compare_drawn(leaf, other), ElementsAre("leaf n2 missing"));
  other.list.items.pop_back();
  EXPECT_THAT(compare_drawn(leaf, other), ElementsAre("leaf n2 missing"));
}

}  // namespace
}  // namespace kerf
