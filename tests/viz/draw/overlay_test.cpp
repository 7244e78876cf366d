#include "viz/draw/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "viz/draw/flow.h"
#include "viz/draw/letters.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

Caption large_caption() {
  Caption caption{
      "a-scene-with-a-long-name", "sweep-and-prune", 99999, 99999, 99999, 9999999, 9999999, {}, ""};
  caption.statistics.operators.fill(9999);
  return caption;
}

TEST(Layout, LeavesTheSceneRoomAtEverySize) {
  for (const int height : {64, 90, 180, 240, 360, 720, 1080, 2160}) {
    for (const int width : {64, 120, height, height * 16 / 9}) {
      const Font font(font_pixels(height));
      const auto caption = caption_items(large_caption(), true);
      const auto legend = legend_items(LayerSet::all(), 3, true, "1024");
      const Layout layout = make_layout(font, width, height, caption, true, legend);
      EXPECT_GE(layout.scene.height, 0.3 * height) << width << "x" << height;
      EXPECT_EQ(layout.caption_height + layout.scene.height + layout.legend_height, height);
    }
  }
}

TEST(Layout, EverythingFitsAtTheUsualSizes) {
  for (const auto& [width, height] : {std::pair{640, 360}, {1280, 720}, {1920, 1080}}) {
    const Font font(font_pixels(height));
    const auto caption = caption_items(large_caption(), true);
    const auto legend = legend_items(LayerSet::all(), 2, true, "1024");
    const Layout layout = make_layout(font, width, height, caption, true, legend);
    const int rows = flow::lines(flow::arrange_across(font, width, flow::pieces_of(font, caption))) + 1;
    EXPECT_GE(layout.caption_height, rows * font.line_height());
    EXPECT_GE(
        layout.legend_height,
        flow::lines(flow::arrange_across(font, width, flow::pieces_of(font, legend))) * font.line_height());
  }
}

TEST(Caption, StandsStillWhileNumbersGrow) {
  const Font font(16);
  Caption small = large_caption();
  small.step = small.objects = small.moving = 1;
  small.pairs = small.contacts = 0;
  small.statistics.operators.fill(0);
  Caption large = large_caption();
  large.pairs = large.contacts = 12345;
  const auto a = flow::arrange_across(font, 1280, flow::pieces_of(font, caption_items(small, true, 0)));
  const auto b = flow::arrange_across(font, 1280, flow::pieces_of(font, caption_items(large, true, 12345)));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].x, b[i].x) << i;
    EXPECT_EQ(a[i].line, b[i].line) << i;
  }
}

TEST(Caption, HasTheStepInSmallPicturesToo) {
  const Font font(font_pixels(90));
  const auto items = caption_items(large_caption(), true);
  const Layout layout = make_layout(font, 160, 90, items, true, {});
  const View view = frame_all(Box<2>{{{0, 0}}, {{4, 2}}}, {}, layout.scene, 160, 90);
  Overlay overlay;
  overlay.text.keeps_lines = true;
  draw_caption(view, font, layout, items, "", overlay);
  EXPECT_EQ(std::ranges::count(overlay.text.lines, "step", &DrawnText::text), 1);
}

/// The texts of a picture with that caption and legend, and what of them lies beyond its edges.
struct Texts {
  std::vector<std::string> all;
  std::vector<std::string> cut;
};
Texts texts_of(const Caption& of, const std::string& log, int width, int height) {
  const Font font(font_pixels(height));
  const auto caption = caption_items(of, true, 3);
  const auto legend = legend_items(LayerSet::all(), 2, true, "1024+", true);
  const Layout layout = make_layout(font, width, height, caption, !log.empty(), legend);
  const View view = frame_all(Box<2>{{{0, 0}}, {{4, 2}}}, {}, layout.scene, width, height);
  Highlight highlight;
  highlight.anchor = {1, 1, 0};
  Overlay overlay;
  overlay.text.keeps_lines = true;
  draw_caption(view, font, layout, caption, log_line(font, width, log, {}), overlay);
  draw_legend(view, font, layout, legend, 1, overlay);
  draw_highlight_labels(view, font, layout, {highlight}, overlay);
  Texts texts;
  for (const DrawnText& line : overlay.text.lines) {
    texts.all.push_back(line.text);
    if (line.x < 0 || line.x + font.width(line.text) > width) texts.cut.push_back(line.text);
  }
  return texts;
}

TEST(Caption, IsCutByNoEdgeOfAPicture) {
  Caption caption = large_caption();
  caption.scene =
      "recording_of_a_\xc3\xb6"
      "ffentliche_scene_with_a_name_that_is_longer_than_a_small_picture";
  for (const auto& [width, height] : {std::pair{64, 64}, {160, 90}, {240, 180}, {320, 240}, {640, 360}})
    EXPECT_EQ(texts_of(caption, "a note that is longer than the picture is wide, by far, at each size", width,
                       height)
                  .cut,
              std::vector<std::string>())
        << width << "x" << height;
  const Texts texts = texts_of(caption, "", 320, 240);
  EXPECT_EQ(std::ranges::count_if(texts.all,
                                  [](const std::string& text) {
                                    return text.starts_with("recording_of_a_") && text.ends_with("...");
                                  }),
            1);
}

TEST(Caption, AndLegendSayThatTheyHaveMore) {
  const auto signs = [](int width, int height) {
    return std::ranges::count(texts_of(large_caption(), "", width, height).all, "...");
  };
  EXPECT_EQ(signs(1280, 720), 0);
  EXPECT_EQ(signs(240, 180), 2) << "one of the caption, one of the legend";
}

