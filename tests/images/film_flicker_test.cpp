#include "tests/images/film_flicker.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/frames/program.h"

namespace kerf {
namespace {

/// Films of the program, small and quick.
class Flicker : public ::testing::Test {
 protected:
  test::FilmFlicker film_of(const std::string& what, const std::vector<std::string>& more) const {
    std::vector<std::string> words{"render",     what,    "--steps",
                                   "4:200:4",    "--ids", "--size",
                                   "480x270",    "--out", (folder_.path() / "film").string(),
                                   "--overwrite"};
    words.insert(words.end(), more.begin(), more.end());
    const test::RunOutcome outcome = test::run_kerf(words);
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    return test::measure_flicker(folder_.path() / "film");
  }

  const std::vector<std::string> busy_{"--objects", "150",
                                       "--grow",    "100",
                                       "--config",  "min_threshold=8,max_threshold=32,schedule_interval=8"};

 private:
  test::TemporaryFolder folder_;
};

// A frame every four steps: what is highlighted for ten steps only would be gone after three frames.
TEST_F(Flicker, OperatorsStayForTenFramesUnlessNewerOnesTakeTheirPlace) {
  const test::FilmFlicker film = film_of("terrain", busy_);
  ASSERT_GE(film.lives.size(), 10U);
  EXPECT_GE(film.lives[film.lives.size() / 2], 5U);
  EXPECT_LE(film.lives.back(), 22U);
  EXPECT_LE(3 * film.label_jumps, film.labels);
}

TEST_F(Flicker, ColoursKeepTheirScaleAndNothingChangesWithoutACause) {
  auto quiet = busy_;
  quiet.insert(quiet.end(), {"--show", "-operators"});
  for (const std::string scene : {"terrain", "pile"}) {
    const test::FilmFlicker film = film_of(scene, quiet);
    EXPECT_EQ(film.scale_changes, 0U) << scene;
    EXPECT_GT(film.compared, 40U) << scene;
    EXPECT_GT(film.changed, 0U) << scene;
    EXPECT_LE(film.most_unexplained, 20U) << scene;
  }
}

}  // namespace
}  // namespace kerf
