#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/files/part_file.h"
#include "core/recording/recording_reader.h"
#include "tests/frames/program.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;
using testing::kerf_command;
using ::testing::Not;
using testing::Outcome;
using testing::Process;
using testing::run_kerf;
using ::testing::StartsWith;
using testing::TemporaryFolder;

/// Imports small files in the manner of bug reports; those of tests/frames/cases are one folder each.
class ImportProgram : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
  static std::string given(const std::string& name) {
    return std::string(KERF_SOURCE_DIR) + "/tests/frames/cases/" + name;
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  /// Imports as NAME.kerf; `more` are further arguments.
  [[nodiscard]] Outcome import(const std::string& name, const std::string& boxes,
                               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"import", boxes, "-o", path(name + ".kerf"), "--overwrite"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_kerf(arguments);
  }
  /// What is printed of an import that works.
  [[nodiscard]] std::string imported(const std::string& name, const std::string& boxes,
                                     const std::vector<std::string>& more = {}) const {
    const Outcome outcome = import(name, boxes, more);
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    return outcome.out;
  }
  [[nodiscard]] std::string refused(const std::string& boxes,
                                    const std::vector<std::string>& more = {}) const {
    const Outcome outcome = import("refused", boxes, more);
    EXPECT_EQ(outcome.exit, 2) << outcome.out;
    EXPECT_FALSE(std::filesystem::exists(path("refused.kerf")));
    return outcome.err;
  }
  [[nodiscard]] std::string explained(const std::string& name, const std::string& step,
                                      const std::string& pair) const {
    const Outcome outcome = run_kerf({"explain", path(name + ".kerf"), "--step", step, "--pair", pair});
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    return outcome.out;
  }
  [[nodiscard]] std::string exported(const std::string& name, const std::string& what) const {
    const Outcome outcome = run_kerf({"export", path(name + ".kerf"), what});
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    return outcome.out;
  }
  [[nodiscard]] std::string stepped(const std::string& name, const std::string& condition) const {
    return run_kerf({"step", path(name + ".kerf"), "--to", condition}).out;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(ImportProgram, ColumnsAreFoundByTheirNames) {
  EXPECT_THAT(imported("a", given("header_order/boxes.csv"), {"--pairs", given("header_order/pairs.csv")}),
              HasSubstr("1 pairs: 0 missed, 0 extra"));
  EXPECT_THAT(explained("a", "1", "0,1"), HasSubstr("0: x [0, 2]  y [10, 12]"));
  const std::string aliases = "Time,Body,Lower.X,Lower.Y,Upper.X,Upper.Y,is_static\n1,4,0,10,2,12,1\n";
  EXPECT_THAT(imported("b", write("b.csv", aliases)),
              HasSubstr("columns step, object, min_x, min_y, max_x, max_y, fixed"));
  EXPECT_THAT(exported("b", "--boxes"), HasSubstr("1,4,0,2,10,12,1\n"));
  EXPECT_THAT(refused(write("c.csv", "step,object,minx,maxx,miny,maxy,mass\n1,0,0,1,0,1,5\n")),
              HasSubstr("'mass' of the heading is not known; known are step, object, min_x"));
  EXPECT_THAT(refused(write("d.csv", "step,object,min_x,max_x,min_y\n1,0,0,1,0\n")),
              HasSubstr("lacks max_y"));
  EXPECT_THAT(refused(write("e.csv", "step,object,min_x,max_x,min_y,max_y,max_z\n1,0,0,1,0,1,1\n")),
              HasSubstr("lacks min_z"));
  EXPECT_THAT(refused(write("f.csv", "step,object,min_x,xmin,min_y,max_y\n1,0,0,1,0,1\n")),
              HasSubstr("column 4, 'xmin', is min_x, as column 3 is"));
  EXPECT_THAT(refused(write("g.csv", ",step,object,min_x,max_x,min_y,max_y\n0,1,0,0,1,0,1\n")),
              HasSubstr("column 1 of the heading has no name"));
}

TEST_F(ImportProgram, AByteOrderMarkIsPassedOver) {
  EXPECT_THAT(imported("a", given("bom/boxes.csv"), {"--pairs", given("bom/pairs.csv")}),
              HasSubstr("1 pairs: 0 missed, 0 extra"));
  EXPECT_THAT(imported("b", given("bom/nohead.csv")), StartsWith("2D, 1 step numbered 1, 2 objects"));
}

TEST_F(ImportProgram, DecimalCommasAndOtherSeparatorsAreRefusedWithTheReason) {
  const std::string comma = refused(given("decimal_comma/boxes.csv"));
  EXPECT_THAT(comma, HasSubstr("boxes.csv, line 2: the heading has 6 columns, this line has 8"));
  EXPECT_THAT(comma, HasSubstr("decimal commas"));
  EXPECT_THAT(refused(given("decimal_comma/semicolon.csv")), HasSubstr("columns are separated by ';'"));
  EXPECT_THAT(refused(write("a.csv", "1;0;0,5;2;10,5;12,5\n")), HasSubstr("columns are separated by ';'"));
  EXPECT_THAT(refused(write("b.csv", "1\t0\t0.5\t2\t10\t12\n")), HasSubstr("columns are separated by tabs"));
  EXPECT_THAT(refused(write("c.csv", "1,0,\"0,5\",2,10,12\n")),
              HasSubstr("'0,5' in column 3, min_x, has a decimal comma"));
}

TEST_F(ImportProgram, NumbersNearZeroAndWithAPlusAreRead) {
  EXPECT_THAT(imported("a", given("underflow/boxes.csv"), {"--pairs", given("underflow/pairs.csv")}),
              HasSubstr("1 pairs: 0 missed, 0 extra"));
  EXPECT_THAT(explained("a", "1", "0,1"), HasSubstr("y [-2.22045e-61, 1]"));
  EXPECT_THAT(imported("b", given("underflow/denormal.csv")), StartsWith("3D, 1 step"));
  EXPECT_THAT(imported("c", given("underflow/plus.csv")), StartsWith("3D, 1 step"));
  EXPECT_THAT(exported("c", "--boxes"), HasSubstr("1,0,-0.5,0.5,0,1,-0.5,0.5,0\n"));
  (void)imported("d", write("d.csv", "1,0,-1e-400,1e-400,0,1\n"));
  EXPECT_THAT(refused(write("e.csv", "1,0,0,1e400,0,1\n")),
              HasSubstr("'1e400' in column 4, max_x, is too large"));
}

TEST_F(ImportProgram, PairsAreJudgedInThePrecisionGiven) {
  const std::string boxes = given("double_far/boxes.csv");
  EXPECT_THAT(imported("a", boxes, {"--pairs", given("double_far/pairs.csv")}),
              HasSubstr("1 pairs: 0 missed, 0 extra, 0 twice"));
  const std::string why = explained("a", "1", "0,1");
  EXPECT_THAT(why, HasSubstr("0 and 1 are no pair: axis x separates them by 0.05"));
  EXPECT_THAT(why, HasSubstr("0: x [20000000, 20000000.9]"));
  EXPECT_THAT(why, HasSubstr("1: x [20000000.95, 20000001.85]"));
  EXPECT_THAT(why, HasSubstr("rounded outward to floats"));
  EXPECT_THAT(why, Not(HasSubstr("became a pair")));
  EXPECT_EQ(run_kerf({"verify", path("a.kerf")}).exit, 0);
  const std::string told = write("told.csv", "step,a,b\n1,0,1\n1,2,3\n");
  EXPECT_THAT(imported("b", boxes, {"--pairs", told}), HasSubstr("2 pairs: 0 missed, 1 extra"));
  const std::string silent = write("silent.csv", "step,a,b\n");
  EXPECT_THAT(imported("c", boxes, {"--pairs", silent}), HasSubstr("0 pairs: 1 missed, 0 extra"));
}

TEST_F(ImportProgram, ChangesOfMobilityAreFollowedAndExported) {
  const std::string out =
      imported("a", given("type_change/boxes.csv"), {"--pairs", given("type_change/pairs.csv")});
  EXPECT_THAT(out, HasSubstr("2 pairs: 0 missed, 0 extra"));
  EXPECT_THAT(out, HasSubstr("odd: 1 changes between fixed and moving"));
  EXPECT_THAT(out, HasSubstr("line 4: object 1 is moving from step 2 on"));
  EXPECT_THAT(explained("a", "1", "0,1"), HasSubstr("both are fixed"));
  EXPECT_THAT(exported("a", "--boxes"), HasSubstr("\n2,1,4,5,0.8,1.8,0\n3,1,"));
  EXPECT_THAT(imported("b", given("type_change/b.csv"), {"--pairs", given("type_change/bp.csv")}),
              HasSubstr("1 pairs: 0 missed, 0 extra"));
}

TEST_F(ImportProgram, ObjectsMayHaveAnyNumberOf64Bits) {
  EXPECT_THAT(imported("a", given("ids_64bit/boxes.csv")),
              HasSubstr("2 objects numbered 2293599400000100004 to 2293599400000100005"));
  EXPECT_THAT(explained("a", "1", "2293599400000100004,2293599400000100005"),
              HasSubstr("2293599400000100004 and 2293599400000100005 are a pair"));
  EXPECT_THAT(stepped("a", "pair(2293599400000100004,2293599400000100005)"), StartsWith("step 1\n"));
  EXPECT_THAT(imported("b", given("ids_64bit/gen.csv")), HasSubstr("numbered 4294967297 to 4294967298"));
  (void)imported("c", given("ids_64bit/neg.csv"));
  EXPECT_THAT(exported("c", "--boxes"), HasSubstr("\n1,-12034,0,2,0,2,0\n"));
  EXPECT_THAT(stepped("c", "pair(-12036,-12034) enters"), StartsWith("step 1\n"));
  const std::string extreme = "1,-9223372036854775808,0,2,0,2\n1,18446744073709551615,1,3,1,3\n";
  EXPECT_THAT(imported("d", write("d.csv", extreme)),
              HasSubstr("2 objects numbered -9223372036854775808 to 18446744073709551615"));
  EXPECT_THAT(refused(write("e.csv", "1,18446744073709551616,0,2,0,2\n")),
              HasSubstr("no whole number of 64 bits"));
  EXPECT_THAT(refused(write("f.csv", "1,1.5,0,2,0,2\n")), HasSubstr("no whole number of 64 bits"));
  EXPECT_EQ(run_kerf({"verify", path("d.kerf")}).exit, 0);
}

/// What an import costs depends on how many objects there are.
TEST_F(ImportProgram, LargeNumbersCostNoMore) {
  (void)imported("small", write("small.csv", "1,0,0,2,0,2\n1,1,1,3,1,3\n2,1,1,3,1,3\n"));
  (void)imported("big", given("ids_64bit/big.csv"));
  EXPECT_LT(std::filesystem::file_size(path("big.kerf")), 2 * std::filesystem::file_size(path("small.kerf")));
  const RecordingReader<2> big(path("big.kerf"));
  EXPECT_EQ(big.info().names.object({0}), "9999998");
  EXPECT_EQ(big.info().names.object({1}), "10000000");
}

TEST_F(ImportProgram, StepsMayBeTimes) {
  EXPECT_THAT(imported("a", given("step_timestamps/ns.csv")),
              HasSubstr("2 steps numbered 1700000000016667000 to 1700000000033334000"));
  const std::string us =
      imported("b", given("step_timestamps/us.csv"), {"--pairs", given("step_timestamps/us_pairs.csv")});
  EXPECT_THAT(us, HasSubstr("60 steps numbered 0 to 983353"));
  EXPECT_THAT(us, Not(HasSubstr("odd")));
  EXPECT_THAT(stepped("b", "step>=16667"), StartsWith("step 16667\n"));
  EXPECT_THAT(refused(given("step_timestamps/unordered.csv")),
              HasSubstr("line 3: step 1 comes after step 2"));
  const std::string times = "0.016,0,0,1,0,1\n0.033,0,0,1,0,1\n";
  EXPECT_THAT(imported("c", write("c.csv", times)), HasSubstr("2 steps numbered 0.016 to 0.033"));
  const std::string dates =
      "step,object,min_x,max_x,min_y,max_y\n2024-02-29T23:59:59.984,0,0,1,0,1\n2024-03-01T00:00:00.000,0,0,1,"
      "0,1\n";
  EXPECT_THAT(imported("d", write("d.csv", dates)), HasSubstr("to 2024-03-01T00:00:00.000"));
  EXPECT_THAT(refused(write("e.csv", "nan,0,0,1,0,1\n")), HasSubstr("neither a number nor a time"));
}

TEST_F(ImportProgram, InvertedBoxesAreCountedAndExplained) {
  const std::string out =
      imported("a", given("inverted/boxes.csv"), {"--pairs", given("inverted/pairs.csv")});
  EXPECT_THAT(out, HasSubstr("odd: 1 boxes that are inverted"));
  EXPECT_THAT(out, HasSubstr("boxes.csv, line 3: object 1 in step 1"));
  const std::string why = explained("a", "1", "0,1");
  EXPECT_THAT(why, HasSubstr("object 1 is in quarantine: its box, x [3, 1]"));
  EXPECT_THAT(why, HasSubstr("the other engine reported it, though it is none"));
  EXPECT_THAT(refused(given("inverted/boxes.csv"), {"--strict"}), HasSubstr("line 3: object 1 in step 1"));
}

TEST_F(ImportProgram, WhatIsOddIsNeverSilent) {
  std::string boxes =
      "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n1,1,0,1,,1\n1,2,nan,1,0,1\n1,3,-inf,1,0,1\n";
  for (int object = 10; object < 17; ++object) boxes += "2," + std::to_string(object) + ",5,4,0,1\n";
  boxes += "5,0,0,1,0,1\n";
  const std::string pairs = write("pairs.csv", "1,0,3\n2,0,77\n4,0,3\n");
  const std::string out = imported("a", write("boxes.csv", boxes), {"--pairs", pairs});
  EXPECT_THAT(out, HasSubstr("odd: 1 boxes that are half blank"));
  EXPECT_THAT(out, HasSubstr("boxes.csv, line 3: object 1 in step 1"));
  EXPECT_THAT(out, HasSubstr("odd: 1 boxes that are not numbers"));
  EXPECT_THAT(out, HasSubstr("odd: 1 boxes that reach to infinity"));
  EXPECT_THAT(out, HasSubstr("odd: 7 boxes that are inverted"));
  EXPECT_THAT(out, HasSubstr("line 10: object 14 in step 2\n  and 2 more\n"));
  EXPECT_THAT(out, HasSubstr("odd: 1 gaps between steps"));
  EXPECT_THAT(out, HasSubstr("step 4 follows step 2"));
  EXPECT_THAT(out, HasSubstr("odd: 1 steps with pairs and without a line of boxes"));
  EXPECT_THAT(out, HasSubstr("pairs.csv, line 2: object 77 in step 2"));
  EXPECT_EQ(import("b", path("boxes.csv"), {"--strict"}).exit, 2);
  EXPECT_FALSE(std::filesystem::exists(path("b.kerf")));
  EXPECT_THAT(imported("c", given("header_order/boxes.csv"), {"--strict"}), Not(HasSubstr("odd")));
}

TEST_F(ImportProgram, QuotesAndOtherWordsForNumbersAreRead) {
  EXPECT_THAT(imported("a", given("quoted/boxes.csv")),
              StartsWith("2D, 1 step numbered 1, 1 object numbered 0"));
  EXPECT_THAT(imported("b", given("quoted/headonly.csv")), StartsWith("2D, 1 step"));
  EXPECT_THAT(imported("c", given("quoted/float_ids.csv")), HasSubstr("1 object numbered 0"));
  (void)imported("d", given("quoted/bool.csv"));
  const std::string rows = exported("d", "--boxes");
  EXPECT_THAT(rows, HasSubstr("1,0,0,2,10,12,0\n"));
  EXPECT_THAT(rows, HasSubstr("1,1,0,2,10,12,1\n"));
  EXPECT_THAT(refused(write("e.csv", "\"1,0,0,2,0,2\n")), HasSubstr("line 1: a quote is never closed"));
  EXPECT_THAT(refused(write("f.csv", "\"1\"2,0,0,2,0,2\n")),
              HasSubstr("between a closing quote and the next comma"));
}

TEST_F(ImportProgram, WhatAnEngineFiltersIsDeclaredAndCountedApart) {
  const std::string pairs = given("filters/pairs.csv");
  EXPECT_THAT(imported("a", given("filters/boxes.csv"), {"--pairs", pairs}),
              HasSubstr("1 pairs: 1 missed, 0 extra"));
  EXPECT_THAT(stepped("a", "missed>0"), HasSubstr("theirs, missed: (0,1)"));
  const std::string ignore = write("ignore.csv", "a,b\n1,0\n7,9\n");
  EXPECT_THAT(imported("b", given("filters/boxes.csv"), {"--pairs", pairs, "--ignore", ignore}),
              HasSubstr("1 pairs: 0 missed, 0 extra, 0 twice, 1 ignored (0 by filters, 1 by the list"));
  EXPECT_THAT(explained("b", "1", "0,1"), HasSubstr("it is ignored"));
  EXPECT_THAT(stepped("b", "ignored>0"), HasSubstr("theirs, ignored, listed: (0,1)"));
  const std::string masked = write("masked.csv",
                                   "step,object,min_x,max_x,min_y,max_y,category,mask\n"
                                   "1,0,0,1,0,1,1,2\n1,1,0.9,1.9,0,1,4,7\n1,2,1.8,2.8,0,1,2,6\n");
  EXPECT_THAT(imported("c", masked, {"--pairs", pairs}), HasSubstr("1 ignored (1 by filters"));
  EXPECT_THAT(explained("c", "1", "0,1"), HasSubstr("the other engine's masks leave it out"));
  EXPECT_EQ(run_kerf({"verify", path("c.kerf")}).exit, 0);
  EXPECT_THAT(run_kerf({"verify", path("c.kerf")}).out, HasSubstr("0 twice, 1 ignored"));
}

TEST_F(ImportProgram, AMarginIsDeclared) {
  const std::string boxes = given("fat_pairs/boxes.csv");
  const std::string pairs = given("fat_pairs/pairs.csv");
  EXPECT_THAT(imported("a", boxes, {"--pairs", pairs}), HasSubstr("0 missed, 1 extra, 0 twice, 0 ignored"));
  for (const std::string margin : {"0.025", "0.1", "10%"})
    EXPECT_THAT(
        imported("b", boxes, {"--pairs", pairs, "--margin", margin}),
        HasSubstr("0 missed, 0 extra, 0 twice, 1 ignored (0 by filters, 0 by the list, 1 by the margin)"));
  EXPECT_THAT(explained("b", "1", "0,1"), HasSubstr("with its margin of 10% on each side"));
  EXPECT_THAT(imported("c", boxes, {"--pairs", pairs, "--margin", "0.02"}), HasSubstr("1 extra"));
  EXPECT_THAT(imported("d", boxes, {"--pairs", write("none.csv", "step,a,b\n"), "--margin", "0.1"}),
              HasSubstr("0 pairs: 0 missed, 0 extra, 0 twice, 0 ignored"));
  for (const std::string margin : {"x", "-1", "5m", "%", "inf"})
    EXPECT_THAT(refused(boxes, {"--margin", margin}), HasSubstr("--margin '" + margin + "'"));
}

TEST_F(ImportProgram, OddPairFilesAreJudgedOrRefusedByLine) {
  const std::string boxes = given("pair_file/boxes.csv");
  const std::string out = imported("a", boxes, {"--pairs", given("pair_file/p1.csv")});
  EXPECT_THAT(out, HasSubstr("5 pairs: 0 missed, 1 extra, 1 twice"));
  EXPECT_THAT(out, HasSubstr("p1.csv, line 5: object 77 in step 3"));
  EXPECT_THAT(stepped("a", "extra>0"), HasSubstr("theirs, extra: (0,77)"));
  const std::string why = explained("a", "3", "0,77");
  EXPECT_THAT(why, HasSubstr("object 77 is not there\nthe other engine reported it, though it is none"));
  EXPECT_THAT(explained("a", "1", "0, 1"), HasSubstr("are a pair"));
  EXPECT_THAT(refused(boxes, {"--pairs", given("pair_file/p2.csv")}),
              HasSubstr("p2.csv, line 1: its columns are step,a,b"));
  EXPECT_THAT(imported("c", boxes, {"--pairs", given("pair_file/p3.csv")}),
              HasSubstr("3 pairs: 0 missed, 0 extra"));
  EXPECT_THAT(refused(boxes, {"--pairs", given("pair_file/p4.csv")}), HasSubstr("p4.csv is empty"));
  EXPECT_THAT(refused(boxes, {"--pairs", given("pair_file/p5.csv")}), HasSubstr("separated by blanks"));
  EXPECT_THAT(refused(boxes, {"--pairs", write("self.csv", "1,0,1\n1,1,1\n")}),
              HasSubstr("self.csv, line 2"));
}

TEST_F(ImportProgram, TheirNumbersOfStepsAreShownEverywhere) {
  const std::string out =
      imported("a", given("step_offset/boxes.csv"), {"--pairs", given("step_offset/pairs.csv")});
  EXPECT_THAT(
      out,
      StartsWith("2D, 3 steps numbered 5000 to 5002, 2 objects numbered 0 to 1, columns step, object, "));
  EXPECT_THAT(out, HasSubstr("first wrong in step 5001"));
  EXPECT_THAT(stepped("a", "missed>0"), StartsWith("step 5001\n  step 5001: "));
  EXPECT_THAT(explained("a", "5001", "0,1"), HasSubstr("after step 5001, 0 and 1 are a pair"));
  EXPECT_THAT(explained("a", "5001", "0,1"), HasSubstr("became a pair in step 5000"));
  EXPECT_THAT(stepped("a", "step==5001"), StartsWith("step 5001\n"));
  EXPECT_THAT(exported("a", "--boxes"), HasSubstr("\n5002,0,0,2,0,2,0\n"));
  EXPECT_THAT(exported("a", "--pairs"), HasSubstr("step,a,b\n5000,0,1\n5002,0,1\n"));
  const Outcome other = run_kerf({"explain", path("a.kerf"), "--step", "1", "--pair", "0,1"});
  EXPECT_EQ(other.exit, 2);
  EXPECT_THAT(other.err, HasSubstr("goes from step 5000 to 5002"));
}

TEST_F(ImportProgram, SeveralBoxesOfAnObjectAreRefusedOrUnited) {
  const std::string boxes = given("compound_duplicates/boxes.csv");
  const std::string pairs = given("compound_duplicates/pairs.csv");
  EXPECT_THAT(refused(boxes, {"--pairs", pairs}),
              HasSubstr("boxes.csv, line 3: object 0 has a second box in step 1, after that of line 2"));
  const std::string out = imported("a", boxes, {"--pairs", pairs, "--unite"});
  EXPECT_THAT(out, HasSubstr("1 pairs: 0 missed, 0 extra"));
  EXPECT_THAT(out, HasSubstr("several boxes, which were united"));
  EXPECT_THAT(exported("a", "--boxes"), HasSubstr("1,0,0,12,0,2,0\n"));
  (void)imported("b", write("b.csv", "1,0,0,1,0,1\n2,0,,,,\n2,0,5,6,0,1\n"));  // it goes, and another comes
}

TEST_F(ImportProgram, CommentsBlankLinesAndLineEndsMayStandAnywhere) {
  EXPECT_THAT(imported("a", given("heading_and_input/c.csv")), StartsWith("2D, 1 step"));
  EXPECT_THAT(imported("b", given("heading_and_input/d.csv")), StartsWith("2D, 1 step"));
  EXPECT_THAT(imported("c", given("heading_and_input/mac.csv")), StartsWith("2D, 1 step"));
  EXPECT_THAT(
      imported(
          "d",
          write("d.csv",
                "\r\n # a "
                "\"quote\n\nstep,object,min_x,max_x,min_y,max_y\r\r\n1,0,0,2,0,2\n,,,,,\n#\n1,1,0,1,0,1")),
      HasSubstr("2 objects"));
  EXPECT_THAT(refused(write("e.csv", "\n\n1,0,0,2,0,2\r\n\r\n1,1,x,2,0,2\r\n")),
              HasSubstr("line 5: 'x' in column 3"));
  EXPECT_THAT(refused(given("heading_and_input/u16.csv")), HasSubstr("UTF-16"));
  EXPECT_THAT(refused(write("f.csv", std::string("1\0,\0", 4))), HasSubstr("UTF-16"));
}

TEST_F(ImportProgram, StandardInputIsRead) {
  const std::string command = testing::kerf_command({}).front();
  const auto piped = [&](const std::string& input) {
    testing::Process process({"/bin/sh", "-c",
                              "cat '" + given("step_offset/boxes.csv") + "' | '" + command + "' import " +
                                  input + " -o '" + path("s.kerf") + "' --overwrite"});
    return process.wait();
  };
  for (const std::string input : {"-", "/dev/stdin"}) {
    const Outcome outcome = piped(input);
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("3 steps numbered 5000 to 5002"));
  }
}

/// An import, exported and imported again, is the same import.
TEST_F(ImportProgram, WhatWasGivenSurvivesARoundTrip) {
  const std::string boxes = write("boxes.csv",
                                  "step,object,min_x,max_x,min_y,max_y,fixed,category,mask\n"
                                  "10,-5,0.1,1.1,0,1,1,1,3\n10,7000000000,1.1000000001,2,0,1,0,2,1\n"
                                  "10,8,1.5,2,0,1,0,,\n"
                                  "12,-5,0.1,1.1,0,1,0,1,2\n12,8,3,2,0,1,0,,\n"
                                  "13,8,0.5,1.5,0.25,1,0,,\n13,7000000000,,,,,,,\n"
                                  "14,,,,,,,,\n15,8,inf,nan,,1,0,,\n");
  const std::string pairs =
      write("pairs.csv", "step,a,b\n10,8,7000000000\n10,-5,8\n12,8,-5\n13,8,-5\n13,-5,8\n");
  (void)imported("a", boxes, {"--pairs", pairs});
  write("boxes2.csv", exported("a", "--boxes"));
  write("pairs2.csv", exported("a", "--pairs"));
  (void)imported("b", path("boxes2.csv"), {"--pairs", path("pairs2.csv")});
  const Outcome compared = run_kerf({"compare", path("a.kerf"), path("b.kerf")});
  EXPECT_EQ(compared.exit, 0) << compared.out;
  EXPECT_EQ(exported("b", "--boxes"), exported("a", "--boxes"));
  EXPECT_EQ(exported("b", "--pairs"), exported("a", "--pairs"));
  EXPECT_EQ(run_kerf({"verify", path("b.kerf")}).exit, 0);
}

TEST_F(ImportProgram, TwoImportsAreComparedByTheirPairsToo) {
  const std::string boxes = given("step_offset/boxes.csv");
  (void)imported("a", boxes, {"--pairs", given("step_offset/pairs.csv")});
  (void)imported("b", boxes, {"--pairs", write("b.csv", "step,a,b\n5000,0,1\n5001,0,1\n5002,0,1\n")});
  const Outcome compared = run_kerf({"compare", path("a.kerf"), path("b.kerf")});
  EXPECT_EQ(compared.exit, 1);
  EXPECT_THAT(compared.out, HasSubstr("theirs     differ first in step 5001\n  only B reported (0,1)\n"));
  EXPECT_THAT(compared.out, HasSubstr("verdicts   differ first in step 5001\n"));
  (void)imported("c", given("pair_file/boxes.csv"), {"--pairs", given("pair_file/p3.csv")});
  const Outcome renamed = run_kerf({"compare", path("b.kerf"), path("c.kerf")});
  EXPECT_EQ(renamed.exit, 1);
  EXPECT_THAT(renamed.out, HasSubstr("names      differ first in step 5000"));
}

TEST_F(ImportProgram, InterruptedItLeavesNothing) {
  std::string boxes = "step,object,min_x,max_x,min_y,max_y\n";
  for (int step = 1; step <= 200'000; ++step) boxes += std::to_string(step) + ",0,0,1,0,1\n";
  const std::string file = path("a.kerf");
  Process process(kerf_command({"import", write("boxes.csv", boxes), "-o", file}));
  for (int wait = 0; wait < 3000 && parts_of(file).empty(); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  process.signal(SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, 130) << outcome.err;
  EXPECT_TRUE(parts_of(file).empty());
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace kerf
