#include "frames/import/written_digits.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace kerf {
namespace {

WrittenDigits digits_of(const std::vector<std::string_view>& numbers) {
  WrittenDigits written;
  for (const std::string_view number : numbers) note_digits(number, written);
  return written;
}

TEST(WrittenDigits, AreTheMostThatANumberHas) {
  EXPECT_EQ(digits_of({"1.50"}), (WrittenDigits{3, 2}));
  EXPECT_EQ(digits_of({"-0.0120"}), (WrittenDigits{3, 4}));
  EXPECT_EQ(digits_of({"+1.50e-3"}), (WrittenDigits{3, 5}));
  EXPECT_EQ(digits_of({"1.25E+2"}), (WrittenDigits{3, 0}));
  EXPECT_EQ(digits_of({"100", "0.5", "7"}), (WrittenDigits{3, 1}));
  EXPECT_EQ(digits_of({"0.000000"}), (WrittenDigits{1, 6}));
  EXPECT_EQ(digits_of({"nan", "-inf", ""}), WrittenDigits()) << "no number has any";
}

TEST(WrittenDigits, SayWhatWasRoundedAway) {
  EXPECT_DOUBLE_EQ(rounded_away({6, 0}, 100'000), 0.5);
  EXPECT_DOUBLE_EQ(rounded_away({9, 0}, -100'000), 0.0005);
  EXPECT_DOUBLE_EQ(rounded_away({2, 0}, 1.5), 0.000005) << "no program writes fewer than six";
  EXPECT_DOUBLE_EQ(rounded_away({9, 6}, 1e-5), 5e-7);
  EXPECT_DOUBLE_EQ(rounded_away({9, 6}, 0), 5e-7);
  EXPECT_EQ(rounded_away({}, 3), 0) << "it is not known how it was written";
}

}  // namespace
}  // namespace kerf
