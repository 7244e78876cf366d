#include "frames/advise/advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace kerf {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

BenchRow row_of(const std::string& name, std::vector<double> rounds) {
  BenchRow row;
  row.cell = {"scene", 3, 1000, 1};
  row.algorithm = name;
  row.median_ns = *std::ranges::min_element(rounds);
  row.p99_ns = row.median_ns * 2;
  row.max_ns = row.median_ns * 3;
  row.rss_bytes = 200000;
  row.steps = 50;
  row.round_ns = std::move(rounds);
  return row;
}

std::vector<std::string> names_of(const Advice& advice) {
  std::vector<std::string> names;
  for (const Standing& each : advice.standings) names.push_back(each.row.algorithm);
  return names;
}

TEST(Advice, NamesTheFastestAndByHowMuch) {
  CellResult cell;
  cell.rows = {row_of("floor", {1, 1, 1}), row_of("columns", {132, 130, 140}),
               row_of("kerf", {100, 100, 100}), row_of("bullet-dbvt", {1000, 900, 1100})};
  const Advice advice = advise(cell);
  EXPECT_THAT(names_of(advice), ElementsAre("kerf", "columns", "bullet-dbvt"));
  ASSERT_EQ(advice.sentences.size(), 2U);
  EXPECT_EQ(advice.sentences[0],
            "kerf: 1.32 times as fast as columns (1.30 to 1.40 in the rounds), 0.100 ms a step instead of "
            "0.132.");
  EXPECT_THAT(advice.sentences[1], HasSubstr("10.0 times as fast as bullet-dbvt, the fastest library"));
}

TEST(Advice, SaysThatNoiseDecidesNothing) {
  CellResult cell;
  cell.rows = {row_of("columns", {100, 104, 99}), row_of("kerf", {101, 99, 98}),
               row_of("sort-and-sweep", {300, 310, 290})};
  const Advice advice = advise(cell);
  ASSERT_EQ(advice.sentences.size(), 2U);
  EXPECT_EQ(
      advice.sentences[0],
      "kerf and columns: they do not differ by more than the noise, so choose by memory and worst step.");
  EXPECT_THAT(advice.sentences[1], HasSubstr("times as fast as sort-and-sweep"));
}

TEST(Advice, NeverNamesAWrongOneAsTheFastest) {
  CellResult cell;
  cell.rows = {row_of("fcl-spatial-hash", {1, 1}), row_of("kerf", {100, 100}), row_of("columns", {200, 200})};
  cell.rows[0].missed = 12;
  const Advice advice = advise(cell);
  EXPECT_THAT(names_of(advice), ElementsAre("kerf", "columns"));
  EXPECT_THAT(advice.sentences,
              Contains("fcl-spatial-hash: not for this scene, it misses 12 pairs and invents "
                       "0 in 50 steps."));
}

TEST(Advice, PassesOverThoseThatDidNotComeToTheEnd) {
  CellResult cell;
  cell.rows = {row_of("kerf-paper", {1}), row_of("kerf", {100, 100}), row_of("columns", {200, 200})};
  cell.gaps = {{cell.rows[0].cell, "kerf-paper", "left out after 10 s"}};
  EXPECT_THAT(names_of(advise(cell)), ElementsAre("kerf", "columns"));
  cell.rows.resize(1);
  EXPECT_THAT(advise(cell).standings, IsEmpty());
  EXPECT_THAT(advise(cell).sentences, ElementsAre(HasSubstr("allow more --patience")));
}

/// "The only one that came to the end" beside others that had come to it, and "allow more --patience" where
/// all had.
TEST(Advice, SaysWhyOnlyOneOrNoneIsAdvised) {
  CellResult cell;
  cell.rows = {row_of("floor", {1, 1}), row_of("kerf", {100, 100})};
  EXPECT_THAT(advise(cell).sentences, ElementsAre("kerf: the only one that was asked for, 0.100 ms a step."));
  cell.rows.push_back(row_of("columns", {50, 50}));
  cell.rows[2].extra = 1;
  EXPECT_THAT(advise(cell).sentences, ElementsAre("kerf: the only one with the right pairs, 0.100 ms a step.",
                                                  HasSubstr("columns: not for this scene")));
  cell.gaps = {{cell.rows[0].cell, "kerf-paper", "left out after 10 s"}};
  EXPECT_THAT(advise(cell).sentences[0],
              HasSubstr("kerf: the only one that came to the end with the right pairs, "));
  cell.rows.pop_back();
  EXPECT_THAT(advise(cell).sentences[0], HasSubstr("kerf: the only one that came to the end, "));
  cell.gaps.clear();
  cell.rows[1].missed = 7;
  EXPECT_THAT(advise(cell).sentences, ElementsAre("No broad phase reported the right pairs.",
                                                  HasSubstr("kerf: not for this scene, it misses 7 pairs")));
}

TEST(Advice, SaysWhichIsSteadierOrSmaller) {
  CellResult cell;
  cell.rows = {row_of("kerf", {100, 100}), row_of("columns", {180, 180}),
               row_of("sort-and-sweep", {190, 190}), row_of("brute-force", {900, 900})};
  cell.rows[3].rss_bytes = 1000;
  EXPECT_THAT(advise(cell).sentences, Not(Contains(HasSubstr("brute-force: takes the least"))))
      << "it is far too slow";
  EXPECT_THAT(advise(cell).sentences, Not(Contains(HasSubstr("worst step"))));
  cell.rows[0].max_ns = 900;
  cell.rows[2].rss_bytes = 20000;
  const Advice advice = advise(cell);
  EXPECT_THAT(advice.sentences,
              Contains("columns: its worst step takes 0.540 ms, that of kerf 0.900; choose it "
                       "where no step may be late."));
  EXPECT_THAT(advice.sentences,
              Contains("sort-and-sweep: takes the least memory, 20.0 bytes an object instead "
                       "of 200 bytes an object."));
  cell.rows[2].rss_bytes = 0;
  EXPECT_THAT(advise(cell).sentences,
              Contains("sort-and-sweep: takes the least memory, too little to be measured instead of 200 "
                       "bytes an object."));
}

}  // namespace
}  // namespace kerf
