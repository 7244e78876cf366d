#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/frames/import_program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// What is said of another engine's pairs, and what is kept of them.
using ImportVerdict = test::ImportProgram;

TEST_F(ImportVerdict, PairsAreJudgedInThePrecisionGiven) {
  const std::string boxes = given("double_far/boxes.csv");
  EXPECT_THAT(imported("a", boxes, {"--pairs", given("double_far/pairs.csv")}),
              HasSubstr("1 pair: 0 missed, 0 extra, 0 twice"));
  const std::string why = explained("a", "1", "0,1");
  EXPECT_THAT(why, HasSubstr("0 and 1 are no pair: axis x separates them by 0.05"));
  EXPECT_THAT(why, HasSubstr("0: x [20000000, 20000000.9]"));
  EXPECT_THAT(why, HasSubstr("1: x [20000000.95, 20000001.85]"));
  EXPECT_THAT(why, HasSubstr("rounded outward to floats"));
  EXPECT_THAT(why, Not(HasSubstr("became a pair")));
  EXPECT_EQ(run_kerf({"verify", path("a.kerf")}).exit, 0);
  const std::string reported = write("reported.csv", "step,a,b\n1,0,1\n1,2,3\n");
  EXPECT_THAT(imported("b", boxes, {"--pairs", reported}), HasSubstr("2 pairs: 0 missed, 1 extra"));
  const std::string silent = write("silent.csv", "step,a,b\n");
  EXPECT_THAT(imported("c", boxes, {"--pairs", silent}), HasSubstr("0 pairs: 1 missed, 0 extra"));
}

/// One number of six digits does not show that the file was rounded: the verdict stays.
TEST_F(ImportVerdict, WhatTheLastDigitDecidesIsSaid) {
  const std::string head = "step,object,min_x,max_x,min_y,max_y\n";
  const std::string nothing = write("nothing.csv", "step,a,b\n");
  const std::string both = write("both.csv", "step,a,b\n1,0,1\n");
  const std::string touching = write("touching.csv", head + "1,0,0.5,1.23457,0,1\n1,1,1.23457,2,0,1\n");
  const std::string out = imported("a", touching, {"--pairs", nothing});
  EXPECT_THAT(out, HasSubstr("0 pairs: 1 missed"));
  EXPECT_THAT(out, HasSubstr("odd: 1 pair that may touch only in the digits that were written"));
  EXPECT_THAT(out, HasSubstr("pair 0,1 in step 1"));
  EXPECT_THAT(refused(touching, {"--pairs", nothing, "--strict"}), HasSubstr("the digits that were written"));
  EXPECT_THAT(imported("a", touching, {"--pairs", both}), Not(HasSubstr("odd")));
  const std::string apart = write("apart.csv", head + "1,0,0.5,1.23457,0,1\n1,1,1.23458,2,0,1\n");
  EXPECT_THAT(imported("a", apart, {"--pairs", both}), AllOf(HasSubstr("1 extra"), Not(HasSubstr("odd"))))
      << "rounding keeps the order of numbers";
  // An overlap of two digits, few digits, floats as they are, and as many digits as floats need decide
  // themselves.
  for (const std::string bounds : {"1.23459,0,1\n1,1,1.23457", "0.1,0,1\n1,1,0.1",
                                   "1.0078125,0,1\n1,1,1.0078125", "1.23456789,0,1\n1,1,1.23456789"}) {
    const std::string boxes = write("boxes.csv", head + "1,0,-1," + bounds + ",2,0,1\n");
    EXPECT_THAT(imported("a", boxes, {"--pairs", nothing}), Not(HasSubstr("digits"))) << bounds;
  }
}

TEST_F(ImportVerdict, AMarginIsRoundedWhereTheEngineRoundsIt) {
  const std::string boxes = write("boxes.csv",
                                  "step,object,min_x,max_x,min_y,max_y\n1,0,-0.190664291,-0.0368452519,0,1\n"
                                  "1,1,0.0302122459,0.546967924,0,1\n");
  const std::string pairs = write("pairs.csv", "step,a,b\n1,0,1\n");
  EXPECT_THAT(imported("a", boxes, {"--pairs", pairs, "--margin", "10%"}), HasSubstr("0 extra"));
  EXPECT_THAT(imported("b", boxes, {"--pairs", pairs, "--margin", "9.99%"}), HasSubstr("1 extra"));
}

