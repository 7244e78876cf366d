#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

class AdviseProgram : public ::testing::Test {
 protected:
  std::string recorded(const std::string& scene, const std::string& steps = "30") {
    const std::string file = path(scene + ".kerf");
    const RunOutcome outcome =
        run_kerf({"record", scene, "-o", file, "--objects", "60", "--grow", "20", "--steps", steps});
    EXPECT_EQ(outcome.exit, kExitHolds) << outcome.err;
    return file;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

TEST_F(AdviseProgram, RunsEveryBroadPhaseOnARecordingOfEitherDimension) {
  for (const char* const scene : {"pile-2d", "terrain"}) {
    const RunOutcome outcome = run_kerf({"advise", recorded(scene), "--rounds", "2", "--json",
                                         path("advice.json"), "--plot", path("advice.svg"), "--overwrite"});
    ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
    EXPECT_EQ(outcome.err, "") << "no progress where there is no terminal";
    const auto json = read_json(path("advice.json"));
    EXPECT_GE(json["results"].size() + json["gaps"].size(), 25U);
    for (const auto& row : json["results"]) {
      const std::string name = row["algorithm"];
      const bool is_ours = name.starts_with("kerf") || name == "columns" || name == "brute-force";
      if (is_ours) {
        EXPECT_EQ(row["missed"].get<int>() + row["extra"].get<int>(), 0) << name;
      }
      if (name == "brute-force") {
        EXPECT_GT(row["tests_per_pair"], 1);
      }
      if (row.contains("times")) {
        EXPECT_GE(row["times_most"], row["times_least"]);
      }
    }
    EXPECT_GT(json["scene"]["density"], 0);
    EXPECT_GT(json["scene"]["churn"], 0) << "the scene grows";
    ASSERT_FALSE(json["advice"].empty());
    EXPECT_THAT(outcome.out, HasSubstr(json["advice"][0].get<std::string>()));
    EXPECT_THAT(read_text(path("advice.svg")), HasSubstr("<svg"));
  }
}

TEST_F(AdviseProgram, MeasuresTheStepsAndBroadPhasesAskedFor) {
  std::ofstream(path("boxes.csv")) << "step,object,min_x,max_x,min_y,max_y\n"
                                   << "100,7,0,1,0,1\n100,8,0,1,0,1\n110,7,0,2,0,1\n120,7,0,3,0,1\n";
  ASSERT_EQ(run_kerf({"import", path("boxes.csv"), "-o", path("own.kerf")}).exit, kExitHolds);
  const RunOutcome outcome = run_kerf({"advise", path("own.kerf"), "--steps", "110:120", "--broad-phases",
                                       "columns,kerf:skin=0", "--rounds", "2"});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("steps 110 to 120")) << "as the import calls them";
  EXPECT_THAT(outcome.out, HasSubstr("kerf:skin=0"));
  EXPECT_THAT(outcome.out, ::testing::Not(HasSubstr("sort-and-sweep")));
}

/// Memory and times an object were divided by all objects that ever were.
TEST_F(AdviseProgram, CountsTheObjectsThatAreThereAtOnce) {
  std::ofstream table(path("boxes.csv"));
  table << "step,object,min_x,max_x,min_y,max_y\n";
  for (int step = 0; step < 20; ++step) {
    for (int object = -5; object < 0 && step > 0; ++object)
      table << step << ',' << 5 * step + object << ",,,,\n";
    for (int object = 0; object < 10; ++object)
      table << step << ',' << 5 * step + object << ',' << object << ',' << object + 2 << ",0,1\n";
  }
  table.close();
  ASSERT_EQ(run_kerf({"import", path("boxes.csv"), "-o", path("own.kerf")}).exit, kExitHolds);
  const RunOutcome outcome = run_kerf({"advise", path("own.kerf"), "--broad-phases", "columns,kerf",
                                       "--rounds", "2", "--json", path("advice.json")});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("10 objects, "));
  EXPECT_THAT(outcome.out, HasSubstr(", 100 % come and go in a step"));
  for (const auto& row : read_json(path("advice.json"))["results"]) EXPECT_EQ(row["objects"], 10);
}

TEST_F(AdviseProgram, SaysWhatIsWrongWithWhatItIsGiven) {
  const std::string file = recorded("pile-2d");
  const auto error = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "advise");
    const RunOutcome outcome = run_kerf(arguments);
    EXPECT_EQ(outcome.exit, kExitUnusable) << outcome.out;
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  EXPECT_THAT(error({path("none.kerf")}), HasSubstr("none.kerf"));
  EXPECT_THAT(error({file, "--broad-phases", "colums"}), HasSubstr("did you mean 'columns'?"));
  EXPECT_THAT(error({file, "--broad-phases", "kerf,kerf"}), HasSubstr("names one twice"));
  EXPECT_THAT(error({file, "--broad-phases", "kerf:skn=1"}), HasSubstr("skn"));
  EXPECT_THAT(error({file, "--steps", "5:5"}), HasSubstr("it takes two at least"));
  EXPECT_THAT(error({file, "--steps", "5:500"}), HasSubstr("30"));
  EXPECT_THAT(error({file, "--steps", "5:20:3"}), HasSubstr("give A:B"));
  EXPECT_THAT(error({file, "--rounds", "1"}), HasSubstr("from 2 to"));
  EXPECT_THAT(error({file, "--plot", path("a.png")}), HasSubstr("something.svg"));
  EXPECT_THAT(error({file, "--json", file}), HasSubstr("pile-2d.kerf"));
}

TEST_F(AdviseProgram, EndsSoonWhenInterruptedAndLeavesNothing) {
  const std::string file = recorded("pile-2d", "300");
  const std::vector<std::string> before = folder_.files();
  int asked = 0;
  const RunOutcome outcome = interrupt_kerf(
      {"advise", file, "--rounds", "1000", "--json", path("advice.json")}, [&] { return ++asked > 20; });
  EXPECT_EQ(outcome.exit, kExitInterrupted) << outcome.err;
  EXPECT_EQ(folder_.files(), before);
}

}  // namespace
}  // namespace kerf::test
