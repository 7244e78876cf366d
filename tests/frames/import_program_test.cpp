#include "tests/frames/import_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "core/files/part_file.h"
#include "core/recording/recording_reader.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST_F(ImportProgram, ColumnsAreFoundByTheirNames) {
  EXPECT_THAT(imported("a", given("header_order/boxes.csv"), {"--pairs", given("header_order/pairs.csv")}),
              HasSubstr("1 pair: 0 missed, 0 extra"));
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
              HasSubstr("1 pair: 0 missed, 0 extra"));
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
              HasSubstr("1 pair: 0 missed, 0 extra"));
  EXPECT_THAT(explained("a", "1", "0,1"), HasSubstr("y [-2.22045e-61, 1]"));
  EXPECT_THAT(imported("b", given("underflow/denormal.csv")), StartsWith("3D, 1 step"));
  EXPECT_THAT(imported("c", given("underflow/plus.csv")), StartsWith("3D, 1 step"));
  EXPECT_THAT(exported("c", "--boxes"), HasSubstr("1,0,-0.5,0.5,0,1,-0.5,0.5,0\n"));
  (void)imported("d", write("d.csv", "1,0,-1e-400,1e-400,0,1\n"));
  EXPECT_THAT(refused(write("e.csv", "1,0,0,1e400,0,1\n")),
              HasSubstr("'1e400' in column 4, max_x, is too large"));
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
  for (const std::string seconds : {"61", "5e9", "-5", "5x"})
    EXPECT_THAT(refused(write("f.csv", "2024-02-29T23:59:" + seconds + ",0,0,1,0,1\n")),
                HasSubstr("neither a number nor a time"));
}

/// A step taken for another would be judged with its boxes.
TEST_F(ImportProgram, StepsThatDoNotFitTogetherAreRefused) {
  const std::string boxes = write("boxes.csv", "1,0,0,2,0,2\n1,1,1,3,1,3\n2,1,1,3,1,3\n");
  EXPECT_THAT(refused(write("a.csv", "18446744073709551616,0,0,1,0,1\n18446744073709551617,1,0,1,0,1\n")),
              HasSubstr("a.csv, line 2: steps 18446744073709551617 and 18446744073709551616 are too near"));
  EXPECT_THAT(
      refused(write("e.csv", "1.70000000000000000001e9,0,0,1,0,1\n17.0000000000000000002E+8,1,0,1,0,1\n")),
      HasSubstr("are too near"));
  EXPECT_THAT(refused(write("f.csv",
                            "2024-02-29T23:59:59.50000000000001,0,0,1,0,1\n"
                            "2024-02-29T23:59:59.5,1,0,1,0,1\n")),
              HasSubstr("are too near"));
  EXPECT_THAT(refused(write("l.csv", "2016-12-31T23:59:60.5Z,0,0,1,0,1\n2017-01-01T00:00:00.5Z,1,5,6,0,1\n")),
              HasSubstr("are one time: a leap second is the second after it"));
  EXPECT_THAT(imported("same", write("same.csv", "1.5e3,0,0,1,0,1\n1500.0,1,0,1,0,1\n+15E02,2,0,1,0,1\n")),
              HasSubstr("1 step numbered 1.5e3"));
  EXPECT_THAT(imported("dates", write("dates.csv",
                                      "2024-02-29T23:59:59.5Z,0,0,1,0,1\n"
                                      "2024-02-29 23:59:59.50,1,0,1,0,1\n")),
              HasSubstr("1 step numbered 2024"));
  const std::string near = write("near.csv", "step,a,b\n1,0,1\n2.00000000000000000000001,0,1\n");
  EXPECT_THAT(refused(boxes, {"--pairs", near}), HasSubstr("near.csv, line 3: steps 2.0000"));
  const std::string both = write("both.csv", "step,a,b\n1.00000000000000000000001,0,1\n1,0,1\n");
  EXPECT_THAT(refused(boxes, {"--pairs", both}), HasSubstr("both.csv, line 3: steps 1 and 1.0000"));
  const std::string dates = write("dates.csv", "step,a,b\n2024-02-29T23:59:59,0,1\n");
  EXPECT_THAT(refused(boxes, {"--pairs", dates}),
              HasSubstr("dates.csv, line 2: step 2024-02-29T23:59:59 is a date, and step 1 is a number"));
  EXPECT_THAT(refused(write("m.csv", "1,0,0,1,0,1\n2024-02-29T23:59:59,0,0,1,0,1\n")),
              HasSubstr("is a date"));
  const std::string same = write("same.csv", "step,a,b\n1.0,0,1\n+1,0,1\n01.00,0,1\n1e0,0,1\n2.0,0,1\n");
  EXPECT_THAT(imported("s", boxes, {"--pairs", same}), HasSubstr("5 pairs: 0 missed, 0 extra, 3 twice"));
}

