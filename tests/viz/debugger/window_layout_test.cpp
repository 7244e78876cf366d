#include "viz/debugger/window/window_layout.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/support/default_window.h"
#include "viz/debugger/window/drop.h"
#include "viz/debugger/window/window_settings.h"

namespace kerf {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::vector<PanelId>> tabs(const WindowLayout& layout, PanelPlace place) {
  std::vector<std::vector<PanelId>> all;
  for (const PanelCell& cell : layout.cells(place)) all.push_back(cell.tabs);
  return all;
}

constexpr auto kLeft = PanelPlace::left;
constexpr auto kRight = PanelPlace::right;
constexpr auto kBelow = PanelPlace::below;

/// The areas of a fixed arrangement, before panels could be moved.
TEST(WindowLayout, TheDefaultFillsTheWindowAtEverySize) {
  struct Expected {
    int width, height;
    PanelArea tree, icicle, events, why, view, timeline;
  };
  for (const Expected& at : {Expected{960,
                                      600,
                                      {0, 58, 210, 132},
                                      {0, 190, 210, 79},
                                      {542, 58, 418, 118},
                                      {542, 176, 418, 212},
                                      {210, 164, 332, 224},
                                      {0, 388, 960, 212}},
                             Expected{1280,
                                      720,
                                      {0, 58, 243, 180},
                                      {0, 238, 243, 108},
                                      {852, 58, 428, 162},
                                      {852, 220, 428, 288},
                                      {243, 116, 609, 392},
                                      {0, 508, 1280, 212}},
                             Expected{1920,
                                      1080,
                                      {0, 58, 330, 288},
                                      {0, 346, 330, 173},
                                      {1360, 58, 560, 259},
                                      {1360, 317, 560, 463},
                                      {330, 116, 1030, 664},
                                      {0, 780, 1920, 300}}}) {
    SCOPED_TRACE(at.width);
    const test::DefaultWindow window(at.width, at.height);
    EXPECT_EQ(window.area(PanelId::tree), at.tree);
    EXPECT_EQ(window.area(PanelId::icicle), at.icicle);
    EXPECT_EQ(window.area(PanelId::events), at.events);
    EXPECT_EQ(window.area(PanelId::why), at.why);
    EXPECT_EQ(window.area(PanelId::tables), at.why);
    EXPECT_EQ(window.all().view, at.view);
    EXPECT_EQ(window.area(PanelId::timeline), at.timeline);
  }
}

TEST(WindowLayout, MovesAPanelBesideACellOrIntoItAsATab) {
  WindowLayout layout;
  layout.move(PanelId::icicle, {{kRight, 0}, DropSide::before});
  EXPECT_THAT(tabs(layout, kLeft),
              ElementsAre(ElementsAre(PanelId::tree), ElementsAre(PanelId::breakpoints)));
  EXPECT_EQ(tabs(layout, kRight)[0], std::vector{PanelId::icicle});
  layout.move(PanelId::why, {{kLeft, 1}, DropSide::tab});
  EXPECT_EQ(tabs(layout, kLeft)[1], (std::vector{PanelId::breakpoints, PanelId::why}));
  EXPECT_TRUE(layout.is_in_front(PanelId::why));
  layout.move(PanelId::events, {{kBelow, 0}, DropSide::after});
  EXPECT_THAT(tabs(layout, kBelow),
              ElementsAre(ElementsAre(PanelId::timeline), ElementsAre(PanelId::events)));
  layout.move(PanelId::breakpoints, {{kLeft, 1}, DropSide::before});
  EXPECT_THAT(tabs(layout, kLeft), ElementsAre(ElementsAre(PanelId::tree), ElementsAre(PanelId::breakpoints),
                                               ElementsAre(PanelId::why)));
}

TEST(WindowLayout, AMovedPanelSharesTheRoomOfItsNeighbour) {
  WindowLayout layout;
  layout.move(PanelId::timeline, {{kRight, 0}, DropSide::after});
  const auto& cells = layout.cells(kRight);
  EXPECT_FLOAT_EQ(cells[0].share, 0.18F);
  EXPECT_FLOAT_EQ(cells[1].share, 0.18F);
  EXPECT_TRUE(layout.cells(kBelow).empty());
}

TEST(WindowLayout, AClosedPanelIsShownWhereItWas) {
  WindowLayout layout;
  for (const PanelId panel : {PanelId::icicle, PanelId::ballot, PanelId::timeline}) layout.close(panel);
  EXPECT_FALSE(layout.find(PanelId::ballot));
  for (const PanelId panel : {PanelId::timeline, PanelId::icicle, PanelId::ballot}) layout.show(panel);
  EXPECT_THAT(tabs(layout, kLeft), ElementsAre(ElementsAre(PanelId::tree), ElementsAre(PanelId::icicle),
                                               ElementsAre(PanelId::breakpoints)));
  EXPECT_EQ(layout.find(PanelId::ballot), layout.find(PanelId::why));
  EXPECT_TRUE(layout.is_in_front(PanelId::ballot));
  EXPECT_EQ(layout.cells(kLeft), WindowLayout().cells(kLeft));
  EXPECT_EQ(layout.cells(kBelow), WindowLayout().cells(kBelow));
}

TEST(WindowLayout, AllPanelsCanBeClosedAndShownAgain) {
  WindowLayout layout;
  for (std::size_t k = 0; k < kPanelCount; ++k) layout.close(static_cast<PanelId>(k));
  const Arrangement empty = arrange(layout, {1280, 720, 0});
  EXPECT_TRUE(empty.cells.empty());
  EXPECT_TRUE(empty.dividers.empty());
  EXPECT_EQ(empty.view, (PanelArea{0, 116, 1280, 604}));
  for (std::size_t k = 0; k < kPanelCount; ++k) layout.show(static_cast<PanelId>(k));
  for (const PanelPlace place : kPanelPlaces) EXPECT_EQ(tabs(layout, place), tabs(WindowLayout(), place));
}

/// Cells, tools, transport and view cover the window, and none lies over another.
void expect_tiled(const Arrangement& all) {
  std::vector<PanelArea> parts{all.transport, all.tools, all.view};
  for (const ArrangedCell& cell : all.cells) parts.push_back(cell.area);
  float covered = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const PanelArea& a = parts[k];
    EXPECT_GT(a.width, 0);
    EXPECT_GT(a.height, 0);
    covered += a.width * a.height;
    for (std::size_t other = 0; other < k; ++other) {
      const PanelArea& b = parts[other];
      EXPECT_TRUE(a.right() <= b.x || b.right() <= a.x || a.bottom() <= b.y || b.bottom() <= a.y)
          << other << " and " << k;
    }
  }
  EXPECT_FLOAT_EQ(covered, all.size.width * all.size.height);
}