TEST_F(ImportVerdict, ChangesOfMobilityAreFollowedAndExported) {
  const std::string out =
      imported("a", given("type_change/boxes.csv"), {"--pairs", given("type_change/pairs.csv")});
  EXPECT_THAT(out, HasSubstr("2 pairs: 0 missed, 0 extra"));
  EXPECT_THAT(out, HasSubstr("odd: 1 change between fixed and moving"));
  EXPECT_THAT(out, HasSubstr("line 4: object 1 is moving from step 2 on"));
  EXPECT_THAT(explained("a", "1", "0,1"), HasSubstr("both are fixed"));
  EXPECT_THAT(exported("a", "--boxes"), HasSubstr("\n2,1,4,5,0.8,1.8,0\n3,1,"));
  EXPECT_THAT(imported("b", given("type_change/b.csv"), {"--pairs", given("type_change/bp.csv")}),
              HasSubstr("1 pair: 0 missed, 0 extra"));
}

/// An object that goes and comes again with another mobility, and one that changes it.
TEST_F(ImportVerdict, AFilterIsExportedAsItCame) {
  const std::string boxes =
      write("boxes.csv",
            "step,object,min_x,max_x,min_y,max_y,fixed,category,mask\n1,0,0,1,0,1,1,2,3\n"
            "1,1,5,6,0,1,1,2,3\n2,0,,,,,,,\n2,0,0,1,0,1,0,2,3\n2,1,5,6,0,1,0,,\n");
  (void)imported("a", boxes);
  (void)imported("b", write("b.csv", exported("a", "--boxes")));
  const RunOutcome compared = run_kerf({"compare", path("a.kerf"), path("b.kerf")});
  EXPECT_EQ(compared.exit, 0) << compared.out;
}

TEST_F(ImportVerdict, AnObjectThatComesAgainHasNoFilterOfBefore) {
  const std::string boxes = write("boxes.csv",
                                  "step,object,min_x,max_x,min_y,max_y,category,mask\n1,0,0,2,0,2,1,1\n"
                                  "1,1,1,3,0,2,2,2\n2,1,,,,,,\n3,1,1,3,0,2,,\n4,1,1,3,0,2,,\n");
  EXPECT_THAT(imported("a", boxes, {"--pairs", write("pairs.csv", "step,a,b\n")}),
              HasSubstr("0 pairs: 2 missed, 0 extra, 0 twice, 1 ignored"));
}

/// A row for a filter that was back at once was gone in the import of what was exported.
TEST_F(ImportVerdict, AFilterThatIsBackInTheSameStepIsNoChange) {
  const std::string comes = ",1,1,3,0,2,2,2\n";
  const std::string goes = ",1,,,,,,\n";
  const std::string boxes =
      write("boxes.csv", "step,object,min_x,max_x,min_y,max_y,category,mask\n1,0,0,2,0,2,,\n1" + comes +
                             "2,0,0,2,0,2,4,4\n2,0,,,,,,\n2,0,0,2,0,2,,\n3" + goes + "4" + comes + "5" +
                             goes + "5" + comes + "6" + goes + "7,1,1,3,0,2,,\n");
  const std::vector<std::string> pairs{"--pairs", write("pairs.csv", "step,a,b\n7,0,1\n")};
  const std::string counts = "1 pair: 0 missed, 0 extra, 0 twice, 4 ignored";
  EXPECT_THAT(imported("a", boxes, pairs), HasSubstr(counts));
  EXPECT_THAT(imported("b", write("written.csv", exported("a", "--boxes")), pairs), HasSubstr(counts));
  const RunOutcome compared = run_kerf({"compare", path("a.kerf"), path("b.kerf")});
  EXPECT_EQ(compared.exit, 0) << compared.out;
}

