#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(UsageProgram, HelpIsNoError) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--help"}, {"scenes", "--help"}, {"render", "--help"}}) {
    const RunOutcome outcome = run_kerf(arguments);
    EXPECT_EQ(outcome.exit, kExitHolds);
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, HasSubstr("Usage:"));
  }
}

TEST(UsageProgram, RenderHelpNamesLayersAndParameters) {
  const RunOutcome outcome = run_kerf({"render", "--help"});
  for (const char* word : {"--steps", "--overwrite", "partitioners", "max_redundancy", "130"}) {
    EXPECT_THAT(outcome.out, HasSubstr(word));
  }
}

TEST(UsageProgram, NothingIsAnsweredWithHelp) {
  const RunOutcome outcome = run_kerf({});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("render"));
}

struct Mistake {
  const char* name;
  std::vector<std::string> arguments;
  const char* answer;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.name; }

class UsageMistake : public ::testing::TestWithParam<Mistake> {};

/// Every mistake gets exit code 2 and a message that names what would do, and makes no file.
TEST_P(UsageMistake, IsExplained) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = GetParam().arguments;
  if (arguments.front() == "render") {
    arguments.insert(arguments.begin() + 1, {"--out", (folder.path() / "out").string()});
  }
  const RunOutcome outcome = run_kerf(arguments);
  EXPECT_EQ(outcome.exit, kExitUnusable) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().answer));
  EXPECT_THAT(outcome.err, HasSubstr("--help"));
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(folder.files(), IsEmpty());
}

TEST(UsageProgram, ANameThatBeginsWithADashIsExplained) {
  const TemporaryFolder folder;
  std::filesystem::current_path(folder.path());
  std::ofstream("-x.kerf") << "x";
  EXPECT_THAT(run_kerf({"verify", "-x.kerf"}).err,
              HasSubstr("'-x.kerf' was taken for an option: write ./-x.kerf"));
  EXPECT_THAT(run_kerf({"verify", "./-x.kerf"}).err, HasSubstr("./-x.kerf is no recording of Kerf"));
  std::filesystem::current_path("/");
}

TEST(UsageProgram, ANameThatIsTooLongIsSaidInTheSystemsWords) {
  const std::string name(300, 'n');
  const RunOutcome outcome = run_kerf({"verify", name});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("kerf: " + name + ": File name too long"));
}

