// Every text of the window on the ground on which it is drawn, in both themes.

#include "viz/draw/contrast.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <map>
#include <set>

#include "tests/viz/debugger/timeline_driver.h"
#include "viz/draw/palette.h"
#include "viz/draw/theme.h"

namespace kerf::test {
namespace {

TEST(Contrast, IsThatOfTheGuidelines) {
  EXPECT_DOUBLE_EQ(contrast({0, 0, 0}, {255, 255, 255}), 21);
  EXPECT_DOUBLE_EQ(contrast({255, 255, 255}, {0, 0, 0}), 21);
  EXPECT_DOUBLE_EQ(contrast({77, 77, 77}, {77, 77, 77}), 1);
  EXPECT_NEAR(contrast({119, 119, 119}, {255, 255, 255}), 4.48, 0.01);  // the example of many guides
}

/// A letter on the screen: where, and in which colour.
struct Letter {
  float x;
  float y;
  Color ink;
};

Color color_of(ImU32 packed) {
  return {static_cast<std::uint8_t>(packed >> IM_COL32_R_SHIFT),
          static_cast<std::uint8_t>(packed >> IM_COL32_G_SHIFT),
          static_cast<std::uint8_t>(packed >> IM_COL32_B_SHIFT),
          static_cast<std::uint8_t>(packed >> IM_COL32_A_SHIFT)};
}

/// A window that is drawn later lies over the point.
bool is_covered(const ImDrawData& data, int list, const ImVec2& point) {
  for (int k = list + 1; k < data.CmdListsCount; ++k) {
    const ImGuiWindow* const above = ImGui::FindWindowByName(data.CmdLists[k]->_OwnerName);
    const bool covers = above != nullptr && (above->Flags & ImGuiWindowFlags_NoBackground) == 0;
    if (covers && above->Rect().Contains(point)) return true;
  }
  return false;
}

/// Takes the letters out of the layout that is to be drawn: the middle of each, if it is within its clip.
std::vector<Letter> take_letters() {
  std::set<std::pair<float, float>> corners;
  for (const ImFontGlyph& glyph : ImGui::GetFont()->Glyphs) corners.insert({glyph.U0, glyph.V0});
  std::vector<Letter> letters;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int k = 0; k < data.CmdListsCount; ++k) {
    ImDrawList& list = *data.CmdLists[k];
    for (const ImDrawCmd& command : list.CmdBuffer)
      for (unsigned i = 0; i + 5 < command.ElemCount; i += 3) {
        const ImDrawIdx* const index = &list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
        ImDrawVert* const a = &list.VtxBuffer[static_cast<int>(command.VtxOffset + index[0])];
        if (!corners.contains({a->uv.x, a->uv.y}) || (a->col >> IM_COL32_A_SHIFT) == 0) continue;
        const ImDrawVert& c = a[2];
        const ImVec2 middle{0.5F * (a->pos.x + c.pos.x), 0.5F * (a->pos.y + c.pos.y)};
        const bool is_seen = middle.x > command.ClipRect.x && middle.y > command.ClipRect.y &&
                             middle.x < command.ClipRect.z && middle.y < command.ClipRect.w;
        if (is_seen && !is_covered(data, k, middle))
          letters.push_back({middle.x, middle.y, color_of(a->col)});
        for (int corner = 0; corner < 4; ++corner) a[corner].col &= ~IM_COL32_A_MASK;
      }
  }
  return letters;
}

/// The pairs of ink and ground that have too little contrast, with a place of each.
std::map<std::string, std::string> faint_texts(Debugger& debugger) {
  const std::vector<Letter> letters = take_letters();
  EXPECT_GT(letters.size(), 500U);
  debugger.draw();
  const Image& ground = debugger.picture();
  std::map<std::string, std::string> faint;
  for (const Letter& letter : letters) {
    const std::uint8_t* const p = ground.pixel(static_cast<int>(letter.x), static_cast<int>(letter.y));
    const Color below{p[0], p[1], p[2]};
    Color ink = mix(below, letter.ink, letter.ink.a / 255.0);
    ink.a = 255;
    const double found = contrast(ink, below);
    if (found >= 4.5) continue;
    const auto text = [](Color c) {
      return std::to_string(c.r) + "," + std::to_string(c.g) + "," + std::to_string(c.b);
    };
    faint[text(ink) + " on " + text(below)] =
        std::to_string(found) + " at " + std::to_string(letter.x) + "," + std::to_string(letter.y);
  }
  return faint;
}

/// Every panel, with rows that are selected, under the mouse and neither, messages, cards and menus.
const std::vector<std::string>& looks() {
  static const std::vector<std::string> kLooks{
      "click condition\ntype \"op==split && kind==acted && step>20\"\nkey Enter\nkey Escape\nkey F5\nwait 2",
      "click \"tab Ballot\"\nhover \"candidate 1\"\nwait 2",
      "hover play\nwait 3",
      "click \"tab Algorithm\"\nwait 2",
      "click \"tab Oracle\"\nkey O\nwait 2",
      "click \"tab What if\"\nwait 2\nhover refuse\nwait 1",
      "click \"tab Compare\"\nwait 2",
      "click \"tab Lint\"\nwait 2",
      "key T\nclick \"row n1\"\nwait 2",
      "key H\nkey I\nhover n3\nwait 2",
      "key I\nkey H\nkey shift+T\ndouble object:40\nwait 2",
      "drag scrubber@0.1,0.5 scrubber@0.9,0.5 shift\nwait 2",
      "key R\nkey +\nkey +\nkey +\nkey +\nwait 2\nhover scrubber@0.5,0.5\nwait 2",
      "click \"go to\"\ntype nonsense\nkey Enter\nkey Escape\nwait 2",
      "click watch\ntype \"(\"\nkey Enter\nkey Escape\nwait 2",
      "key P\ntype \"n\"\nwait 2",
      "key Escape\nkey F1\nwait 2",
      "key Escape\nkey G\nwait 2",
      "key Escape\nkey F10\nwait 2\nkey Down\nwait 2",
      "key Escape\nclick \"menu tree\"\nwait 2\nhover \"menu right\"\nwait 2",
      "key Escape\nkey Home\nwelcome\nwait 2"};
  return kLooks;
}

TEST(Contrast, EveryTextCanBeReadInBothThemes) {
  for (const ThemeName theme : {ThemeName::light, ThemeName::dark}) {
    TimelineDriver driver(40);
    driver.debugger().window().theme = theme;
    for (const std::string& look : looks()) {
      ASSERT_EQ(driver.play(look), "");
      for (const auto& [colors, where] : faint_texts(driver.debugger()))
        ADD_FAILURE() << kThemeNames[static_cast<std::size_t>(theme)] << ": " << colors << ": " << where
                      << ", after " << look;
    }
  }
}

TEST(Contrast, ErrorsOfAnImportCanBeReadInBothThemes) {
  for (const ThemeName theme : {ThemeName::light, ThemeName::dark}) {
    TimelineDriver driver(test::FaultyImport{40});
    driver.debugger().window().theme = theme;
    for (const std::string look :
         {"key End\nkey W\nclick \"tab Oracle\"\nwait 2", "click \"all errors\"\nwait 2", "key G\nwait 2"}) {
      ASSERT_EQ(driver.play(look), "");
      for (const auto& [colors, where] : faint_texts(driver.debugger()))
        ADD_FAILURE() << kThemeNames[static_cast<std::size_t>(theme)] << ": " << colors << ": " << where
                      << ", after " << look;
    }
  }
}

/// Lines and areas that mean something, on the grounds on which they are drawn.
TEST(Contrast, MarksCanBeSeenInBothThemes) {
  for (const ThemeName name : {ThemeName::light, ThemeName::dark}) {
    const Theme& theme = theme_called(name);
    SCOPED_TRACE(kThemeNames[static_cast<std::size_t>(name)]);
    for (const Color& lane : palette::kLanes) EXPECT_GE(contrast(theme.mark(lane), theme.paper), 3);
    for (const Color color : {palette::kInk, palette::kFaintInk, palette::kPartitioner, palette::kCandidate,
                              palette::kOperator, palette::kSelected, palette::kSeries[2]})
      for (const Color& ground : {theme.paper, theme.scene, theme.panel}) {
        const Color mark = theme.mark(color);
        EXPECT_GE(contrast(mark, ground), color == palette::kSeries[2] ? 2.9 : 3)
            << int{mark.r} << "," << int{mark.g} << "," << int{mark.b} << " on " << int{ground.r};
      }
    EXPECT_GE(contrast(theme.divider, theme.panel), 3);
    EXPECT_GE(contrast(theme.mark(palette::kInk), palette::kExtra), 1.1) << "its edge";
  }
}

}  // namespace
}  // namespace kerf::test
