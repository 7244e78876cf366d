#include "frames/sequence/recording_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "core/query/search.h"
#include "core/trace/event_facts.h"
#include "frames/support/parse_expression.h"
#include "tests/frames/program.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

/// A recording of terrain in which operators of all kinds act.
class RecordingPicture : public ::testing::Test {
 protected:
  RecordingPicture() {
    const test::RunOutcome recorded =
        test::run_kerf({"record", "terrain", "-o", file(), "--steps", "60", "--objects", "500", "--grow",
                        "100", "--config", "swap_share=1"});
    EXPECT_EQ(recorded.exit, 0) << recorded.err;
    cursor_ = std::make_unique<Cursor<3>>(std::make_shared<RecordingReader<3>>(file()));
  }

  [[nodiscard]] std::string file() const { return folder_.path() / "a.kerf"; }
  [[nodiscard]] Cursor<3>& cursor() { return *cursor_; }
  void go_to(const std::string& condition) {
    Search<3> search(std::make_shared<RecordingReader<3>>(file()));
    const auto found = search.forward(parse_expression("--to", condition), Position::end_of(0));
    ASSERT_TRUE(found);
    cursor_->go(*found);
  }
  /// All that is written in the picture of the moment.
  std::vector<std::string> texts() {
    FrameOptions options;
    options.layers = kRecordedLayers;
    options.ids = true;
    FrameRenderer<3> renderer(options);
    (void)render_moment(*cursor_, renderer);
    std::vector<std::string> texts;
    for (const DrawnText& text : renderer.ids().list.texts) texts.push_back(text.text);
    return texts;
  }

 private:
  test::TemporaryFolder folder_;
  std::unique_ptr<Cursor<3>> cursor_;
};

/// A swap removes its node, whose place only the tree before it knows.
TEST_F(RecordingPicture, ASwapIsMarkedWhereItsNodeWas) {
  go_to("op==swap && kind==acted");
  const Event event = cursor().event().value();
  const std::string label = "swap n" + std::to_string(acted_of(event)->node.node.value);
  EXPECT_THAT(texts(), Contains(label));
  cursor().go_to_step(cursor().position().step + 3);
  EXPECT_THAT(texts(), Contains(label)) << "it has not faded yet";
}

/// In the middle of a step the pairs are still those of the step before.
TEST_F(RecordingPicture, TheCaptionSaysOfWhichStepItsPairsAre) {
  go_to("op==swap && kind==acted");
  const std::uint32_t step = cursor().position().step;
  const auto found = [&](std::uint32_t swept) {
    return std::to_string(cursor().recording().row(swept).pairs);
  };
  EXPECT_THAT(texts(), Contains(HasSubstr("(pairs: of step " + std::to_string(step - 1) + ")")));
  EXPECT_THAT(texts(), Contains(EndsWith(found(step - 1))));
  cursor().go_to_step(step);
  EXPECT_THAT(texts(), Contains(EndsWith(found(step))));
  EXPECT_THAT(texts(), Not(Contains(HasSubstr("of step "))));
}

/// The number that follows a word of the caption.
std::string value_of(const std::vector<std::string>& texts, const std::string& word) {
  const auto at = std::ranges::find(texts, word);
  return at == texts.end() || at + 1 == texts.end() ? "none" : *(at + 1);
}

/// The count of leaves is that of the tree in the picture, not of the tree at the end of the step.
TEST_F(RecordingPicture, TheCaptionIsOfTheMomentNotOfItsStepsEnd) {
  go_to("op==split && kind==acted");
  const std::uint32_t step = cursor().position().step;
  const std::uint32_t before = cursor().recording().row(step - 1).statistics.leaves;
  ASSERT_NE(cursor().recording().row(step).statistics.leaves, before);
  EXPECT_THAT(value_of(texts(), "leaves"), EndsWith(" " + std::to_string(before + 1)));
  go_to("step==" + std::to_string(step) + " && kind==placed");
  EXPECT_THAT(value_of(texts(), "leaves"), EndsWith(" " + std::to_string(before))) << "it was not split yet";
}