TEST(Caption, OfBoxesAsSuchHasNoEmptyWordAndNoStep) {
  Caption boxes;
  boxes.scene = "boxes of an array";
  boxes.objects = 5;
  boxes.is_run = boxes.knows_contacts = false;
  const auto words = [&] {
    std::vector<std::string> list;
    for (const CaptionItem& item : caption_items(boxes, false)) list.push_back(item.word);
    return list;
  };
  EXPECT_EQ(words(), (std::vector<std::string>{"scene", "objects", "pairs"}));
  boxes.knows_pairs = false;  // boxes without pairs are not known to have none
  EXPECT_EQ(words(), (std::vector<std::string>{"scene", "objects"}));
}

TEST(Caption, NamesWhatLiesOutsideOnlyIfAsked) {
  const auto has_outside = [](const std::vector<CaptionItem>& items) {
    return std::ranges::count(items, "outside", &CaptionItem::word);
  };
  EXPECT_EQ(has_outside(caption_items(large_caption(), true)), 0);
  EXPECT_EQ(has_outside(caption_items(large_caption(), true, 0)), 1);
}

TEST(Labels, LieInTheSceneAndApart) {
  const Font font(16);
  const Layout layout{40, 30, {0, 40, 640, 290}};
  const View view = frame_all(Box<2>{{{0, 0}}, {{4, 2}}}, {}, layout.scene, 640, 360);
  Highlight highlight;
  highlight.anchor = {0.05, 0.05, 0};  // in a corner
  Overlay overlay;
  draw_highlight_labels(view, font, layout, std::vector<Highlight>(6, highlight), overlay);
  // Each label is a line, a diamond, a frame and a ground of four corners each.
  ASSERT_EQ(overlay.shapes.vertices.size(), 6U * 16U);
  EXPECT_FALSE(overlay.text.vertices.empty());
  std::vector<std::pair<float, float>> rows;
  for (std::size_t i = 8; i < overlay.shapes.vertices.size(); i += 16) {
    const auto begin = overlay.shapes.vertices.begin() + static_cast<std::ptrdiff_t>(i);
    const auto [low, high] =
        std::minmax_element(begin, begin + 4, [](const Vertex& a, const Vertex& b) { return a.y < b.y; });
    rows.emplace_back((low->y + 1) * 180, (high->y + 1) * 180);
    EXPECT_GE(rows.back().first, 40 - 1e-3);
    EXPECT_LE(rows.back().second, 330 + 1e-3);
    for (auto corner = begin; corner != begin + 4; ++corner) EXPECT_LT(corner->x, -0.5F);  // the left edge
  }
  std::ranges::sort(rows);
  for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_GE(rows[i].first, rows[i - 1].second);
}

TEST(Labels, WhereRoomIsShortTheNewestHasOne) {
  const Font font(16);
  const Layout layout{40, 30, {0, 40, 640, 80}};
  const View view = frame_all(Box<2>{{{0, 0}}, {{4, 2}}}, {}, layout.scene, 640, 150);
  std::vector<Highlight> highlights(8);
  for (std::uint32_t k = 0; k < 8; ++k) {
    highlights[k].acted.node.node.value = k;
    highlights[k].anchor = {0.05, 0.05, 0};
  }
  Overlay overlay;
  overlay.text.keeps_lines = true;
  draw_highlight_labels(view, font, layout, highlights, overlay);
  std::vector<std::string> texts;
  for (const DrawnText& line : overlay.text.lines) texts.push_back(line.text);
  ASSERT_FALSE(texts.empty());
  EXPECT_LT(texts.size(), 8U);
  EXPECT_EQ(texts.back(), highlights.front().label());
  EXPECT_EQ(std::ranges::count(texts, highlights.back().label()), 0);
}

TEST(Legend, NamesOnlyWhatIsDrawn) {
  EXPECT_TRUE(legend_items(LayerSet::none(), 3, true, "16").empty());
  EXPECT_EQ(legend_items(LayerSet::parse("partitioners"), 3, true, "16").size(), 1U);
  EXPECT_TRUE(legend_items(LayerSet::parse("partitioners,leaves,operators"), 3, false, "16").empty());
}

TEST(Font, KnowsLatin1AndSurvivesAnyBytes) {
  const Font font(16);
  EXPECT_EQ(font.width("abc"), 3 * font.advance());
  EXPECT_EQ(font.width("\xc2\xb7"), font.advance());
  EXPECT_EQ(decode_utf8("a\xe2\x82\xac"), (std::vector<char32_t>{'a', 0x20ac}));
  EXPECT_EQ(decode_utf8("\xff\xc3"), (std::vector<char32_t>{0xfffd, 0xfffd}));
  for (char32_t code = 33; code < 127; ++code)
    EXPECT_GT(font.glyph(code).width, 0) << static_cast<char>(code);
}

TEST(Palette, PopulationsGetLighterAndStayInRange) {
  const auto lightness = [](Color c) { return 2 * c.r + 5 * c.g + c.b; };
  int last = -1;
  for (std::uint32_t population = 0; population <= 64; ++population) {
    const int now = lightness(palette::population_color(population, 64));
    EXPECT_GE(now, last) << population;
    last = now;
  }
  EXPECT_EQ(palette::population_color(100, 64), palette::population_color(64, 64));
  EXPECT_EQ(palette::population_color(5, 0), palette::population_color(0, 64));
}

}  // namespace
}  // namespace kerf
