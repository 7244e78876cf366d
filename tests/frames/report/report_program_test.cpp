#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "tests/frames/report/browser.h"

namespace kerf::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A report as small as it can be, with more arguments.
RunOutcome run_small_report(const std::string& page, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{
      "report",  "--objects", "40",    "--steps", "12",          "--rounds",         "1",
      "--seeds", "1",         "--out", page,      "--hardcases", page + ".hardcases"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_kerf(arguments);
}

void write_hardcases(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "hardcases.json") << R"({"columns":[{"dimension":2,"who":"kerf","name":"box"},
    {"dimension":2,"who":"rival","name":"planted-rival"}],"cases":[{"id":"V1","name":"NotANumber",
    "what":"","cells":[{"verdict":"exact","sign":"="},{"verdict":"crash","sign":"X"}]}]})";
}

TEST(ReportProgram, APageOfAllSectionsStandsAloneInABrowser) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  write_hardcases(page + ".hardcases");
  const RunOutcome outcome = run_small_report(page, {});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_EQ(outcome.err, "") << "no progress where there is no terminal";
  const std::string text = read_text(page);
  EXPECT_THAT(text, Not(HasSubstr("src="))) << "nothing is loaded";
  EXPECT_THAT(text, Not(HasSubstr("@import")));
  for (const char* part :
       {"kerf report missed --objects 40", "Recommended settings", "period=4:margin=0.1", "oriented-box",
        "one ulp aside", "energy drift", "error bars", "class=\"strip\"", "a third axis", "planted-rival"})
    EXPECT_THAT(text, HasSubstr(part));
  const Sight sight = look_at(page);
  ASSERT_EQ(sight.trouble, "");
  EXPECT_THAT(sight.console, IsEmpty());
  EXPECT_THAT(sight.resources, IsEmpty());
  EXPECT_TRUE(sight.fits);
  // Six motions twice, two dimensions of volumes, two pictures of each of four scenes, once their divergence
  // and two of their physics, two of needs and one heat map.
  EXPECT_EQ(sight.pictures.size(), 12U + 2 + 8 + 4 + 8 + 2 + 1);
  for (const Sight::Picture& picture : sight.pictures) {
    EXPECT_GT(picture.width, 200);
    EXPECT_GT(picture.height, 100);
    EXPECT_GT(picture.shapes, 5U);
  }
}

TEST(ReportProgram, TheBrowserWouldSeeWhatIsWrong) {
  const TemporaryFolder folder;
  const std::filesystem::path page = folder.path() / "page.html";
  std::ofstream(page) << R"(<!DOCTYPE html><html><head><style></style></head><body style="width:5000px">
    <img src="https://example.invalid/picture.png"><svg width="0" height="0"></svg>
    <script>console.error("planted"); undefined_function();</script></body></html>)";
  const Sight sight = look_at(page);
  ASSERT_EQ(sight.trouble, "");
  EXPECT_GE(sight.console.size(), 2U);
  EXPECT_THAT(sight.resources, ElementsAre("https://example.invalid/picture.png"));
  EXPECT_FALSE(sight.fits);
  ASSERT_EQ(sight.pictures.size(), 1U);
  EXPECT_EQ(sight.pictures[0].width, 0);
  EXPECT_EQ(sight.pictures[0].shapes, 0U);
}

TEST(ReportProgram, DoesNotMeasureAgainWhatIsKept) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  ASSERT_EQ(run_small_report(page, {"volumes"}).exit, kExitHolds);
  const std::filesystem::path kept = folder.path() / "page.json";
  auto figures = read_json(kept);
  for (auto& cell : figures["cells"]) cell[0]["contacts"] = 987654321;
  std::ofstream(kept) << figures;
  EXPECT_EQ(run_small_report(page, {"volumes"}).exit, kExitUnusable) << "the page is there";
  ASSERT_EQ(run_small_report(page, {"volumes", "--overwrite"}).exit, kExitHolds);
  EXPECT_THAT(read_text(page), HasSubstr("987654321"));
  ASSERT_EQ(run_small_report(page, {"volumes", "--fresh", "--overwrite"}).exit, kExitHolds);
  EXPECT_THAT(read_text(page), Not(HasSubstr("987654321")));
}

/// Each measurement is made by one shard, and the page's own file has all of them in the end.
TEST(ReportProgram, ShardsMakeTheMeasurementsOfOnePage) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  const auto keys = [&](const char* name) {
    std::vector<std::string> found;
    const auto page_file = read_json(folder.path() / name);
    for (const auto& [key, cell] : page_file["cells"].items()) found.push_back(key);
    return found;
  };
  const auto kept = [&] { return keys("page.json"); };
  ASSERT_EQ(run_small_report(page, {"missed", "volumes", "--shard", "1/2"}).exit, kExitHolds);
  EXPECT_FALSE(std::filesystem::exists(page));
  const std::vector<std::string> first = keys("page.shard-1-of-2.json");
  EXPECT_THAT(run_small_report(page, {"missed", "volumes", "--shard", "1/2"}).out,
              HasSubstr("0 measurements"));
  // A shard's figures would show on the page.
  auto figures = read_json(folder.path() / "page.shard-1-of-2.json");
  const std::string last = first.back();
  ASSERT_THAT(last, HasSubstr("volumes"));
  for (const auto& volume : figures["cells"][last]) EXPECT_EQ(volume["missed"], 0) << volume["setting"];
  figures["cells"][last][0]["contacts"] = 987654321;
  std::ofstream(folder.path() / "page.shard-1-of-2.json") << figures;
  const RunOutcome second = run_small_report(page, {"missed", "volumes", "--shard", "2/2"});
  ASSERT_EQ(second.exit, kExitHolds) << second.err;
  EXPECT_THAT(second.out, HasSubstr("page.shard-2-of-2.json"));
  ASSERT_EQ(run_small_report(page, {"missed", "volumes"}).exit, kExitHolds);
  EXPECT_THAT(read_text(page), HasSubstr("987654321"));
  EXPECT_THAT(kept(), ::testing::IsSupersetOf(first));
  EXPECT_GT(kept().size(), first.size());
  EXPECT_THAT(folder.files(), ::testing::SizeIs(2)) << "the page and its figures";
}

