#include "viz/draw/pane_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "viz/draw/letters.h"
#include "viz/draw/panes_renderer.h"

namespace kerf {
namespace {

template <int D>
PanesFrame<D> frame_of(const std::string& scene) {
  PanesFrame<D> frame;
  frame.scene = scene;
  frame.step = frame.objects = frame.moving = 12345;
  frame.bounds = test::box_at(test::all<D>(0), 5);
  frame.bodies.resize(1);
  frame.bodies[0].box = test::box_at(test::all<D>(0), 4);
  frame.bodies[0].shape = Brick<D>{test::all<D>(4)};
  frame.has_strips = true;
  StructurePane<D> pane;
  pane.name = "a-broad-phase-with-a-name-that-is-longer-than-a-pane";
  pane.parts.kind = "tree of boxes and much more";
  pane.parts.unseen = "It builds and drops its nodes within one call, so that nothing of them is seen";
  pane.parts.cells.resize(1);
  pane.parts.tells_tested = true;
  pane.figures.tests = 1234567;
  frame.panes.push_back(pane);
  return frame;
}

template <class T>
class PaneText : public testing::Test {};
TYPED_TEST_SUITE(PaneText, test::Dimensions, test::DimensionNames);

TYPED_TEST(PaneText, EndsWithinItsPictureAndLeavesRoomToTheScene) {
  constexpr int kD = TypeParam::value;
  for (const auto& [width, height] : {std::pair{240, 200}, {320, 240}, {480, 270}, {640, 360}}) {
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    FrameOptions options;
    options.width = width;
    options.height = height;
    options.ids = true;
    PanesRenderer<kD> renderer(options);
    (void)renderer.render(
        frame_of<kD>("recording_of_a_scene_with_a_name_that_is_longer_than_a_small_picture"));
    const int advance = Font(11).advance();
    for (const DrawnText& text : renderer.ids().list.texts) {
      EXPECT_LE(text.x + static_cast<int>(count_letters(text.text)) * advance, width) << text.text;
      EXPECT_LE(text.y + advance, height) << text.text;
    }
    const auto& items = renderer.ids().list.items;
    const auto object = std::ranges::find(items, DrawnKind::object, &Drawn::kind);
    ASSERT_NE(object, items.end());
    EXPECT_GT(object->pixels, 100U) << "the scene has no room";
  }
}

TYPED_TEST(PaneText, SaysThatThereIsMore) {
  constexpr int kD = TypeParam::value;
  const PanesFrame<kD> frame = frame_of<kD>("scene");
  const StructurePane<kD>& pane = frame.panes[0];
  const PaneLines all = pane_lines(pane, true, {40, 100});
  EXPECT_EQ(std::ranges::count_if(all.plain, [](const auto& line) { return line.ends_with("..."); }), 1)
      << "the name alone is longer than a line";
  for (std::size_t lines = 1; lines < all.size(); ++lines) {
    const PaneLines some = pane_lines(pane, true, {40, lines});
    EXPECT_EQ(some.size(), lines);
    const std::string& last = some.faint.empty() ? some.plain.back() : some.faint.back();
    EXPECT_TRUE(last.ends_with("...") || lines == all.plain.size()) << last;
    for (const auto* part : {&some.plain, &some.faint})
      for (const std::string& line : *part) EXPECT_LE(count_letters(line), 40U) << line;
  }
}

TYPED_TEST(PaneText, OfThePictureTakesAsManyLinesAsItNeeds) {
  constexpr int kD = TypeParam::value;
  const PanesFrame<kD> frame = frame_of<kD>("buckets");
  EXPECT_EQ(panes_title(frame, 80),
            std::vector<std::string>{"scene buckets  step 12345  objects 12345  moving 12345"});
  EXPECT_EQ(panes_title(frame, 33),
            (std::vector<std::string>{"scene buckets  step 12345", "objects 12345  moving 12345"}));
}

/// In 3D the fill of a cell is seen on its objects alone.
TEST(PanesLegend, NamesOnlyWhatIsDrawn) {
  const Font font(11);
  PanesLegend legend{3, true, false, false, false, LayerSet::parse("leaves")};
  EXPECT_EQ(legend_lines(legend, font, 640), 0);
  legend.layers = LayerSet::parse("leaves,objects");
  EXPECT_EQ(legend_lines(legend, font, 640), 1);
  legend.dimension = 2;
  legend.layers = LayerSet::parse("leaves");
  EXPECT_EQ(legend_lines(legend, font, 640), 1);
}

}  // namespace
}  // namespace kerf
