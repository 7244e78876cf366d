// What an import says of its steps: as their engine numbered them, by every command.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/frames/import_program.h"
#include "tests/support/tampering.h"

namespace kerf::test {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Words = std::vector<std::string>;

const std::string kConfig = "min_threshold=4,max_threshold=8,schedule_interval=2,budget_divisor=64";

/// A pile of forty steps, which its engine numbered from 5001 on.
class ImportSteps : public ImportProgram {
 protected:
  void SetUp() override {
    run({"record", "pile", "-o", path("pile.kerf"), "--steps", "40", "--objects", "60", "--grow", "10"});
    std::istringstream given(run({"export", path("pile.kerf"), "--boxes"}).out);
    std::string boxes;
    std::getline(given, boxes);
    boxes += '\n';
    for (std::string line; std::getline(given, line);) {
      const std::size_t comma = line.find(',');
      boxes += std::to_string(5000 + std::stoi(line.substr(0, comma))) + line.substr(comma) + "\n";
    }
    (void)imported("a", write("boxes.csv", boxes), {"--config", kConfig});
  }
  [[nodiscard]] std::string file() const { return path("a.kerf"); }
  /// Pixels that objects cover in a frame.
  [[nodiscard]] int covered(const std::string& frame) const {
    int pixels = 0;
    const auto json = test::read_json(path(frame + ".draw.json"));
    for (const auto& item : json["items"])
      if (item[0] == "object") pixels += item[8].get<int>();
    return pixels;
  }
  static RunOutcome run(const Words& arguments, int exit = 0) {
    RunOutcome outcome = run_kerf(arguments);
    EXPECT_EQ(outcome.exit, exit) << arguments.front() << ": " << outcome.out << outcome.err;
    return outcome;
  }
};

TEST_F(ImportSteps, LintNamesThem) {
  const RunOutcome lint = run({"lint", file(), "--within", "2"}, 1);
  EXPECT_THAT(lint.out, ContainsRegex("steps 50[0-4][0-9] to 50[0-4][0-9]\n"));
  EXPECT_THAT(lint.out, Not(ContainsRegex("steps [0-9][0-9]? to")));
}

TEST_F(ImportSteps, VerifyNamesThem) {
  EXPECT_THAT(run({"verify", file()}).out, HasSubstr("replayed 40 steps, "));
  Random random(1);
  test::change_value(file(), {"steps", "pairs", 9}, random);
  EXPECT_THAT(run({"verify", file()}, 1).out,
              HasSubstr("the row of step 5010, or what was written after step 5009"));
  EXPECT_THAT(run({"explain", file(), "--step", "5003", "--node", "n0"}, 2).err,
              HasSubstr("the row of step 5010"));
  test::reseal(file());
  const RunOutcome verdict = run({"verify", file()}, 1);
  EXPECT_THAT(verdict.out, HasSubstr("diverges first in step 5010\n"));
  EXPECT_THAT(verdict.out, HasSubstr("not checked: steps 5011 to 5040"));
}

TEST_F(ImportSteps, RerunTakesAndNamesThem) {
  const Words begin{"rerun", file(), "-o", path("b.kerf"), "--config", "max_threshold=6"};
  const auto from = [&](const std::string& step) {
    Words words = begin;
    words.insert(words.end(), {"--from", step});
    return words;
  };
  EXPECT_THAT(run(from("3"), 2).err, HasSubstr("goes from step 5001 to 5040"));
  EXPECT_EQ(run(from("5010")).out, path("b.kerf") + ": 40 steps\n");
  const RunOutcome again = run(
      {"rerun", path("b.kerf"), "-o", path("c.kerf"), "--from", "5003", "--config", "max_threshold=7"}, 2);
  EXPECT_THAT(again.err, HasSubstr("another configuration from step 5010 on"));
  EXPECT_THAT(run({"rerun", file(), "-o", path("c.kerf"), "--refuse", "e0"}, 2).err,
              HasSubstr("e0 step 5001 "));
}

TEST_F(ImportSteps, CompareNamesThem) {
  run({"rerun", file(), "-o", path("b.kerf"), "--config", "min_threshold=9,max_threshold=20", "--from",
       "5010"});
  const RunOutcome text = run({"compare", file(), path("b.kerf")}, 1);
  EXPECT_THAT(text.out, ContainsRegex("differ first in step 50[1-4][0-9]"));
  EXPECT_THAT(text.out, ContainsRegex("B: e[0-9]+ step 50[1-4][0-9] "));
  const auto json = nlohmann::json::parse(run({"compare", "--json", file(), path("b.kerf")}, 1).out);
  EXPECT_THAT(json["first_different"]["events"].get<std::string>(), StartsWith("50"));
  EXPECT_THAT(json["first_different"]["a_event"].get<std::string>(), HasSubstr(" step 50"));
}

TEST_F(ImportSteps, MinimizeNamesThem) {
  const RunOutcome small = run({"minimize", file(), "--when", "pairs>0", "-o", path("small.kerf")});
  EXPECT_THAT(small.out, ContainsRegex("holds at step 50[0-4][0-9]\n"));
  EXPECT_THAT(small.out, HasSubstr("small.kerf: 1 step, "));
  EXPECT_THAT(test::read_text(path("small.cpp")), ContainsRegex("// step 50[0-4][0-9]\n"));
}

/// A film counted those in the tree as objects, and all as moving: "objects 1, moving 2".
TEST_F(ImportSteps, ObjectsInQuarantineAreCountedAlikeInEveryCaption) {
  (void)imported("odd", write("odd.csv",
                              "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n1,1,3,2,0,1\n"
                              "1,2,0,2,0,1\n"));
  const Words words{"render", path("odd.kerf"), "--steps", "1:1",      "--workers",
                    "0",      "--overwrite",    "--out",   path("odd")};
  const auto rendered = [&](Words more) {
    more.insert(more.begin(), words.begin(), words.end());
    run(more);
    return test::read_json(path("odd/frames.json"))["frames"][0];
  };
  EXPECT_EQ(rendered({"--beside", "columns"})["objects"], 3);
  EXPECT_EQ(rendered({"--ids"})["objects"], 3);
  const auto texts = test::read_json(path("odd/odd_000000.draw.json"))["texts"];
  for (const char* const word : {"objects", "moving"}) {
    const auto at = std::ranges::find_if(texts, [&](const auto& text) { return text[2] == word; });
    ASSERT_NE(at, texts.end());
    EXPECT_EQ(std::stoi((at + 1)->at(2).get<std::string>()), 3) << word;
  }
}

TEST_F(ImportSteps, RenderTakesThem) {
  const auto render = [&](const std::string& steps, int exit = 0) {
    return run({"render", file(), "--steps", steps, "--size", "320x200", "--workers", "0", "--ids", "--out",
                path("frames"), "--overwrite"},
               exit);
  };
  render("5010:5020:10");
  EXPECT_THAT(test::read_text(path("frames/a_000001.draw.json")), HasSubstr("\"5020\""));
  EXPECT_FALSE(std::filesystem::exists(path("frames/a_000002.png")));
  EXPECT_THAT(render("3:9", 2).err, HasSubstr("there is no step '3'; the recording has steps 5001 to 5040"));
  EXPECT_THAT(render("5020:5010", 2).err, HasSubstr("the first step, 5020, comes after the last, 5010"));
  EXPECT_THAT(render("5001:5002:x", 2).err, HasSubstr("for example 5001:5040:4"));
}

TEST_F(ImportSteps, RenderTakesDatesBetweenDots) {
  std::string csv = "step,object,min_x,max_x,min_y,max_y\n";
  for (int second = 0; second < 8; ++second)
    csv += "2024-05-01T12:00:0" + std::to_string(second) + ",1,0,1,0," + std::to_string(second + 1) + "\n";
  run({"import", write("dates.csv", csv), "-o", path("dates.kerf")});
  const auto steps_of = [&](const std::string& steps) {
    run({"render", path("dates.kerf"), "--steps", steps, "--size", "96x64", "--workers", "0", "--out",
         path("frames"), "--overwrite"});
    const auto made = nlohmann::json::parse(test::read_text(path("frames/frames.json")));
    std::string shown;
    for (const auto& frame : made["frames"]) shown += frame["given_step"].get<std::string>().substr(18) + " ";
    return shown;
  };
  EXPECT_EQ(steps_of("2024-05-01T12:00:02..2024-05-01T12:00:06..2"), "2 4 6 ");
  EXPECT_EQ(steps_of("2024-05-01T12:00:05..2024-05-01T12:00:06"), "5 6 ");
  EXPECT_EQ(steps_of("2024-05-01T12:00:01"), "0 1 ");
  EXPECT_EQ(steps_of("2:3"), "1 2 ") << "numbers count from 1";
  EXPECT_THAT(run({"render", path("dates.kerf"), "--steps", "2024-05-01T12:00:02..2025-05-01T12:00:06",
                   "--out", path("frames")},
                  2)
                  .err,
              HasSubstr("there is no step '2025-05-01T12:00:06'"));
}

/// The camera looks elsewhere from a step of theirs on.
TEST_F(ImportSteps, ACameraPathHasThem) {
  const std::string camera = write("camera", "5001 center=0:0,width=10\n5020 center=900:900,width=10\n");
  run({"render", file(), "--steps", "5001:5020:19", "--size", "320x200", "--workers", "0", "--ids", "--out",
       path("frames"), "--camera-path", camera});
  EXPECT_GT(covered("frames/a_000000"), 0);
  EXPECT_EQ(covered("frames/a_000001"), 0);
}

TEST_F(ImportSteps, TheDebuggerTakesAndNamesThem) {
  const std::string script =
      write("script",
            "click \"go to\"\ntype 5010\nkey enter\nexpect step == 5010\n"
            "expect position == \"step 5010\"\nkey f9\nexpect breakpoint0 == step==5010\n"
            "key end\nkey shift+f5\nexpect step == 5010\n"
            "expect message ~ \"stopped at step 5010\"\n"
            "click \"go to\"\ntype 17\nkey enter\n"
            "expect message ~ \"neither a step such as 5017 nor\"\n");
  run({"debug", file(), "--headless", "--script", script});
}

}  // namespace
}  // namespace kerf::test