INSTANTIATE_TEST_SUITE_P(
    UsageProgram, UsageMistake,
    ::testing::Values(
        Mistake{"Command", {"rendr"}, "did you mean 'render'?"}, Mistake{"NoScene", {"render"}, "SCENE"},
        Mistake{"Scene", {"render", "bukets"}, "did you mean 'buckets'?"},
        Mistake{"TooMany", {"render", "pile", "terrain"}, "terrain"},
        Mistake{"Option", {"render", "pile", "--stps", "5"}, "did you mean '--steps'?"},
        Mistake{"ScenesOption", {"scenes", "--jsn"}, "did you mean '--json'?"},
        Mistake{"NoValue", {"render", "pile", "--steps"}, "--steps"},
        Mistake{"Steps", {"render", "pile", "--steps", "20:10"}, "comes after the last"},
        Mistake{"NoSteps", {"record", "pile", "-o", "x.kerf", "--steps", "0"}, "at least 1 step is needed"},
        Mistake{"RoomForOnePane",
                {"render", "pile", "--beside", "none", "--size", "64x64"},
                "1 pane has no room in 64x64"},
        Mistake{"WordsOfAFilm",
                {"film", "pile", "-o", "x.mp4", "--show", "+legend"},
                "--show legend: a film has a title and curves"},
        Mistake{"FilmOfOneStep", {"film", "pile", "-o", "x.mp4", "--steps", "1"}, "a film needs two steps"},
        Mistake{"StepsZero", {"render", "pile", "--steps", "1:10:0"}, "1 or more"},
        Mistake{"SizeZero", {"render", "pile", "--size", "0x720"}, "out of range"},
        Mistake{"SizeAbsurd", {"render", "pile", "--size", "100000x720"}, "out of range"},
        Mistake{"Objects", {"render", "pile", "--objects", "0"}, "whole number from 1"},
        Mistake{"ObjectsAbsurd", {"render", "pile", "--objects", "4000000000"}, "whole number from 1"},
        Mistake{"ObjectsBeyondScene", {"render", "pile", "--objects", "1000000"}, "100000"},
        Mistake{"ObjectsBeyondSceneOfTwoNames",
                {"record", "terrain-2d", "-o", "x.kerf", "--objects", "1000000"},
                "terrain-2d: 1000000 objects are too many: at most 100000 are possible"},
        Mistake{"Layer", {"render", "pile", "--show", "objets"}, "objects"},
        Mistake{"Camera", {"render", "pile", "--camera", "zoom=3"}, "width"},
        Mistake{"Parameter", {"render", "pile", "--config", "max_hight=3"}, "did you mean 'max_height'?"},
        Mistake{"ParameterValue", {"render", "pile", "--config", "max_height=1000"}, "max_height"},
        Mistake{"ParameterTwice", {"render", "pile", "--config", "merge=0,merge=1"}, "merge has two values"},
        Mistake{"GrowthOfWhatDoesNotGrow", {"render", "attractors", "--grow", "9"}, "does not grow"},
        Mistake{"BroadPhase", {"render", "pile", "--broad-phase", "box2d-tre"}, "did you mean 'box2d-tree'?"},
        Mistake{"BroadPhaseOfOtherDimension",
                {"render", "buckets", "--broad-phase", "box2d-tree"},
                "unknown 3D broad phase"},
        Mistake{"BroadPhaseParameters",
                {"render", "pile", "--broad-phase", "columns", "--config", "sample=9"},
                "has no parameters"},
        Mistake{"BroadPhaseVolume",
                {"render", "pile", "--broad-phase", "columns", "--volume", "sphere"},
                "knows only boxes"},
        Mistake{"Seed", {"render", "pile", "--seed", "x"}, "--seed"},
        Mistake{"Video", {"render", "pile", "--video", "film.avi"}, ".mp4"},
        Mistake{"ContactSheet", {"render", "pile", "--contact-sheet", "sheet"}, ".png"},
        Mistake{"BenchScene", {"bench", "--scenes", "bronian"}, "did you mean 'brownian'?"},
        Mistake{"BenchAlgorithm", {"bench", "--algorithms", "colums"}, "did you mean 'columns'?"},
        Mistake{
            "BenchParameter", {"bench", "--algorithms", "kerf:max_hight=3"}, "did you mean 'max_height'?"},
        Mistake{"BenchPeriod", {"bench", "--algorithms", "kerf:period=0"}, "from 1 to 1000000"},
        Mistake{"BenchPeriodTwice", {"bench", "--algorithms", "kerf:period=2:period=3"}, "has two values"},
        Mistake{"CameraOfTwoSides", {"render", "buckets", "--camera", "iso,top"}, "would undo it"},
        Mistake{"RateOfNoFilm", {"render", "pile", "--fps", "30"}, "give --video, too"},
        Mistake{"RateOfNoCollectedFilm", {"collect", "none", "--fps", "30"}, "give --video, too"},
        Mistake{"StepOfAnEvent", {"explain", "x.kerf", "--event", "e1", "--step", "3"}, "at its own step"},
        Mistake{"FlipLimitOfNoFlip",
                {"diff", "a", "b", "--gate", "exact", "--flip-limit", "1"},
                "leave one of them out"},
        Mistake{"CameraTwice", {"render", "pile", "--camera", "width=3,width=4"}, "stands twice"},
        Mistake{"BenchShrink", {"bench", "--algorithms", "kerf:shrink=1"}, "it needs a grid"},
        Mistake{"BenchSimulation", {"bench", "--simulations", "terain"}, "did you mean 'terrain'?"},
        Mistake{
            "BenchSimulationAndScene", {"bench", "--simulations", "pile", "--scenes", "flat"}, "leave one"},
        Mistake{
            "BenchSimulationAndTrace", {"bench", "--simulations", "pile", "--trace"}, "no meaning for sim"},
        Mistake{"BenchSimulationAndPatience",
                {"bench", "--simulations", "pile", "--patience", "1"},
                "no meaning for sim"},
        Mistake{"BenchTraceOfNothing", {"bench", "--trace"}, "add --json FILE"},
        Mistake{"BenchAblationOfAlgorithms",
                {"bench", "--ablation", "--algorithms", "kerf"},
                "leave --algorithms out"},
        Mistake{
            "BenchInLoop", {"bench", "--simulations", "pile-2d", "--algorithms", "colums"}, "2D broad phase"},
        Mistake{
            "BenchRandomAndScene", {"bench", "--random", "2", "--scenes", "flat"}, "leave one of them out"},
        Mistake{"BenchFirstOfNone", {"bench", "--first", "2"}, "add --random N"},
        Mistake{"BenchRandomNone", {"bench", "--random", "0"}, "whole number from 1"},
        Mistake{"BenchMost", {"bench", "--random", "1", "--most", "5"}, "from 16"},
        Mistake{"BenchDimension", {"bench", "--dims", "4"}, "from 2 to 3"},
        Mistake{"BenchObjects", {"bench", "--objects", "1"}, "whole number from"},
        Mistake{"BenchEmptyName", {"bench", "--objects", "1000,,2000"}, "between commas"},
        Mistake{"BenchRounds", {"bench", "--rounds", "0"}, "whole number from 1"},
        Mistake{"BenchOption", {"bench", "--scnes", "brownian"}, "did you mean '--scenes'?"},
        Mistake{"ReportSection", {"report", "misssed"}, "did you mean 'missed'?"},
        Mistake{"ReportObjects", {"report", "--objects", "3"}, "from 20 to 100000"},
        Mistake{"ReportSteps", {"report", "--steps", "ten"}, "whole number from"},
        Mistake{"ReportSeeds", {"report", "--seeds", "0"}, "whole number from 1"},
        Mistake{"ReportPage", {"report", "--out", "page.json"}, "call the page something.html"},
        Mistake{"ReportPageOfText", {"report", "--out", "page.txt"}, "call the page something.html"},
        Mistake{"RecordDash", {"record", "pile", "--steps", "1", "-o", "-"}, "write ./-"},
        Mistake{"BenchDash", {"bench", "--json", "-"}, "write ./-"},
        Mistake{"DebugNoFile", {"debug", ""}, "SCENE|FILE is empty; name one, or leave it out"},
        Mistake{"DebugNoSession", {"debug", "x.kerf", "--session", ""}, "--session is empty"},
        Mistake{"DebugOneSessionOfTwo",
                {"debug", "x.kerf", "--session", "a", "--session", ""},
                "--session is empty"},
        Mistake{"DiffNoReference", {"diff", "", "x"}, "REFERENCE is empty; name one\n"},
        Mistake{"RecordSteps",
                {"record", "pile", "-o", "/proc/no.kerf", "--steps", "1e3"},
                "--steps '1e3' is not how many, for example 1000: a recording has every step"},
        Mistake{"DebugSteps", {"debug", "pile", "--steps", "10:20:2"}, "is not how many"},
        Mistake{"SeedOfConfig",
                {"render", "pile", "--config", "seed=18446744073709551616"},
                "is not a whole number from 0 to 18446744073709551615"},
        Mistake{"OracleEvery",
                {"verify", "x.kerf", "--oracle-every", "99999999999"},
                "is not a whole number from 0 to 4294967295"},
        Mistake{"Hits",
                {"step", "x.kerf", "--to", "step==1", "--hits", "99999999999"},
                "is not a whole number from 1 to 4294967295"},
        Mistake{"ReportNoPage", {"report", "--out", ""}, "--out is empty"},
        Mistake{"StudyNoShard", {"study", "x.json", "--shard", ""}, "--shard is empty; give it K/N"},
        Mistake{"ExperimentNoSteps", {"experiment", "--steps", ""}, "--steps is empty; give it N"},
        Mistake{"ReportOption", {"report", "--objcts", "30"}, "did you mean '--objects'?"}),
    [](const ::testing::TestParamInfo<Mistake>& mistake) { return std::string(mistake.param.name); });

}  // namespace
}  // namespace kerf::test
