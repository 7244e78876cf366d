#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

RunOutcome render(const std::filesystem::path& out, const std::vector<std::string>& more,
                  const Surroundings& surroundings) {
  std::vector<std::string> arguments{"render",    "pile",   "--steps", "40:41",     "--objects",
                                     "60",        "--grow", "30",      "--size",    "160x120",
                                     "--workers", "1",      "--out",   out.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_kerf(arguments, surroundings);
}

/// A folder in which a program looks for libraries first, and finds one in the place of OSMesa that is none.
class WithoutOsmesa : public ::testing::Test {
 protected:
  WithoutOsmesa() { std::ofstream(folder_.path() / "libOSMesa.so.8").flush(); }

  [[nodiscard]] Surroundings hidden() const { return {.libraries = folder_.path().string()}; }
  [[nodiscard]] std::filesystem::path out(const char* name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

TEST_F(WithoutOsmesa, EglDrawsTheSamePictureUnasked) {
  const RunOutcome outcome = render(out("without"), {}, hidden());
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  ASSERT_EQ(render(out("with"), {"--backend", "osmesa"}, {}).exit, kExitHolds);
  EXPECT_EQ(read_text(out("without") / "pile_000001.png"), read_text(out("with") / "pile_000001.png"));
}

TEST_F(WithoutOsmesa, TheAnswerSaysWhatToDo) {
  const RunOutcome outcome = render(out("without"), {"--backend", "osmesa"}, hidden());
  EXPECT_NE(outcome.exit, kExitHolds);
  EXPECT_THAT(outcome.err, HasSubstr("libOSMesa.so.8 cannot be loaded; draw with --backend egl"));
}

}  // namespace
}  // namespace kerf::test