TEST_F(ImportProgram, WhatIsOddIsAlwaysNamed) {
  std::string boxes =
      "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n1,1,0,1,,1\n1,2,nan,1,0,1\n1,3,-inf,1,0,1\n";
  for (int object = 10; object < 17; ++object) boxes += "2," + std::to_string(object) + ",5,4,0,1\n";
  boxes += "5,0,0,1,0,1\n";
  const std::string pairs = write("pairs.csv", "1,0,3\n2,0,77\n4,0,3\n");
  const std::string out = imported("a", write("boxes.csv", boxes), {"--pairs", pairs});
  EXPECT_THAT(out, HasSubstr("odd: 1 box that is half blank"));
  EXPECT_THAT(out, HasSubstr("boxes.csv, line 3: object 1 in step 1"));
  EXPECT_THAT(out, HasSubstr("odd: 1 box that is not all numbers"));
  EXPECT_THAT(out, HasSubstr("odd: 1 box that reaches to infinity"));
  EXPECT_THAT(out, HasSubstr("odd: 7 boxes that are inverted"));
  EXPECT_THAT(out, HasSubstr("line 10: object 14 in step 2\n  and 2 more\n"));
  EXPECT_THAT(out, HasSubstr("odd: 1 gap between steps"));
  EXPECT_THAT(out, HasSubstr("step 4 follows step 2"));
  EXPECT_THAT(out, HasSubstr("odd: 1 step with pairs and without a line of boxes"));
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

TEST_F(ImportProgram, SeveralBoxesOfAnObjectAreRefusedOrUnited) {
  const std::string boxes = given("compound_duplicates/boxes.csv");
  const std::string pairs = given("compound_duplicates/pairs.csv");
  EXPECT_THAT(refused(boxes, {"--pairs", pairs}),
              HasSubstr("boxes.csv, line 3: object 0 has a second box in step 1, after that of line 2"));
  const std::string out = imported("a", boxes, {"--pairs", pairs, "--unite"});
  EXPECT_THAT(out, HasSubstr("1 pair: 0 missed, 0 extra"));
  EXPECT_THAT(out, HasSubstr("several boxes, which were united"));
  EXPECT_THAT(exported("a", "--boxes"), HasSubstr("1,0,0,12,0,2,0\n"));
  (void)imported("b", write("b.csv", "1,0,0,1,0,1\n2,0,,,,\n2,0,5,6,0,1\n"));  // it goes, and another comes
}

/// One of them would hold for all boxes, and excuse a miss or accuse the engine of one.
TEST_F(ImportProgram, BoxesOfWhichTheFiltersOrTurnsDifferAreNotUnited) {
  const std::string head = "step,object,min_x,max_x,min_y,max_y,category,mask,angle\n1,0,0,1,0,1,";
  const auto said = [&](const std::string& first, const std::string& second) {
    return refused(write("parts.csv", head + first + "\n1,0,5,6,0,1," + second + "\n"), {"--unite"});
  };
  EXPECT_THAT(said("1,0,", "1,-1,"),
              HasSubstr("parts.csv, line 3: object 0 has boxes of different category or mask in step 1"));
  EXPECT_THAT(said("2,,", "1,,"), HasSubstr("different category or mask"));
  EXPECT_THAT(said(",,", "1,0,"), HasSubstr("different category or mask"));
  EXPECT_THAT(said(",,0.5", ",,0.25"), HasSubstr("object 0 is turned in two ways in step 1"));
  for (const std::string second : {"2,3,0.5", ",,", "2,3,", ",,0.5", "2,,", ",3,"})
    EXPECT_THAT(imported("a", write("b.csv", head + "2,3,0.5\n1,0,5,6,0,1," + second + "\n"), {"--unite"}),
                HasSubstr("united"));
}

/// A blank mask was all bits: an engine was accused of a miss, or a miss of it was ignored.
TEST_F(ImportProgram, ABlankCategoryOrMaskIsAsBefore) {
  const std::string head = "step,object,min_x,max_x,min_y,max_y,category,mask\n";
  const std::string none = write("none.csv", "step,a,b\n");
  const auto verdict = [&](const std::string& first, const std::string& later) {
    const std::string lines =
        head + "1,0,0,1,0,1," + first + "\n1,1,0,1,0,1,1,7\n2,0,0,1.5,0,1," + later + "\n";
    return imported("a", write("a.csv", lines), {"--pairs", none});
  };
  EXPECT_THAT(verdict("1,4", "1,"), HasSubstr("0 missed, 0 extra, 0 twice, 2 ignored"));
  EXPECT_THAT(verdict("8,1", ",1"), HasSubstr("0 missed, 0 extra, 0 twice, 2 ignored"));
  EXPECT_THAT(verdict("1,4", "1,1"), HasSubstr("1 missed, 0 extra, 0 twice, 1 ignored"));
}

TEST_F(ImportProgram, WhatOverlapsAJoinedBoxIsSaidToBeAPair) {
  const std::string head = "step,object,min_x,max_x,min_y,max_y\n";
  const std::string pairs = write("pairs.csv", "step,a,b\n2,1,2\n");
  const std::string notch = "1,1,0,10,0,1\n1,1,0,1,0,10\n1,2,5,6,5,6\n2,2,5,6,5,6\n";
  const std::string boxes = write("notch.csv", head + notch);
  EXPECT_THAT(refused(boxes), HasSubstr("and whatever overlaps that is a pair then"));
  EXPECT_THAT(
      imported("a", boxes, {"--pairs", pairs, "--unite"}),
      AllOf(HasSubstr("1 missed, 0 extra"), HasSubstr("united: what overlaps the joined box is a pair")));
}

/// The smallest box around [0, 1] and an inverted [5, 3] is valid.
TEST_F(ImportProgram, AJoinedBoxOfWhichAPartIsInvertedIsInQuarantine) {
  const std::string head = "step,object,min_x,max_x,min_y,max_y\n";
  const std::vector<std::string> more{"--pairs", write("none.csv", "step,a,b\n"), "--unite"};
  for (const std::string parts :
       {"1,1,0,1,0,1\n1,1,5,3,0,1\n", "1,1,5,3,0,1\n1,1,0,1,0,1\n", "1,1,0,1,0,1\n1,1,5,3,0,1\n1,1,2,9,0,1\n",
        "1,1,0,1,0,1\n1,1,nan,3,0,1\n"}) {
    const std::string boxes = write("boxes.csv", head + parts + "1,2,2,2.5,0,1\n");
    EXPECT_THAT(imported("a", boxes, more), HasSubstr("0 missed, 0 extra")) << parts;
    EXPECT_THAT(explained("a", "1", "1,2"), HasSubstr("object 1 is in quarantine")) << parts;
  }
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
  const std::string command = test::kerf_command({}).front();
  const auto piped = [&](const std::string& input) {
    test::Process process({"/bin/sh", "-c",
                           "cat '" + given("step_offset/boxes.csv") + "' | '" + command + "' import " +
                               input + " -o '" + path("s.kerf") + "' --overwrite"});
    return process.wait();
  };
  for (const std::string input : {"-", "/dev/stdin"}) {
    const RunOutcome outcome = piped(input);
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("3 steps numbered 5000 to 5002"));
  }
  const std::string none = write("none.csv", "step,a,b\n");
  EXPECT_THAT(refused("-", {"--pairs", none, "--ignore", "-"}), HasSubstr("can come from standard input"));
  EXPECT_THAT(refused("-", {"--objects", "-"}), HasSubstr("can come from standard input"));
}

