#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Sixty objects that rest, and one that falls for ever or lies far away.
class FramingProgram : public ::testing::TestWithParam<int> {
 protected:
  void import(const std::string& last, int steps) const {
    const bool deep = GetParam() == 3;
    std::ofstream csv(path("boxes.csv"));
    csv << "step,object,min_x,max_x,min_y,max_y" << (deep ? ",min_z,max_z" : "") << "\n";
    const char* const depth = deep ? ",0,1" : "";
    for (int k = 0; k < 60; ++k) {
      const double x = k % 10 * 1.3;
      const double y = k / 10 * 1.3;
      csv << "1," << k << "," << x << "," << x + 1 << "," << y << "," << y + 1 << depth << "\n";
    }
    if (!last.empty()) csv << "1,60," << last << depth << "\n";
    for (int step = 1; step <= steps; ++step) {
      const double y = -4.905 * step * step / 3600;
      csv << step << ",60,15,16," << y << "," << y + 1 << depth << "\n";
    }
    csv.close();
    const RunOutcome outcome = run_kerf({"import", path("boxes.csv"), "-o", path("a.kerf"), "--overwrite"});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
  }
  void render(const std::string& steps, const std::string& out, const std::string& camera = "") const {
    std::vector<std::string> command{"render",  path("a.kerf"), "--steps", steps,    "--size",
                                     "640x360", "--ids",        "--out",   path(out)};
    if (!camera.empty()) command.insert(command.end(), {"--camera", camera});
    const RunOutcome outcome = run_kerf(command);
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
  /// Pixels that objects cover in a frame.
  [[nodiscard]] int covered(const std::string& frame) const {
    int pixels = 0;
    const auto json = read_json(path(frame + ".draw.json"));
    for (const auto& item : json["items"])
      if (item[0] == "object") pixels += item[8].get<int>();
    return pixels;
  }

 private:
  TemporaryFolder folder_;
};

TEST_P(FramingProgram, WhatFallsForEverDoesNotEmptyTheFilm) {
  import("", 1200);
  render("1:1200:400", "f");
  const int first = covered("f/a_000000");
  EXPECT_GT(first, 640 * 360 / 50);
  EXPECT_GT(covered("f/a_000002"), first * 9 / 10);
  EXPECT_THAT(read_text(path("f/a_000000.draw.json")), HasSubstr("outside")) << "captions do not jump";
  EXPECT_THAT(read_text(path("f/a_000002.draw.json")), HasSubstr("\"    1\""));
}

TEST_P(FramingProgram, WhatLiesFarAwayIsSaidAndSeenIfAskedFor) {
  import("9e8,9e8,0,1", 0);
  render("1", "most");
  EXPECT_GT(covered("most/a_000000"), 640 * 360 / 50);
  EXPECT_THAT(read_text(path("most/a_000000.draw.json")), HasSubstr("outside"));
  render("1", "all", "all");
  EXPECT_LT(covered("all/a_000000"), 640 * 360 / 500);
  EXPECT_THAT(read_text(path("all/a_000000.draw.json")), Not(HasSubstr("outside")));
}

/// Its sides are so far away that floats do not hold them.
TEST_P(FramingProgram, WhatIsHugeCoversAllThatLiesInIt) {
  if (GetParam() == 3) GTEST_SKIP() << "in 3D the camera is within it";
  import("-1e9,1e9,-1e9,1e9", 0);
  render("1", "f");
  EXPECT_GT(covered("f/a_000000"), 640 * 360 * 2 / 3);
}

TEST_P(FramingProgram, AnOrdinaryFilmSaysNothing) {
  import("", 0);
  render("1", "f");
  EXPECT_THAT(read_text(path("f/a_000000.draw.json")), Not(HasSubstr("outside")));
}

INSTANTIATE_TEST_SUITE_P(Dimensions, FramingProgram, ::testing::Values(2, 3));

}  // namespace
}  // namespace kerf::test
