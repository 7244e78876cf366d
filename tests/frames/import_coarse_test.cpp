// `kerf import --structure`: by how much the digits that were not written may put an object outside of its
// cell.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "frames/import/written_digits.h"
#include "tests/frames/import_program.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string written_as(const char* format, double number) {
  std::array<char, 64> text{};
  (void)std::snprintf(text.data(), text.size(), format, number);
  return text.data();
}

/// Eight objects in a row, each in a leaf of its own below one root; object 5 is longer by `by`.
class ImportCoarse : public test::ImportProgram {
 protected:
  std::string said(const char* of_boxes, const char* of_nodes, double by = 0, double margin = 0,
                   double scale = 1) const {
    std::ostringstream boxes("step,object,min_x,max_x,min_y,max_y\n", std::ios::ate);
    std::ostringstream nodes("step,node,parent,min_x,max_x,min_y,max_y,object\n", std::ios::ate);
    const auto line = [](const char* format, std::initializer_list<double> bounds) {
      std::string text;
      for (const double bound : bounds) text += "," + written_as(format, bound);
      return text;
    };
    nodes << "1,100," << line(of_nodes, {-50, 300, -50, 300}) << ",\n";
    for (int k = 0; k < 8; ++k) {
      const double x = std::floor(37 * k * scale) / scale;
      const double y = std::floor((0.6 + 41.37 * k) * scale) / scale;
      const double beyond = k == 5 ? by : 0;
      boxes << "1," << k << line(of_boxes, {x, x + 1 + beyond, y, y + 2}) << "\n";
      nodes << "1," << k << ",100" << line(of_nodes, {x - margin, x + 1 + margin, y - margin, y + 2 + margin})
            << ',' << k << "\n";
    }
    return imported("a", write("boxes.csv", boxes.str()), {"--structure", write("nodes.csv", nodes.str())});
  }
};

/// Each object was outside of its cell.
TEST_F(ImportCoarse, AnObjectIsOutsideByMoreThanWasRoundedAway) {
  constexpr double kFine = 1e4;
  for (const auto& [boxes, nodes] :
       {std::pair{"%.0f", "%.3f"}, std::pair{"%.0f", "%.17g"}, std::pair{"%.3g", "%.17g"},
        std::pair{"%.17g", "%.3g"}, std::pair{"%.3f", "%.0f"}, std::pair{"%.2g", "%.9g"},
        std::pair{"%.4g", "%.17g"}, std::pair{"%.3g", "%.3f"}}) {
    const std::string text = said(boxes, nodes, 0, 0, kFine);
    EXPECT_THAT(text, HasSubstr(": 0 faults")) << boxes << " and " << nodes;
    EXPECT_THAT(text, HasSubstr("odd: 1 table is so coarse that")) << boxes << " and " << nodes;
  }
  EXPECT_THAT(said("%.0f", "%.3f", 3, 0, kFine), HasSubstr("1 fault in 1 step"));
  EXPECT_THAT(said("%.0f", "%.3f", 0, 0, kFine), HasSubstr("boxes.csv: no decimals"));
  EXPECT_THAT(said("%.17g", "%.3g", 0, 0, kFine), HasSubstr("nodes.csv: 3 digits"));
}

/// Whole numbers with a margin around them are no rounded ones.
TEST_F(ImportCoarse, WholeNumbersAreExactWhereAMarginIsAllThatTheNodesHaveMore) {
  for (const char* const format : {"%.1f", "%g", "%.9g", "%.17g"}) {
    const std::string text = said("%.0f", format, 1, 0.1);
    EXPECT_THAT(text, HasSubstr("1 fault in 1 step")) << format;
    EXPECT_THAT(text, Not(HasSubstr("odd:"))) << format;
  }
  EXPECT_THAT(said("%.0f", "%.0f", 1), HasSubstr("1 fault in 1 step")) << "both are as coarse";
  EXPECT_THAT(said("%.1f", "%.3f", 0.5, 0.1), HasSubstr("1 fault in 1 step")) << "halves are exact";
}

/// Half of their last decimal covers what they lack, and nothing about them is odd.
TEST_F(ImportCoarse, TablesOfDecimalsAreNotCoarse) {
  for (const auto& [boxes, nodes] : {std::pair{"%.3f", "%.17g"}, std::pair{"%.1f", "%.3f"},
                                     std::pair{"%.17g", "%.2f"}, std::pair{"%g", "%.17g"}}) {
    const std::string text = said(boxes, nodes, 0, 0, 1e4);
    EXPECT_THAT(text, HasSubstr(": 0 faults")) << boxes << " and " << nodes;
    EXPECT_THAT(text, Not(HasSubstr("odd:"))) << boxes << " and " << nodes;
  }
}

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
  EXPECT_EQ(digits_of({"100", "0.4", "7"}), (WrittenDigits{3, 1}));
  EXPECT_EQ(digits_of({"100.5", "2.0"}), (WrittenDigits{4, 0})) << "halves are exact";
  EXPECT_EQ(digits_of({"0.000000"}), (WrittenDigits{1, 6}));
  EXPECT_EQ(digits_of({"nan", "-inf", ""}), WrittenDigits()) << "no number has any";
}

TEST(WrittenDigits, SayWhatWasRoundedAway) {
  EXPECT_DOUBLE_EQ(rounded_away({6, 0}, 100'000), 0.5);
  EXPECT_DOUBLE_EQ(rounded_away({9, 0}, -100'000), 0.0005);
  EXPECT_DOUBLE_EQ(rounded_away({2, 0}, 1.5), 0.000005) << "no program writes fewer than six";
  EXPECT_DOUBLE_EQ(rounded_away({9, 6}, 1e-5), 5e-7);
  EXPECT_DOUBLE_EQ(rounded_away({9, 6}, 0), 5e-7);
  EXPECT_DOUBLE_EQ(rounded_away({3, 1}, 12.3), 0.05);
  EXPECT_EQ(rounded_away({}, 3), 0) << "it is not known how it was written";
  EXPECT_DOUBLE_EQ(rounded_away({2, 0, true}, 26.7), 1);
  EXPECT_DOUBLE_EQ(rounded_away({3, 3, true}, 26.7), 0.1);
  EXPECT_DOUBLE_EQ(rounded_away({3, 3, true}, -0.527), 0.001);
  EXPECT_DOUBLE_EQ(rounded_away({3, 0, true}, 1.23e6), 1e4);
  EXPECT_DOUBLE_EQ(rounded_away({2, 0, true}, 0), 1);
}

}  // namespace
}  // namespace kerf