/// They were called the same: no step of theirs differs.
TEST_F(ImportVerdict, WhatWasDeclaredIsCompared) {
  const std::string boxes =
      write("boxes.csv", "step,object,min_x,max_x,min_y,max_y\n1,7,0,2,0,2\n1,8,1,3,0,2\n1,9,8,9,8,9\n");
  const std::string pairs = write("pairs.csv", "step,a,b\n1,7,8\n");
  const std::string list = write("ignored.csv", "a,b\n9,7\n9,8\n");
  (void)imported("plain", boxes, {"--pairs", pairs});
  (void)imported("again", boxes, {"--pairs", pairs});
  (void)imported("share", boxes, {"--pairs", pairs, "--margin", "50%"});
  (void)imported("length", boxes, {"--pairs", pairs, "--margin", "0.25", "--ignore", list});
  const auto compare = [&](const std::string& a, const std::string& b) {
    return run_kerf({"compare", path(a + ".kerf"), path(b + ".kerf")});
  };
  EXPECT_EQ(compare("plain", "again").exit, 0);
  EXPECT_EQ(compare("length", "length").exit, 0);
  const RunOutcome margins = compare("plain", "share");
  EXPECT_EQ(margins.exit, 1);
  EXPECT_THAT(margins.out, HasSubstr("declared   margin: none in A, 0.5 of the extent in B\n"));
  const RunOutcome lists = compare("length", "plain");
  EXPECT_EQ(lists.exit, 1);
  EXPECT_THAT(lists.out, HasSubstr("declared   margin: 0.25 in A, none in B\n"));
  EXPECT_THAT(lists.out, HasSubstr("declared   ignored pairs: only A has (7,9) and 1 more\n"));
}

/// A table that was cut off, or an engine that stopped to report: neither is passed over.
TEST_F(ImportVerdict, PairsThatEndBeforeTheBoxesAreOddIfAnyIsMissed) {
  const std::string heading = "step,object,min_x,max_x,min_y,max_y\n1,0,0,2,0,2\n1,1,1,3,0,2\n";
  const std::string pairs = write("pairs.csv", "step,a,b\n1,0,1\n");
  const std::string stays = write("boxes.csv", heading + "2,0,0,2,0,2\n");
  EXPECT_THAT(
      imported("a", stays, {"--pairs", pairs}),
      HasSubstr("odd: 1 table of pairs that ends before the boxes: later overlaps count as missed\n  " +
                pairs + ": pairs end in step 1, boxes in step 2\n"));
  EXPECT_THAT(refused(stays, {"--pairs", pairs, "--strict"}), HasSubstr("pairs end in step 1"));
  EXPECT_THAT(imported("a", write("boxes.csv", heading + "2,0,7,9,0,2\n"), {"--pairs", pairs}),
              Not(HasSubstr("odd")));
}

/// Of an engine whose pairs are written every few steps, or late, overlaps were called missed in silence.
TEST_F(ImportVerdict, StepsWithoutALineOfPairsAreOddIfAnyIsMissed) {
  std::string text = "step,object,min_x,max_x,min_y,max_y\n";
  for (const char* const step : {"1", "2", "3", "4", "5"})
    text += std::string(step) + ",0,0,2,0,2\n" + step + ",1,1,3,0,2\n";
  const std::string boxes = write("boxes.csv", text);
  const std::string every = write("every.csv", "step,a,b\n1,0,1\n3,0,1\n5,0,1\n");
  EXPECT_THAT(
      imported("a", boxes, {"--pairs", every}),
      HasSubstr("odd: 2 steps without a line of pairs, before the first or between: overlaps count as "
                "missed\n  " +
                every + ": step 2\n  " + every + ": step 4\n"));
  EXPECT_THAT(refused(boxes, {"--pairs", every, "--strict"}), HasSubstr("odd: 2 steps without a line"));
  const std::string late = write("late.csv", "step,a,b\n5,0,1\n");
  EXPECT_THAT(imported("a", boxes, {"--pairs", late}), HasSubstr("odd: 4 steps without a line of pairs"));
  const std::string apart = write("apart.csv", text + "6,1,7,9,0,2\n7,1,1,3,0,2\n");
  const std::string all = write("all.csv", "step,a,b\n1,0,1\n2,0,1\n3,0,1\n4,0,1\n5,0,1\n7,0,1\n");
  EXPECT_THAT(imported("a", apart, {"--pairs", all}), Not(HasSubstr("odd"))) << "in step 6 there is none";
}

