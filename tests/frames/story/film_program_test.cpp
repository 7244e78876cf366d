#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Options = std::map<std::string, std::string>;

/// Four seconds of twenty pictures, unless the options say otherwise.
std::vector<std::string> small_film(const std::string& subject, const std::string& out,
                                    const Options& options) {
  Options all = options;
  all.merge(Options{{"--size", "640x360"}, {"--fps", "5"}, {"--seconds", "4"}});
  std::vector<std::string> words{"film", subject, "-o", out};
  for (const auto& [name, value] : all) words.insert(words.end(), {name, value});
  return words;
}
std::vector<std::string> film_of_pile(const std::string& out, const Options& options) {
  Options all = options;
  all.merge(Options{{"--objects", "150"}, {"--grow", "50"}, {"--steps", "80"}});
  return small_film("pile", out, all);
}

/// The pictures do not depend on the processes that draw them.
TEST(FilmProgram, HasAllItsPicturesHoweverManyDraw) {
  const TemporaryFolder folder;
  const std::string alone = folder.path() / "alone.apng";
  const std::string shared = folder.path() / "shared.apng";
  const std::string still = folder.path() / "still.png";
  const RunOutcome outcome = run_kerf(film_of_pile(alone, {{"--workers", "0"}, {"--still", still}}));
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  ASSERT_EQ(run_kerf(film_of_pile(shared, {{"--workers", "3"}})).exit, kExitHolds);
  EXPECT_EQ(read_text(alone), read_text(shared));
  const RunOutcome probe = Process({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                    "stream=width,height,nb_read_frames", "-of", "csv=p=0", alone})
                               .wait();
  EXPECT_EQ(probe.out, "640,360,20\n") << probe.err;
  const Image picture = read_png(still);
  EXPECT_EQ(picture.width, 640);
  EXPECT_EQ(picture.height, 360);
  EXPECT_THAT(folder.files(), ::testing::SizeIs(3));
}

/// Of each picture its hash.
std::vector<std::string> hashes_of(const std::string& film) {
  std::istringstream lines(Process({"ffmpeg", "-v", "error", "-i", film, "-f", "framehash", "-"}).wait().out);
  std::vector<std::string> hashes;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("#")) hashes.push_back(line.substr(line.rfind(',') + 1));
  return hashes;
}

/// In 2D the camera does not turn, so that pictures at which time stands still differ by the plane alone.
TEST(FilmProgram, ShowsAPlaneOnItsWay) {
  const TemporaryFolder folder;
  const std::string film = folder.path() / "film.apng";
  ASSERT_EQ(run_kerf(film_of_pile(film, {})).exit, kExitHolds);
  const std::vector<std::string> hashes = hashes_of(film);
  ASSERT_EQ(hashes.size(), 20U);
  EXPECT_GE(std::set<std::string>(hashes.begin(), hashes.end()).size(), 19U);
}

TEST(FilmProgram, OfARecordingIsThatOfItsSteps) {
  const TemporaryFolder folder;
  const std::string recording = folder.path() / "terrain.kerf";
  ASSERT_EQ(
      run_kerf({"record", "terrain", "-o", recording, "--steps", "40", "--objects", "60", "--grow", "20"})
          .exit,
      kExitHolds);
  const std::string out = folder.path() / "film.gif";
  const RunOutcome outcome =
      run_kerf(small_film(recording, out, {{"--steps", "10:30"}, {"--beside", "sweep-and-prune"}}));
  EXPECT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(out));
  EXPECT_THAT(run_kerf(small_film(recording, folder.path() / "b.gif", {{"--objects", "3"}})).err,
              HasSubstr("of which that is settled"));
}

TEST(FilmProgram, MistakesAreExplained) {
  const TemporaryFolder folder;
  const std::string out = folder.path() / "film.gif";
  const auto refusal = [&](const Options& options) {
    const RunOutcome outcome = run_kerf(small_film("pile", out, options));
    EXPECT_EQ(outcome.exit, kExitUnusable);
    return outcome.err;
  };
  EXPECT_THAT(refusal({{"--beside", "loose-octre"}}), HasSubstr("did you mean 'loose-octree'"));
  EXPECT_THAT(refusal({{"--size", "320x200"}}), HasSubstr("640x360"));
  EXPECT_THAT(refusal({{"--steps", "5:5"}}), HasSubstr("two steps"));
  EXPECT_THAT(refusal({{"--broad-phase", "columns"}}), HasSubstr("kerf-paper or kerf"));
  EXPECT_THAT(refusal({{"--seconds", "0"}}), HasSubstr("--seconds"));
  EXPECT_THAT(folder.files(), IsEmpty());
  std::ofstream(folder.path() / "film.gif") << "mine";
  EXPECT_THAT(refusal({}), HasSubstr("exists already"));
  EXPECT_EQ(read_text(out), "mine");
}

TEST(FilmProgram, LeavesNothingWhenInterrupted) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "film.gif";
  const RunOutcome outcome =
      interrupt_kerf(film_of_pile(out, {{"--seconds", "900"}}), [&] { return !folder.files().empty(); });
  EXPECT_EQ(outcome.exit, kExitInterrupted) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("no film was made"));
  EXPECT_THAT(folder.files(), IsEmpty());
}

}  // namespace
}  // namespace kerf::test
