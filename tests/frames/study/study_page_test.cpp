#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/frames/study/study_files.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

/// They were one section, with an interval over the figures of both.
TEST(StudyPage, AMotionIsNotComparedWithTheSceneOfItsName) {
  const std::string more = R"("objects": [40], "broad_phases": ["kerf"], "warm_up": 2, "steps": 3})";
  const test::StudyFolder study(R"({"matrices": [{"motions": ["attractors"], "dimensions": [3], )" + more +
                                R"(, {"scenes": ["attractors"], )" + more + "]}");
  ASSERT_EQ(study.run({"-o", "@all"}).exit, kExitHolds);
  ASSERT_EQ(study.run({"--join", "@all", "-o", "@one"}).exit, kExitHolds);
  const std::string page = test::read_text(study.path("one/index.html"));
  EXPECT_THAT(page, HasSubstr("attractors (motion), 3D, 3 steps after 2"));
  EXPECT_THAT(page, HasSubstr("attractors (scene), 3D, 3 steps after 2"));
}

}  // namespace
}  // namespace kerf