TEST_F(ImportVerdict, InvertedBoxesAreCountedAndExplained) {
  const std::string out =
      imported("a", given("inverted/boxes.csv"), {"--pairs", given("inverted/pairs.csv")});
  EXPECT_THAT(out, HasSubstr("odd: 1 box that is inverted"));
  EXPECT_THAT(out, HasSubstr("boxes.csv, line 3: object 1 in step 1"));
  const std::string why = explained("a", "1", "0,1");
  EXPECT_THAT(why, HasSubstr("object 1 is in quarantine: its box, x [3, 1]"));
  EXPECT_THAT(why, HasSubstr("the other engine reported it, though it is none"));
  EXPECT_THAT(refused(given("inverted/boxes.csv"), {"--strict"}), HasSubstr("line 3: object 1 in step 1"));
}

TEST_F(ImportVerdict, WhatAnEngineFiltersIsDeclaredAndCountedApart) {
  const std::string pairs = given("filters/pairs.csv");
  EXPECT_THAT(imported("a", given("filters/boxes.csv"), {"--pairs", pairs}),
              HasSubstr("1 pair: 1 missed, 0 extra"));
  EXPECT_THAT(stepped("a", "missed>0"), HasSubstr("theirs, missed: (0,1)"));
  const std::string ignore = write("ignore.csv", "a,b\n1,0\n7,9\n");
  EXPECT_THAT(imported("b", given("filters/boxes.csv"), {"--pairs", pairs, "--ignore", ignore}),
              HasSubstr("1 pair: 0 missed, 0 extra, 0 twice, 1 ignored (0 by filters, 1 by the list"));
  const std::string unknown = "odd: 1 pair to be ignored with an object that the run does not have\n  " +
                              ignore + ", line 3: object 7\n";
  EXPECT_THAT(imported("e", given("filters/boxes.csv"), {"--pairs", pairs, "--ignore", ignore}),
              HasSubstr(unknown));
  EXPECT_THAT(refused(given("filters/boxes.csv"), {"--pairs", pairs, "--ignore", ignore, "--strict"}),
              HasSubstr(unknown));
  EXPECT_THAT(explained("b", "1", "0,1"), HasSubstr("it is ignored"));
  // Numbers that begin anywhere, that have gaps, or of which others stand in the pairs alone.
  const std::string high = write("high.csv",
                                 "step,object,min_x,max_x,min_y,max_y\n1,10,0,2,0,2\n1,20,1,3,0,2\n"
                                 "1,5000000000,9,10,0,1\n");
  for (const char* const reported : {"step,a,b\n1,10,5000000000\n", "step,a,b\n", "step,a,b\n1,2,3\n"})
    EXPECT_THAT(imported("f", high,
                         {"--pairs", write("reported.csv", reported), "--ignore",
                          write("listed.csv", "a,b\n20,10\n10,5000000000\n")}),
                AllOf(HasSubstr(" 0 missed"), Not(HasSubstr("to be ignored with an object"))))
        << reported;
  const std::string low =
      write("low.csv", "step,object,min_x,max_x,min_y,max_y\n1,10,0,2,0,2\n1,20,1,3,0,2\n");
  EXPECT_THAT(
      imported("g", low,
               {"--pairs", write("none.csv", "step,a,b\n"), "--ignore", write("listed.csv", "a,b\n20,10\n")}),
      HasSubstr("0 pairs: 0 missed, 0 extra, 0 twice, 1 ignored"));
  EXPECT_THAT(stepped("b", "ignored>0"), HasSubstr("theirs, ignored, listed: (0,1)"));
  const std::string masked = write("masked.csv",
                                   "step,object,min_x,max_x,min_y,max_y,category,mask\n"
                                   "1,0,0,1,0,1,1,2\n1,1,0.9,1.9,0,1,0x4,0X7\n1,2,1.8,2.8,0,1,2,6\n");
  EXPECT_THAT(imported("c", masked, {"--pairs", pairs}), HasSubstr("1 ignored (1 by filters"));
  const std::string heading = "step,object,min_x,max_x,min_y,max_y,category,mask\n1,0,0,1,0,1,1,";
  for (const std::string mask : {"0x", "0xfg", "0x10000000000000000"})
    EXPECT_THAT(refused(write("d.csv", heading + mask + "\n")),
                HasSubstr("is no hexadecimal number of 64 bits"));
  EXPECT_THAT(explained("c", "1", "0,1"), HasSubstr("the other engine's masks leave it out"));
  EXPECT_EQ(run_kerf({"verify", path("c.kerf")}).exit, 0);
  EXPECT_THAT(run_kerf({"verify", path("c.kerf")}).out, HasSubstr("0 twice, 1 ignored"));
}