TEST(WindowLayout, EveryLayoutTilesTheWindow) {
  WindowLayout layout;
  const auto check = [&] {
    for (const auto& [width, height] : {std::pair(960.0F, 600.0F), std::pair(1280.0F, 720.0F),
                                        std::pair(1093.0F, 577.0F), std::pair(2560.0F, 1440.0F)})
      expect_tiled(arrange(layout, {width, height, 0}));
  };
  check();
  layout.move_to_end(PanelId::timeline, kRight);
  check();
  layout.move_to_end(PanelId::timeline, kBelow);
  layout.move_to_end(PanelId::events, kBelow);
  layout.move_to_end(PanelId::tree, kRight);
  layout.set_extent(kLeft, 0.5F);
  layout.set_extent(kRight, 0.5F);
  layout.set_extent(kBelow, 0.9F);
  check();
  layout.move(PanelId::breakpoints, {{kRight, 0}, DropSide::tab});
  layout.close(PanelId::icicle);
  check();
}

const Divider& divider(const Arrangement& all, const std::string& name) {
  for (const Divider& divider : all.dividers)
    if (divider.name == name) return divider;
  throw std::invalid_argument("no " + name);
}

TEST(WindowLayout, ADividerIsDraggedAsFarAsPanelsHaveRoom) {
  WindowLayout layout;
  const WindowSize size{1280, 720, 0};
  const auto drag = [&](const std::string& name, float x, float y) {
    const Arrangement all = arrange(layout, size);
    drag_divider(layout, all, divider(all, name), x, y);
    return arrange(layout, size);
  };
  EXPECT_EQ(drag("divider left", 400, 0).view.x, 400);
  EXPECT_EQ(drag("divider left", 5, 0).view.x, 180);
  EXPECT_EQ(drag("divider left", 1270, 0).view.x, 852 - 250);
  EXPECT_EQ(drag("divider left", 300, 0).view.x, 300);
  EXPECT_EQ(drag("divider right", 700, 0).view.right(), 700);
  EXPECT_EQ(drag("divider below", 0, 400).view.bottom(), 400);
  EXPECT_EQ(drag("divider below", 0, 719).view.bottom(), 720 - 212);
  EXPECT_EQ(drag("divider left 1", 0, 270).find({kLeft, 1})->y, 270);
  EXPECT_EQ(drag("divider left 1", 0, 10).find({kLeft, 1})->y, 58 + 64);
  EXPECT_EQ(drag("divider right 1", 0, 300).find({kRight, 1})->y, 300);
}

TEST(WindowLayout, AResetDividerIsWhereItWas) {
  WindowLayout layout;
  const WindowSize size{1280, 720, 0};
  for (const std::string name : {"divider left", "divider right", "divider below", "divider left 2"}) {
    const Arrangement all = arrange(layout, size);
    drag_divider(layout, all, divider(all, name), 640, 400);
    EXPECT_NE(layout, WindowLayout()) << name;
    reset_divider(layout, divider(all, name));
    EXPECT_EQ(layout, WindowLayout()) << name;
  }
}

