// What another engine got wrong, in the window: scene, keys, tabs and legend.

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/support/default_window.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/draw/palette.h"

namespace kerf::test {
namespace {

/// Pixels of exactly that colour in the view.
std::size_t pixels_of(Debugger& debugger, Color color) {
  const Image& image = debugger.picture();
  const PanelArea view = test::DefaultWindow(image.width, image.height).all().view;
  std::size_t count = 0;
  for (int y = 0; y < static_cast<int>(view.height); ++y)
    for (int x = 0; x < static_cast<int>(view.width); ++x) {
      const std::uint8_t* const p = image.pixel(x + static_cast<int>(view.x), y + static_cast<int>(view.y));
      count += p[0] == color.r && p[1] == color.g && p[2] == color.b ? 1U : 0U;
    }
  return count;
}

class ErrorsOfOthers : public testing::Test {
 protected:
  [[nodiscard]] TimelineDriver& driver() { return driver_; }
  [[nodiscard]] std::size_t pixels(Color color) { return pixels_of(driver_.debugger(), color); }

 private:
  TimelineDriver driver_{test::FaultyImport{40}};
};

TEST_F(ErrorsOfOthers, AreDrawnInTheirColoursAlsoWhenSelected) {
  ASSERT_EQ(driver().play("key End\nkey shift+,\nkey shift+,\nwait 2\nexpect step == 38"), "");
  EXPECT_EQ(pixels(palette::kMissed), 0U);
  EXPECT_EQ(pixels(palette::kExtra), 0U);
  ASSERT_EQ(driver().play("key shift+.\nwait 2\nexpect drawn_missed == 1\nexpect drawn_extra == 0"), "");
  EXPECT_GT(pixels(palette::kMissed), 40U);
  EXPECT_EQ(pixels(palette::kExtra), 0U);
  ASSERT_EQ(driver().play("key shift+.\nwait 2\nexpect drawn_missed == 1\nexpect drawn_extra == 1"), "");
  EXPECT_GT(pixels(palette::kMissed), 40U);
  EXPECT_GT(pixels(palette::kExtra), 40U);
  for (const char* const key : {"key W", "key shift+W"}) {
    ASSERT_EQ(driver().play(std::string(key) + "\nwait 2\nexpect selection ~ pair"), "");
    const bool missed = driver().debugger().model().message.find("missed") != std::string::npos;
    EXPECT_GT(pixels(missed ? palette::kMissed : palette::kExtra), 80U) << "the colour of a selected error";
  }
  ASSERT_EQ(driver().play("click pairs\nwait 2\nexpect drawn_missed == 0\nexpect drawn_extra == 0"), "");
  EXPECT_EQ(pixels(palette::kMissed), 0U);
}

TEST_F(ErrorsOfOthers, AreFoundByKeysAndButtons) {
  EXPECT_EQ(driver().play(R"(
expect judged_steps >= 40
expect wrong_steps == 2
expect errors == 4
expect error == none
key W
expect step == 39
expect error == 1
expect message ~ "error 1 of 4: pair"
expect message ~ "missed at step 39"
click "tab Oracle"
click "next error"
expect step == 40
expect error == 2
click "next error"
click "next error"
expect error == 4
key W
expect message == "there is no error further on"
click "previous error"
expect error == 3
key shift+W
key shift+W
expect step == 39
click "previous error"
expect message == "there is no error further back"
)"),
            "");
}

TEST_F(ErrorsOfOthers, HaveATableThatLeadsToThem) {
  EXPECT_EQ(driver().play(R"(
click "tab Oracle"
wait 2
click "all errors"
wait 3
expect table == errors
expect table_rows == 4
click "find in table"
type twice
wait 2
expect table_rows == 1
click "copy table"
expect copied ~ "pair,step,verdict"
expect copied ~ ",40,twice"
key Enter
)"),
            "");
  const std::string name = driver().debugger().facts().at("table_first");
  EXPECT_EQ(driver().play("click \"row " + name + " at 40\"\nexpect step == 40\nexpect selection == \"pair " +
                          name + "\"\nexpect message ~ twice"),
            "");
}

TEST_F(ErrorsOfOthers, AreNamedUnderTheMouse) {
  kerf::Run& run = driver().debugger().model().run();
  run.go(Position::end_of(40));
  const PairJudgement judgement = run.judgement();
  EXPECT_THAT(thing_words(run, judgement.missed.at(0)), testing::EndsWith(": missed by the other engine"));
  EXPECT_THAT(thing_words(run, judgement.extra.at(0)), testing::HasSubstr("reported by the other engine"));
  run.go(Position::end_of(38));
  EXPECT_THAT(thing_words(run, judgement.extra.at(0)), testing::StartsWith("pair "));
  EXPECT_THAT(thing_words(run, judgement.extra.at(0)), testing::Not(testing::HasSubstr(":")));
}

/// What touches only in the digits that were written is no error, and is listed.
TEST(UndecidedPairs, AreListedApart) {
  TimelineDriver driver(60,
                        "INSERT INTO their_steps VALUES(17, 5, 1, 0, 0, 0); "
                        "INSERT INTO their_verdicts VALUES(17, 0, 2, 'missed'), (17, 0, 1, 'undecided'); "
                        "INSERT INTO their_seals VALUES(17, 0); "
                        "UPDATE meta SET value='1' WHERE key='imported'");
  kerf::Run& run = driver.debugger().model().run();
  driver.debugger().model().go(Position::end_of(17));
  EXPECT_THAT(thing_words(run, Pair{{0}, {1}}), testing::HasSubstr(": undecided"));
  EXPECT_EQ(driver.play(R"(
expect errors == 1
expect wrong_steps == 1
click "tab Oracle"
wait 2
click "undecided 0"
expect selection == "pair 0,1"
expect step == 17
hover "panel oracle"
key ctrl+shift+c
expect copied ~ "undecided,0,1"
)"),
            "");
}

TEST_F(ErrorsOfOthers, AreInTheLegendOfAnImportOnly) {
  EXPECT_EQ(driver().play("welcome\nwait 2"), "");
  EXPECT_TRUE(driver().debugger().gui().find("legend missed").has_value());
  TimelineDriver own;
  EXPECT_EQ(own.play("welcome\nwait 2"), "");
  EXPECT_FALSE(own.debugger().gui().find("legend missed").has_value());
}

/// A first walk: open the window, find the step that took longest, find a missed pair, and why it is wrong.
/// Four actions.
TEST_F(ErrorsOfOthers, AreFoundAndExplainedInFiveActions) {
  EXPECT_EQ(driver().play(R"(
welcome
click "lane step ms"
key M
expect step > 0
key Home
key W
wait 2
expect step == 39
expect selection ~ pair
expect explanation ~ "missed"
)"),
            "");
}

TEST(ErrorsOfOurOwn, AreLookedForOnlyWhereTheOracleWasAsked) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
expect judged_steps == 1
key W
expect message == "none of the steps about which the oracle was asked has an error further on"
key T
wait 2
expect table == nodes
)"),
            "");
  EXPECT_FALSE(driver.debugger().gui().find("table errors").has_value());
}

}  // namespace
}  // namespace kerf::test