TEST_F(ImportVerdict, AMarginIsDeclared) {
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
  for (const std::string option : {"--margin", "--ignore"})
    EXPECT_THAT(refused(boxes, {option, "0.1"}),
                HasSubstr(option + " is for judging their pairs; give --pairs"));
}

/// What an engine reports where no boxes overlap is excused by no mask and no list.
TEST_F(ImportVerdict, MasksAndTheListExcuseNoReportedPairWithoutAnOverlap) {
  const std::string heading = "step,object,min_x,max_x,min_y,max_y";
  const std::string pairs = write("pairs.csv", "step,a,b\n1,1,2\n1,1,3\n");
  const std::string masked =
      write("masked.csv", heading + ",category,mask\n1,1,0,1,0,1,1,2\n1,2,5,6,0,1,1,2\n1,3,0,1,0,1,1,2\n");
  EXPECT_THAT(imported("a", masked, {"--pairs", pairs}), HasSubstr("1 extra, 0 twice, 0 ignored"));
  EXPECT_THAT(explained("a", "1", "1,2"), HasSubstr("the other engine reported it, though it is none"));
  const std::string plain = write("plain.csv", heading + "\n1,1,0,1,0,1\n1,2,5,6,0,1\n1,3,0,1,0,1\n");
  EXPECT_THAT(imported("b", plain, {"--pairs", pairs, "--ignore", write("listed.csv", "a,b\n1,2\n")}),
              HasSubstr("1 extra, 0 twice, 0 ignored"));
  EXPECT_EQ(run_kerf({"verify", path("b.kerf")}).exit, 0);
}

TEST_F(ImportVerdict, AMarginExcusesNoGapThatIsMuchLarger) {
  const std::string heading = "step,object,min_x,max_x,min_y,max_y\n";
  const std::string pairs = write("pairs.csv", "step,a,b\n1,1,2\n");
  const auto judged = [&](const std::string& boxes, const std::string& margin) {
    return imported("a", write("boxes.csv", heading + boxes), {"--pairs", pairs, "--margin", margin});
  };
  EXPECT_THAT(judged("1,1,5000000.1,5000001.1,0,1\n1,2,5000002.9,5000003.9,0,1\n", "0.05"),
              HasSubstr("1 extra, 0 twice, 0 ignored"));
  EXPECT_THAT(judged("1,1,1499,1500,0,1\n1,2,1500.10009765625,1501,0,1\n", "0.05"),
              HasSubstr("0 extra, 0 twice, 1 ignored"));
  EXPECT_THAT(explained("a", "1", "1,2"),
              HasSubstr("with its margin of 0.05 on each side the boxes overlap, as floats round it\n"));
  EXPECT_EQ(run_kerf({"verify", path("a.kerf")}).exit, 0);
}