TEST_F(ImportProgram, InterruptedItLeavesNothing) {
  std::string boxes = "step,object,min_x,max_x,min_y,max_y\n";
  for (int step = 1; step <= 200'000; ++step) boxes += std::to_string(step) + ",0,0,1,0,1\n";
  const std::string file = path("a.kerf");
  Process process(kerf_command({"import", write("boxes.csv", boxes), "-o", file}));
  ASSERT_TRUE(holds_within_a_minute([&] { return !parts_of(file).empty(); }));
  process.signal(SIGINT);
  const RunOutcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, 130) << outcome.err;
  EXPECT_TRUE(parts_of(file).empty());
  EXPECT_FALSE(std::filesystem::exists(file));
}

/// A recording of doubles keeps no sign of a zero, one of floats did: what was exported was another run.
TEST_F(ImportProgram, AMinusBeforeAZeroIsNothing) {
  const std::string a =
      write("a.csv", "step,object,min_x,max_x,min_y,max_y\n1,0,-1,-0.0,-0,1\n1,1,-0.0,0.1,0,1\n");
  ASSERT_THAT(imported("a", a), HasSubstr("2 objects"));
  ASSERT_NE(imported("b", write("b.csv", exported("a", "--boxes"))), "");
  const RunOutcome compared = run_kerf({"compare", path("a.kerf"), path("b.kerf")});
  EXPECT_EQ(compared.exit, 0) << compared.out;
}

}  // namespace
}  // namespace kerf::test