TEST(ReportProgram, TakesNothingOverFromAnotherMachine) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  std::ofstream(folder.path() / "page.json") << R"({"owner": "another", "cells": {"a": 1}})";
  const RunOutcome refused = run_small_report(page, {"hardcases"});
  EXPECT_EQ(refused.exit, kExitUnusable);
  EXPECT_THAT(refused.err, HasSubstr("another machine"));
  const RunOutcome without = run_small_report(page, {"hardcases", "--overwrite"});
  ASSERT_EQ(without.exit, kExitHolds);
  EXPECT_THAT(without.err, HasSubstr("hardcases.json is not there"));
  EXPECT_THAT(read_text(page), HasSubstr("./run hardcases")) << "says how to make the table";
  ASSERT_EQ(run_small_report(page, {"volumes", "--overwrite"}).exit, kExitHolds);
  EXPECT_FALSE(read_json(folder.path() / "page.json")["cells"].contains("a"));
}

/// The text was a library's, an unknown verdict looked like one that does not apply, and no columns were no
/// table.
TEST(ReportProgram, RefusesAMalformedTableOfHardCases) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  write_hardcases(page + ".hardcases");
  const std::filesystem::path file = std::filesystem::path(page + ".hardcases") / "hardcases.json";
  const std::string good = read_text(file);
  const auto refusal = [&](const std::string& text) {
    std::ofstream(file) << text;
    const RunOutcome outcome = run_small_report(page, {"hardcases"});
    EXPECT_EQ(outcome.exit, kExitUnusable) << text;
    EXPECT_THAT(outcome.err, HasSubstr("hardcases.json is no table of hard cases: "));
    EXPECT_THAT(outcome.err, HasSubstr("./run hardcases makes it anew"));
    return outcome.err;
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    return std::string(good).replace(good.find(from), from.size(), to);
  };
  EXPECT_THAT(refusal(R"({"columns":5,"cases":3})"), HasSubstr("two lists"));
  EXPECT_THAT(refusal(R"({"columns":[],"cases":[{"id":"V1","name":"N","cells":[]}]})"),
              HasSubstr("no column of 2D or 3D"));
  EXPECT_THAT(refusal(with(R"(,{"verdict":"crash","sign":"X"})", "")), Not(HasSubstr("json.exception")));
  EXPECT_THAT(refusal(with("\"crash\"", "\"wrong\"")), HasSubstr("the verdict 'wrong' is unknown"));
  EXPECT_FALSE(std::filesystem::exists(page));
  std::ofstream(file) << good;
  EXPECT_EQ(run_small_report(page, {"hardcases"}).exit, kExitHolds);
}

TEST(ReportProgram, DoesNotReplaceAnotherProgramsFile) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "speed.html").string();
  for (const char* const text : {R"({"machine": {}, "results": []})", R"({"owner": 3, "cells": {}})",
                                 R"({"owner": "me", "cells": [)", "[]", "a letter"}) {
    std::ofstream(folder.path() / "speed.json") << text;
    for (const char* const option : {"volumes", "--fresh"}) {
      const RunOutcome outcome = run_small_report(page, {"volumes", option});
      EXPECT_EQ(outcome.exit, kExitUnusable) << text;
      EXPECT_THAT(outcome.err, HasSubstr("speed.json"));
    }
    EXPECT_EQ(read_text(folder.path() / "speed.json"), text);
  }
}

TEST(ReportProgram, KeepsWhatWasMeasuredWhenInterrupted) {
  const TemporaryFolder folder;
  const std::filesystem::path kept = folder.path() / "page.json";
  const std::filesystem::path page = folder.path() / "page.html";
  const RunOutcome outcome = interrupt_kerf(
      {"report", "physics", "--objects", "40", "--steps", "60", "--seeds", "1000", "--out", page.string()},
      [&] { return std::filesystem::exists(kept); });
  EXPECT_EQ(outcome.exit, kExitInterrupted) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("kept in"));
  EXPECT_GE(read_json(kept)["cells"].size(), 1U);
  EXPECT_FALSE(std::filesystem::exists(page));
}

TEST(ReportProgram, SaysWhatIsMissingForPlots) {
  const TemporaryFolder folder;
  const RunOutcome outcome =
      run_kerf({"report", "volumes", "--objects", "20", "--out", (folder.path() / "page.html").string()},
               {.path = "/nowhere"});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("gnuplot-nox"));
}

TEST(ReportProgram, SaysWhereItCannotWrite) {
  const RunOutcome outcome = run_kerf({"report", "volumes", "--out", "/proc/nowhere/page.html"});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("/proc/nowhere"));
}

}  // namespace
}  // namespace kerf::test