/// Where nothing was judged there is no answer, not "there is no such moment".
TEST_F(ImportVerdict, WithoutPairsNothingIsMissed) {
  (void)imported("np", given("step_offset/boxes.csv"));
  const std::string why =
      path("np.kerf") + " has no pairs of another engine; `kerf import --pairs` brings them";
  for (const std::string condition : {"missed>0", "missed==0", "ignored>0 || step>1", "extra>0", "twice>0"}) {
    const RunOutcome stepped = run_kerf({"step", path("np.kerf"), "--to", condition});
    EXPECT_EQ(stepped.exit, 2) << condition;
    EXPECT_THAT(stepped.err, HasSubstr(why));
    EXPECT_EQ(run_kerf({"step", path("np.kerf"), "--to", condition, "--reverse"}).exit, 2);
    const RunOutcome small =
        run_kerf({"minimize", path("np.kerf"), "--when", condition, "-o", path("small.kerf")});
    EXPECT_EQ(small.exit, 2) << condition;
    EXPECT_THAT(small.err, HasSubstr(why));
  }
  EXPECT_EQ(run_kerf({"step", path("np.kerf"), "--to", "pairs>0"}).exit, 0);
}

TEST_F(ImportVerdict, OddPairFilesAreJudgedOrRefusedByLine) {
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

TEST_F(ImportVerdict, TheirNumbersOfStepsAreShownEverywhere) {
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
  const RunOutcome other = run_kerf({"explain", path("a.kerf"), "--step", "1", "--pair", "0,1"});
  EXPECT_EQ(other.exit, 2);
  EXPECT_THAT(other.err, HasSubstr("goes from step 5000 to 5002"));
}

/// An import, exported and imported again, is the same import.
TEST_F(ImportVerdict, WhatWasGivenSurvivesARoundTrip) {
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
  const RunOutcome compared = run_kerf({"compare", path("a.kerf"), path("b.kerf")});
  EXPECT_EQ(compared.exit, 0) << compared.out;
  EXPECT_EQ(exported("b", "--boxes"), exported("a", "--boxes"));
  EXPECT_EQ(exported("b", "--pairs"), exported("a", "--pairs"));
  EXPECT_EQ(run_kerf({"verify", path("b.kerf")}).exit, 0);
}

TEST_F(ImportVerdict, TwoImportsAreComparedByTheirPairsToo) {
  const std::string boxes = given("step_offset/boxes.csv");
  (void)imported("a", boxes, {"--pairs", given("step_offset/pairs.csv")});
  (void)imported("b", boxes, {"--pairs", write("b.csv", "step,a,b\n5000,0,1\n5001,0,1\n5002,0,1\n")});
  const RunOutcome compared = run_kerf({"compare", path("a.kerf"), path("b.kerf")});
  EXPECT_EQ(compared.exit, 1);
  EXPECT_THAT(compared.out, HasSubstr("theirs     differ first in step 5001\n  only B reported (0,1)\n"));
  EXPECT_THAT(compared.out, HasSubstr("verdicts   differ first in step 5001\n"));
  (void)imported("c", given("pair_file/boxes.csv"), {"--pairs", given("pair_file/p3.csv")});
  const RunOutcome renamed = run_kerf({"compare", path("b.kerf"), path("c.kerf")});
  EXPECT_EQ(renamed.exit, 1);
  EXPECT_THAT(renamed.out, HasSubstr("names      differ first in step 5000"));
}

TEST_F(ImportVerdict, TwoImportsAreComparedByTheirShapesToo) {
  const std::string boxes =
      write("boxes.csv", "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n2,1,3,4,0,1\n");
  const auto shaped = [&](const std::string& name, const std::string& radius) {
    (void)imported(name, boxes,
                   {"--objects", write("objects.csv", "object,shape,radius\n1,ball," + radius + "\n")});
  };
  shaped("a", "0.5");
  shaped("b", "0.2");
  shaped("c", "0.5");
  EXPECT_EQ(run_kerf({"compare", path("a.kerf"), path("c.kerf")}).exit, 0);
  const RunOutcome compared = run_kerf({"compare", path("a.kerf"), path("b.kerf")});
  EXPECT_EQ(compared.exit, 1);
  EXPECT_THAT(compared.out, HasSubstr("shapes     differ first in step 2\n"));
  EXPECT_THAT(run_kerf({"compare", path("a.kerf"), path("b.kerf"), "--json"}).out,
              HasSubstr("\"shapes\": 2,"));
  (void)imported("d", boxes);
  EXPECT_EQ(run_kerf({"compare", path("a.kerf"), path("d.kerf")}).exit, 1);
}

}  // namespace
}  // namespace kerf::test
