#include "viz/draw/story.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/viz/small_scene.h"

namespace kerf {
namespace {

/// A story's picture, with its texts.
class StoryPicture : public testing::Test {
 protected:
  void draw(int width, int height, const std::string& sentence) {
    FrameOptions options;
    options.width = width;
    options.height = height;
    options.ids = true;
    options.layers = LayerSet::parse("objects,partitioners");
    options.letters = story_letters(width, height);
    options.margins = story_margins(width, height);
    FrameRenderer<3> renderer(options);
    tree.assign(&scene.tree());
    const std::vector<StoryCurve> curves{{"each with each", {90, 90, 90}, {1e6F, 1e6F, 1e6F, 1e6F}},
                                         {"our tree", {0, 114, 178}, counts}};
    const StoryPanels panels{title, "step 3",    sentence, &tree, 64,
                             12,    tree.root(), &curves,  3,     {"5000", "5003.5"}};
    renderer.set_sketch([&](const View& view, const Font& font, Overlay& overlay) {
      draw_story(view, font, panels, overlay);
    });
    picture = renderer.render(scene.input());
    texts = renderer.ids().list.texts;
    font_width = Font(story_letters(width, height)).advance();
  }

  /// Two texts of which one lies over the other; empty if there are none.
  [[nodiscard]] std::string overlapping() const {
    const auto right_of = [&](const DrawnText& text) {
      return text.x + font_width * static_cast<int>(text.text.size());
    };
    for (const DrawnText& a : texts)
      for (const DrawnText& b : texts)
        if (&a < &b && std::abs(a.y - b.y) < font_width && a.x < right_of(b) && b.x < right_of(a))
          return a.text + " and " + b.text;
    return "";
  }

  /// Where the scale has the word, which stands behind the values of the step.
  [[nodiscard]] int height_of(const std::string& word) const {
    const auto found =
        std::find_if(texts.rbegin(), texts.rend(), [&](const auto& one) { return one.text == word; });
    EXPECT_NE(found, texts.rend()) << word;
    return found == texts.rend() ? 0 : found->y;
  }

  std::string title = "small";
  std::vector<float> counts{1000, -1, 4000, 3000};  ///< of the tree
  test::SmallScene<3> scene;
  TreeSnapshotOf<3> tree;
  Image picture;
  std::vector<DrawnText> texts;
  int font_width = 0;
};

/// Of a recording with a long name, say.
TEST_F(StoryPicture, LongTextsSayThatTheyHaveMore) {
  title = "a_recording_with_a_name_that_is_longer_than_its_picture_is_wide_at_any_size_that_is_usual";
  draw(640, 360, std::string(60, 'm') + " " + std::string(400, 'w') + " and more and more and more and more");
  const int right = 640 - story_margins(640, 360).right;
  int more = 0;
  for (const DrawnText& text : texts) {
    if (text.x >= right) continue;
    EXPECT_LE(text.x + font_width * static_cast<int>(text.text.size()), right) << text.text;
    EXPECT_LE(text.y + 2 * font_width, 360) << text.text;
    more += text.text.ends_with("...") ? 1 : 0;
  }
  EXPECT_GE(more, 2);
  EXPECT_EQ(overlapping(), "");
}

TEST_F(StoryPicture, TextsStayInsideThePictureAndOutOfTheScene) {
  for (const auto& [width, height] :
       {std::pair(640, 360), std::pair(1920, 1080), std::pair(1080, 1920), std::pair(640, 1200),
        std::pair(1080, 1080), std::pair(1440, 1080), std::pair(2560, 1080)}) {
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    draw(width, height,
         "Step 604: leaf n26 got crowded: split parallel to its parent's plane into 61 and 58");
    const Margins margins = story_margins(width, height);
    ASSERT_GE(texts.size(), 10U);
    for (const DrawnText& text : texts) {
      const int right = text.x + font_width * static_cast<int>(text.text.size());
      EXPECT_GE(text.x, 0) << text.text;
      EXPECT_LE(right, text.x < width - margins.right ? width - margins.right : width) << text.text;
      EXPECT_LE(text.y + 2 * font_width, height) << text.text;
      const bool in_scene = text.y > margins.top && text.y < height - margins.bottom;
      EXPECT_TRUE(!in_scene || text.x >= width - margins.right) << text.text;
    }
    EXPECT_EQ(overlapping(), "");
  }
}

/// The value of a step that was not counted is the one before.
TEST_F(StoryPicture, ShowsTheValuesOfTheStep) {
  draw(1280, 720, "");
  std::vector<std::string> words;
  for (const DrawnText& text : texts) words.push_back(text.text);
  EXPECT_THAT(words, testing::IsSupersetOf(
                         {"1,000,000", "4,000", "each with each", "1k", "1M", "step 5000", "5003.5"}));
}

/// It lay on the lowest power of ten that has a line.
TEST_F(StoryPicture, ZeroHasALineOfItsOwnBelowThePowersOfTen) {
  counts = {40, 0, 0};
  draw(1280, 720, "");
  EXPECT_EQ(overlapping(), "");
  const int zero = height_of("0");
  EXPECT_NEAR(zero - height_of("10"), height_of("10") - height_of("100"), 1);
  const int middle = zero + Font(story_letters(1280, 720)).line_height() / 2;
  int blue = 0;
  for (int x = 1280 - story_margins(1280, 720).right; x < 1280; ++x) {
    const std::uint8_t* p = picture.pixel(x, middle);
    blue += p[0] < 60 && p[2] > 140 ? 1 : 0;
  }
  EXPECT_GT(blue, 40) << "the curve runs along it";
}

TEST_F(StoryPicture, TheIcicleHasTheColoursOfItsLeavesAndTheRimOfTheActingNode) {
  draw(1280, 720, "");
  std::size_t acting = 0;
  const Margins margins = story_margins(1280, 720);
  for (int y = 0; y < 720; ++y)
    for (int x = 1280 - margins.right; x < 1280; ++x) {
      const std::uint8_t* p = picture.pixel(x, y);
      if (p[0] > 180 && p[1] < 60 && p[2] > 90) ++acting;
    }
  EXPECT_GT(acting, 400U) << "the root is as wide as the panel";
}

TEST(StoryNumbers, HaveCommas) {
  EXPECT_EQ(with_commas(0), "0");
  EXPECT_EQ(with_commas(999), "999");
  EXPECT_EQ(with_commas(1000), "1,000");
  EXPECT_EQ(with_commas(1124250), "1,124,250");
}

}  // namespace
}  // namespace kerf