/// Two moments have the same colour for the same population.
TEST_F(RecordingPicture, TheScaleOfColoursIsThatOfTheWholeRecording) {
  const auto scale = [&](std::uint32_t step) {
    cursor().go_to_step(step);
    const std::vector<std::string> all = texts();
    const auto found = std::ranges::find_if(
        all, [](const std::string& text) { return text.find("in a leaf of 0-") != std::string::npos; });
    return found == all.end() ? "none" : *found;
  };
  const std::string early = scale(6);
  EXPECT_NE(early, "none");
  EXPECT_EQ(scale(60), early);
}

TEST_F(RecordingPicture, NothingIsSaidOfContactsThatNoRecordingHolds) {
  cursor().go_to_step(40);
  EXPECT_THAT(texts(), Not(Contains(HasSubstr("contact"))));
  EXPECT_THAT(texts(), Contains("pair"));
}

/// An engine that misses the pair of 0 and 1 in step 2, and invents two others.
std::filesystem::path import_errors(const test::TemporaryFolder& folder) {
  std::ofstream(folder.path() / "boxes.csv")
      << "step,object,min_x,max_x,min_y,max_y\n1,0,0,2,0,2\n1,1,1,3,1,3\n1,2,6,8,0,2\n2,2,6,8,1,3\n";
  std::ofstream(folder.path() / "pairs.csv") << "step,a,b\n1,0,1\n2,0,2\n2,1,2\n";
  const std::filesystem::path file = folder.path() / "theirs.kerf";
  const test::RunOutcome imported = test::run_kerf(
      {"import", folder.path() / "boxes.csv", "--pairs", folder.path() / "pairs.csv", "-o", file});
  EXPECT_THAT(imported.out, HasSubstr("1 missed, 2 extra")) << imported.err;
  return file;
}

/// A recording with wrong pairs looked like one without.
TEST(PictureOfAnImport, ShowsWhatTheOtherEngineGotWrong) {
  const test::TemporaryFolder folder;
  Cursor<2> cursor(std::make_shared<RecordingReader<2>>(import_errors(folder)));
  FrameOptions options;
  options.layers = kRecordedLayers;
  options.ids = true;
  FrameRenderer<2> renderer(options);
  const auto pixels_of = [&](Color color) {
    const Image& image = render_moment(cursor, renderer);
    std::size_t count = 0;
    for (std::size_t k = 0; k < image.rgba.size(); k += 4)
      count += image.rgba[k] == color.r && image.rgba[k + 1] == color.g && image.rgba[k + 2] == color.b;
    return count;
  };
  const auto texts = [&] {
    std::vector<std::string> all;
    for (const DrawnText& text : renderer.ids().list.texts) all.push_back(text.text);
    return all;
  };
  cursor.go_to_step(1);
  const std::size_t in_the_legend = pixels_of(palette::kMissed);
  EXPECT_EQ(value_of(texts(), "they missed"), "   0");
  cursor.go_to_step(2);
  EXPECT_GT(pixels_of(palette::kMissed), in_the_legend + 100);
  EXPECT_GT(pixels_of(palette::kExtra), in_the_legend + 100);
  EXPECT_EQ(value_of(texts(), "they missed"), "   1");
  EXPECT_EQ(value_of(texts(), "extra"), "   2");
}

TEST(PictureOfAnImport, ItsFilmSaysTheSame) {
  const test::TemporaryFolder folder;
  const test::RunOutcome rendered =
      test::run_kerf({"render", import_errors(folder), "--out", folder.path() / "out", "--ids", "--steps",
                      "1:2:1", "--workers", "1"});
  ASSERT_EQ(rendered.exit, 0) << rendered.err;
  EXPECT_THAT(rendered.out, EndsWith("out: 2 frames\n"));
  EXPECT_THAT(test::read_text(folder.path() / "out/theirs_000001.draw.json"),
              AllOf(HasSubstr("\"   1\""), HasSubstr("\"   2\"")));
}

/// Of a scene there is nothing to judge.
TEST_F(RecordingPicture, NothingIsSaidOfAnotherEngineWhereThereIsNone) {
  cursor().go_to_step(40);
  EXPECT_THAT(texts(), Not(Contains("missed")));
}

}  // namespace
}  // namespace kerf
