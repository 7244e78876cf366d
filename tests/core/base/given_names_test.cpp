#include "core/base/given_names.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace kerf {
namespace {

TEST(GivenId, ReadsEveryWholeNumberOf64BitsAndNothingElse) {
  for (const char* const text : {"0", "17", "-12034", "18446744073709551615", "-9223372036854775808"})
    EXPECT_EQ(to_string(parse_given_id(text).value()), text);
  EXPECT_EQ(to_string(parse_given_id("+17").value()), "17");
  EXPECT_EQ(to_string(parse_given_id("-0").value()), "0");
  EXPECT_EQ(to_string(parse_given_id("007").value()), "7");
  EXPECT_EQ(to_string(parse_given_id("17.00").value()), "17");
  for (const char* const text : {"", "-", "+-1", "--1", "1.5", "1.", "1e3", "0x1", " 1", "1 ", "a",
                                 "18446744073709551616", "-9223372036854775809"})
    EXPECT_FALSE(parse_given_id(text)) << text;
}

TEST(GivenId, IsOrderedAsNumbersAre) {
  const char* const rising[] = {"-9223372036854775808", "-2", "-1", "0", "1", "9223372036854775808"};
  for (std::size_t k = 1; k < std::size(rising); ++k)
    EXPECT_LT(parse_given_id(rising[k - 1]).value(), parse_given_id(rising[k]).value());
}

TEST(StepTime, IsANumberOrADate) {
  EXPECT_EQ(parse_step_time("5000"), 5000.0L);
  EXPECT_EQ(parse_step_time("+0.5"), 0.5L);
  EXPECT_EQ(parse_step_time("-3"), -3.0L);
  EXPECT_LT(parse_step_time("1700000000016667000"), parse_step_time("1700000000016667001"));
  EXPECT_EQ(parse_step_time("1970-01-02T00:00:01.5"), 86401.5L);
  EXPECT_EQ(parse_step_time("1970-01-01 00:01:00Z"), 60.0L);
  for (const char* const text : {"", "nan", "inf", "step", "1,5", "2024-02-30T00:00:00", "2024-01-01",
                                 "2024-01-01T24:00:00", "2024-01-01T00:00:00+02:00", "2024/01/01T00:00:00"})
    EXPECT_FALSE(parse_step_time(text)) << text;
}

TEST(GivenNames, OwnNumbersAreTheNamesWhereThereAreNone) {
  const GivenNames none;
  EXPECT_EQ(none.object({7}), "7");
  EXPECT_EQ(none.pair({{2}, {3}}), "2,3");
  EXPECT_EQ(none.step(0), "0");
  EXPECT_EQ(none.step(17), "17");
  EXPECT_EQ(none.find_object({false, 7}), ObjectId{7});
  EXPECT_FALSE(none.find_object({true, 7}));
  EXPECT_FALSE(none.find_object({false, UINT32_MAX}));
  EXPECT_EQ(none.find_step("17"), 17U);
  EXPECT_FALSE(none.find_step("1.5"));
}

TEST(GivenNames, AreFoundBothWays) {
  const GivenNames names({{true, 5}, {false, 3}, {false, UINT64_MAX}}, {"5000", "5001.5", "6000"});
  EXPECT_EQ(names.object({0}), "-5");
  EXPECT_EQ(names.object({2}), "18446744073709551615");
  EXPECT_EQ(names.pair({{0}, {1}}), "-5,3");
  EXPECT_EQ(names.find_object({true, 5}), ObjectId{0});
  EXPECT_FALSE(names.find_object({false, 5}));
  EXPECT_EQ(names.step(2), "5001.5");
  EXPECT_EQ(names.step_number(2), 5001.5);
  EXPECT_EQ(names.find_step("5001.50"), 2U);
  EXPECT_FALSE(names.find_step("1"));
  EXPECT_EQ(names.step(0), "(none yet)");
  EXPECT_EQ(names.step(4), "(after the last)");
}

TEST(GivenNames, RangesAndComingStepsAreNamed) {
  const GivenNames names({}, {"5000", "5001.5", "6000"});
  EXPECT_EQ(names.steps(1, 3), "steps 5000 to 6000");
  EXPECT_EQ(names.coming_step(2), "step 5001.5");
  EXPECT_EQ(names.coming_step(4), "a step after the last");
  EXPECT_EQ(GivenNames().steps(1, 3), "steps 1 to 3");
  EXPECT_EQ(GivenNames().coming_step(4), "step 4");
}

TEST(GivenNames, MustRise) {
  EXPECT_THROW(GivenNames({{false, 3}, {false, 3}}, {}), std::invalid_argument);
  EXPECT_THROW(GivenNames({{false, 3}, {true, 3}}, {}), std::invalid_argument);
  EXPECT_THROW(GivenNames({}, {"2", "1"}), std::invalid_argument);
  EXPECT_THROW(GivenNames({}, {"2", "2.0"}), std::invalid_argument);
  EXPECT_THROW(GivenNames({}, {"two"}), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
