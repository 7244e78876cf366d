#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <sstream>

#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "tests/frames/report/browser.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// One page for all tests: it takes seconds.
class ExperimentPage : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    outcome_ = test::run_kerf({"experiment", "--steps", "60", "--objects", "60", "--seeds", "3", "--out",
                               folder_->path().string()});
  }
  static void TearDownTestSuite() { folder_.reset(); }
  void SetUp() override { ASSERT_EQ(outcome_.exit, kExitHolds) << outcome_.err; }
  [[nodiscard]] static std::filesystem::path page() { return folder_->path() / "experiment.html"; }
  /// What the page is like after `act`, with nothing wrong.
  static Sight seen(const std::string& act) {
    const Sight sight = look_at(page(), act);
    EXPECT_EQ(sight.trouble, "");
    EXPECT_THAT(sight.console, IsEmpty());
    return sight;
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline test::RunOutcome outcome_;
};

TEST_F(ExperimentPage, StandsAloneInABrowser) {
  const std::string text = test::read_text(page());
  EXPECT_THAT(text, Not(HasSubstr("src=")));
  EXPECT_THAT(text, Not(HasSubstr("<script")));
  const Sight sight = seen("");
  EXPECT_THAT(sight.resources, IsEmpty());
  EXPECT_TRUE(sight.fits);
  std::size_t panels = 0;
  for (const Sight::Picture& picture : sight.pictures) {
    if (picture.width < 100) continue;  // of the legend
    EXPECT_GT(picture.width, 450);
    EXPECT_GT(picture.shapes, 20U);
    ++panels;
  }
  EXPECT_EQ(panels, 44U) << "seven rows, and four of the readings, for each of four simulations";
}

TEST_F(ExperimentPage, StatementsHaveVerdicts) {
  const std::string rows = seen(
                               "return [...document.querySelectorAll('#statements ~ details tr')].map(row => "
                               "row.cells[3] ? row.cells[3].textContent : '').join('|')")
                               .answer;
  EXPECT_THAT(rows, HasSubstr("holds"));
  EXPECT_THAT(rows, HasSubstr("opposite"));
  EXPECT_THAT(rows, HasSubstr("cannot be judged"));
}

/// Titles and labels are inside their pictures.
TEST_F(ExperimentPage, NoTextIsCutOff) {
  const char* act = R"(return [...document.querySelectorAll(".panels > svg")].flatMap(svg => {
      const frame = svg.getBoundingClientRect();
      return [...svg.querySelectorAll("text")].filter(text => !text.closest(".values")).filter(text => {
        const box = text.getBoundingClientRect();
        return box.top < frame.top || box.bottom > frame.bottom || box.left < frame.left || box.right > frame.right;
      }).map(text => text.textContent);
    }).join("|");)";
  EXPECT_EQ(seen(act).answer, "");
}

/// The style shows them under a pointer; here it is applied to one strip, as a pointer would.
TEST_F(ExperimentPage, AStripHasTheValuesOfAllCurvesInsideThePicture) {
  const char* act = R"(
    const shown = getComputedStyle(document.querySelector(".values text")).visibility;
    const rules = [...document.styleSheets[0].cssRules].map(rule => rule.selectorText || "");
    const strips = document.querySelectorAll(".panels > svg:nth-child(5) .values a");
    const last = strips[strips.length - 1];
    const frame = last.ownerSVGElement.getBoundingClientRect();
    const box = last.querySelector("rect.paper").getBoundingClientRect();
    const inside = box.left >= frame.left && box.right <= frame.right && box.top >= frame.top;
    return [shown, rules.some(rule => rule.includes("g:hover")), inside,
            [...last.querySelectorAll("text")].map(text => text.textContent).join(";")].join("|");)";
  const std::string answer = seen(act).answer;
  EXPECT_THAT(answer, HasSubstr("hidden|true|true|step "));
  for (const char* curve : {"BSP 0.", "QT 0.", "SH 0.", "LO 0.", "SP 0.", " ms", " to "})
    EXPECT_THAT(answer, HasSubstr(curve));
}

/// A click leads to the row of the step, and opens the table around it.
TEST_F(ExperimentPage, AStripLeadsToItsMomentAndTheCommandThatShowsIt) {
  const char* act = R"(
    const links = [...document.querySelectorAll(".values a")];
    const dead = links.filter(link => !document.querySelector(link.getAttribute("href")));
    const row = document.querySelector(links[3].getAttribute("href"));
    return [links.length > 300, dead.length, row.textContent].join("|");)";
  const std::string answer = seen(act).answer;
  EXPECT_THAT(answer, HasSubstr("true|0|"));
  EXPECT_THAT(answer, HasSubstr("kerf step simulation-1-terrain.kerf --to step=="));
  EXPECT_THAT(test::read_text(page()), HasSubstr("kerf record terrain -o simulation-1-terrain.kerf"));
}

/// The words of a command on the page after "kerf", with the recording in the folder of the test.
std::vector<std::string> words_of(const std::string& text, const std::string& begin, const std::string& file,
                                  const std::filesystem::path& folder) {
  const std::size_t at = text.find(begin);
  std::istringstream words(text.substr(at, text.find('<', at) - at));
  std::vector<std::string> arguments;
  for (std::string word; words >> word;) arguments.push_back(word == file ? (folder / word).string() : word);
  arguments.erase(arguments.begin());
  return arguments;
}

/// The recording that the page's command makes is the run: it has the figures of the table at that step.
TEST_F(ExperimentPage, ItsCommandsShowTheMomentOfTheRun) {
  const std::string text = test::read_text(page());
  const std::string file = "simulation-1-terrain.kerf";
  ASSERT_EQ(run_kerf(words_of(text, "kerf record terrain", file, folder_->path())).exit, kExitHolds);
  std::vector<std::string> step =
      words_of(text, "kerf step " + file + " --to step==53", file, folder_->path());
  step.resize(step.size() - 2);  // without its picture
  const test::RunOutcome shown = run_kerf(step);
  ASSERT_EQ(shown.exit, kExitHolds) << shown.err;
  const std::string answer = seen(R"(return [...document.getElementById("moment-1-53").cells]
      .map(cell => cell.textContent).join(" ");)")
                                 .answer;
  std::istringstream row(answer);
  std::string number;
  std::string pairs;
  std::string contacts;
  std::string depth;
  std::string leaves;
  std::string moving;
  row >> number >> moving >> pairs >> contacts >> depth >> leaves;
  EXPECT_EQ(number, "53");
  EXPECT_THAT(shown.out, HasSubstr(" " + pairs + " pairs, height " + depth + ", " + leaves + " leaves"));
}

}  // namespace
}  // namespace kerf::test