TEST(WindowLayout, ADropGoesBesideOrIntoTheCellUnderTheMouse) {
  WindowLayout layout;
  const Arrangement all = arrange(layout, {1280, 720, 0});
  const auto drop = [&](PanelId panel, float x, float y) -> std::optional<DropTarget> {
    const auto found = drop_at(layout, all, panel, x, y);
    return found ? std::optional(found->target) : std::nullopt;
  };
  EXPECT_EQ(drop(PanelId::tree, 1000, 70), (DropTarget{{kRight, 0}, DropSide::before}));
  EXPECT_EQ(drop(PanelId::tree, 1000, 140), (DropTarget{{kRight, 0}, DropSide::tab}));
  EXPECT_EQ(drop(PanelId::tree, 1000, 210), (DropTarget{{kRight, 0}, DropSide::after}));
  EXPECT_EQ(drop(PanelId::tree, 100, 600), (DropTarget{{kBelow, 0}, DropSide::before}));
  EXPECT_EQ(drop(PanelId::tree, 1200, 600), (DropTarget{{kBelow, 0}, DropSide::after}));
  EXPECT_EQ(drop(PanelId::why, 1000, 230), (DropTarget{{kRight, 1}, DropSide::before}));
  EXPECT_EQ(drop(PanelId::why, 1000, 360), std::nullopt) << "it is a tab there already";
  EXPECT_EQ(drop(PanelId::tree, 100, 100), std::nullopt) << "alone in its cell";
  EXPECT_EQ(drop(PanelId::tree, 250, 300), std::nullopt) << "the left column is there";
}

TEST(WindowLayout, ADropAtTheEdgeOfTheViewMakesAColumn) {
  WindowLayout layout;
  for (const PanelId panel : {PanelId::tree, PanelId::icicle, PanelId::breakpoints, PanelId::timeline})
    layout.close(panel);
  const Arrangement all = arrange(layout, {1280, 720, 0});
  const auto left = drop_at(layout, all, PanelId::why, 30, 300);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->target.cell.place, kLeft);
  const auto below = drop_at(layout, all, PanelId::why, 400, 700);
  ASSERT_TRUE(below);
  EXPECT_EQ(below->target.cell.place, kBelow);
  layout.move(PanelId::why, left->target);
  EXPECT_EQ(tabs(layout, kLeft)[0], std::vector{PanelId::why});
}

TEST(WindowSettings, TextIsReadBackAsTheSame) {
  WindowSettings settings;
  EXPECT_EQ(parse_window_settings(to_text(settings)), settings);
  settings.layout.move_to_end(PanelId::what_if, kLeft);
  settings.layout.move(PanelId::tree, {{kRight, 1}, DropSide::tab});
  settings.layout.close(PanelId::lint);
  settings.layout.set_extent(kLeft, 0.25F);
  settings.zoom = 1.25;
  settings.theme = ThemeName::dark;
  EXPECT_EQ(parse_window_settings(to_text(settings)), settings);
}

std::string problem_of(const std::string& text) {
  try {
    parse_window_settings(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(WindowSettings, DamageIsNamed) {
  const std::string good = to_text(WindowSettings{});
  EXPECT_EQ(problem_of(good), "none");
  EXPECT_THAT(problem_of(good.substr(0, good.size() - 4)), HasSubstr("its end is missing"));
  EXPECT_THAT(problem_of(good + "zoom 99\n"), HasSubstr("the zoom is from 0.75 to 3"));
  EXPECT_THAT(problem_of(good + "zoom nan\n"), HasSubstr("the zoom is from"));
  EXPECT_THAT(problem_of(good + "theme pink\n"), HasSubstr("'theme pink': 'pink' is unknown"));
  EXPECT_THAT(problem_of(good + "size left 2\n"), HasSubstr("no share between 0 and 1"));
  EXPECT_THAT(problem_of(good + "cell left 1 0 Tree\n"), HasSubstr("Tree is there twice"));
  EXPECT_THAT(problem_of(good + "cell left 1 0 Forest\n"), HasSubstr("no panel 'Forest'"));
  EXPECT_THAT(problem_of("cell left 1 1 Tree\nend\n"), HasSubstr("no such tab in front"));
  EXPECT_THAT(problem_of("cell left 0 0 Tree\nend\n"), HasSubstr("not above 0"));
  EXPECT_THAT(problem_of("cell left 1 0\nend\n"), HasSubstr("has no panel"));
  EXPECT_THAT(problem_of("\x7f"
                         "ELF\n"),
              HasSubstr("line 1"));
}

TEST(WindowSettings, ZoomGoesByStepsAndHasEnds) {
  WindowSettings settings;
  settings.zoom_by(true);
  EXPECT_DOUBLE_EQ(settings.zoom, 1.1);
  settings.zoom_by(false);
  EXPECT_DOUBLE_EQ(settings.zoom, 1);
  for (int k = 0; k < 20; ++k) settings.zoom_by(true);
  EXPECT_DOUBLE_EQ(settings.zoom, 3);
  for (int k = 0; k < 20; ++k) settings.zoom_by(false);
  EXPECT_DOUBLE_EQ(settings.zoom, 0.75);
}

}  // namespace
}  // namespace kerf
