#include "frames/import/bound_writing.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/random.h"
#include "core/base/shortest_text.h"

namespace kerf {
namespace {

std::string formatted(const char* format, double number) {
  std::array<char, 400> text{};
  (void)std::snprintf(text.data(), text.size(), format, number);
  return text.data();
}

BoundWriting writing_of(const std::vector<std::string>& bounds) {
  BoundWriting writing;
  for (const std::string& bound : bounds) writing.note(0, bound, bound);
  return writing;
}
BoundRounding rounding_of(const std::vector<std::string>& bounds) { return writing_of(bounds).rounding(); }

TEST(BoundWriting, IsFoundOut) {
  Random random(7);
  const auto numbers = [&](auto text) {
    std::vector<std::string> all;
    for (int k = 0; k < 2000; ++k) all.push_back(text(std::ldexp(random.unit() - 0.5, k % 16)));
    return rounding_of(all);
  };
  const auto as_float = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  const auto trimmed = [](const char* format, double x) {
    return shortest_text(std::stod(formatted(format, x)));
  };
  EXPECT_EQ(numbers([](double x) { return shortest_text(x); }), BoundRounding());
  EXPECT_EQ(numbers([](double x) { return shortest_text(static_cast<float>(x)); }), BoundRounding());
  EXPECT_EQ(numbers([](double x) { return formatted("%.9g", x); }), (BoundRounding{9, 0, false}));
  EXPECT_EQ(numbers([&](double x) { return formatted("%.9g", as_float(x)); }), BoundRounding());
  EXPECT_EQ(numbers([&](double x) { return formatted("%.8g", as_float(x)); }), (BoundRounding{8, 0, true}));
  EXPECT_EQ(numbers([](double x) { return formatted("%.8g", x); }), (BoundRounding{8, 0, false}));
  for (const char* const format : {"%.12g", "%.15g", "%.16g", "%.17g", "%.10e"})
    EXPECT_EQ(numbers([&](double x) { return formatted(format, as_float(x)); }), BoundRounding()) << format;
  EXPECT_EQ(numbers([](double x) { return formatted("%.4g", x); }), (BoundRounding{4, 0, false}));
  EXPECT_EQ(numbers([](double x) { return formatted("%.5g", x); }), (BoundRounding{5, 0, false}));
  EXPECT_EQ(numbers([](double x) { return formatted("%.3g", x); }), BoundRounding());
  EXPECT_EQ(numbers([](double x) { return formatted("%.4f", x); }), (BoundRounding{0, 4, false}));
  EXPECT_EQ(numbers([](double x) { return formatted("%.1f", x / 16); }), BoundRounding());
  EXPECT_EQ(numbers([&](double x) { return trimmed("%.3f", x); }), (BoundRounding{0, 3, false}));
  EXPECT_EQ(numbers([&](double x) { return trimmed("%.2f", x / 4096); }), (BoundRounding{0, 2, false}));
  EXPECT_EQ(numbers([&](double x) { return trimmed("%g", x); }), (BoundRounding{6, 0, false}));
  EXPECT_EQ(rounding_of({"1.23457e+06", "2.34568e+06", "3e+06", "3.14159e+06"}),
            (BoundRounding{6, 0, false}));
  EXPECT_EQ(rounding_of({"nan", "-inf", "", "1,5", "0.00", "1.00", "0.50"}), BoundRounding());
}

/// Grids of decimals, and what people reckon by hand.
TEST(BoundWriting, WhatMayBeMeantIsTakenAsItIs) {
  std::vector<std::string> tenths;
  std::vector<std::string> twentieths;
  std::vector<std::string> eighths;
  for (int k = 1; k < 400; ++k) {
    tenths.push_back(shortest_text(k / 10.0));
    twentieths.push_back(shortest_text(k / 20.0));
    eighths.push_back(formatted("%.3f", k / 8.0));
  }
  for (const auto& grid : {tenths, twentieths}) EXPECT_EQ(rounding_of(grid), BoundRounding());
  EXPECT_EQ(rounding_of(eighths), (BoundRounding{0, 3, false}))
      << "zeros at the end: %.3f, whatever was meant";
  std::erase_if(eighths, [](const std::string& text) { return text.ends_with('0'); });
  EXPECT_EQ(rounding_of(eighths), BoundRounding()) << "the shortest texts";
  EXPECT_EQ(rounding_of({"0.33", "0.67", "1.41", "3.14", "2.71", "1.62", "0.1"}), BoundRounding());
  EXPECT_EQ(rounding_of({"0.123457", "1.23457", "0.5"}), BoundRounding()) << "two numbers are too few";
  EXPECT_EQ(rounding_of({"0.123457", "0.234568", "0.345679", "1.0078125"}), BoundRounding())
      << "which has 8 digits";
}

/// As Python, JavaScript and `kerf export` write them: nothing was rounded away, though few have 17 digits.
TEST(BoundWriting, ShortestTextsAreWhole) {
  EXPECT_EQ(
      rounding_of({"1.1", "2.2", "3.3", "0.6000000000000001", "0.7000000000000001", "0.8999999999999999"}),
      BoundRounding())
      << "from 0.5 to 1, 16 digits are all of each double";
  Random random(12);
  for (const double size : {0.6, 4.5, 9.0, 700.0}) {
    std::vector<std::string> doubles;
    std::vector<std::string> floats;
    for (int k = 0; k < 40; ++k) {
      const double x = size * (1 + random.unit() / 16);
      const std::string text = shortest_text(x);
      if (text.find_first_not_of("0.") + 17 >= text.size()) doubles.push_back(text);
      const std::string of_float = shortest_text(static_cast<float>(x));
      if (of_float.find_first_not_of("0.") + 9 >= of_float.size()) floats.push_back(of_float);
    }
    EXPECT_GE(std::min(doubles.size(), floats.size()), 8U) << size;
    EXPECT_EQ(rounding_of(doubles), BoundRounding()) << size;
    EXPECT_EQ(rounding_of(floats), BoundRounding()) << size;
  }
}

TEST(BoundWriting, NumbersOf16DigitsAreRoundedWhereDoublesAreCloser) {
  Random random(13);
  std::vector<std::string> all;
  for (int k = 0; k < 8; ++k)
    all.push_back(formatted("%.16g", k % 2 == 0 ? random.uniform(1, 2) : random.uniform(10, 16)));
  EXPECT_EQ(rounding_of(all), (BoundRounding{16, 0, false}));
  all.resize(3);
  EXPECT_EQ(rounding_of(all), BoundRounding());
  EXPECT_EQ(writing_of(all).suspected(), (BoundRounding{16, 0, false}));
}

TEST(BoundWriting, ZerosAtTheEndSayHowManyDecimalsThereAre) {
  std::vector<std::string> whole;
  for (int k = 0; k < 12; ++k) whole.push_back(formatted("%.6f", k));
  EXPECT_EQ(rounding_of(whole), (BoundRounding{0, 6, false}));
  whole.resize(7);
  EXPECT_EQ(rounding_of(whole), BoundRounding());
  EXPECT_EQ(writing_of(whole).suspected(), (BoundRounding{0, 6, false}));
  EXPECT_EQ(writing_of({8, "-0.00"}).suspected(), (BoundRounding{0, 2, false})) << "a scene in thousandths";
  whole.insert(whole.end(), {"7.5", "8.25", "1e30"});
  EXPECT_EQ(writing_of(whole).suspected(), BoundRounding()) << "they differ";
}

TEST(BoundWriting, NumbersWithMoreDecimalsThanAreCountedAreNotRoundedToThese) {
  std::vector<std::string> tiny;
  for (int k = 0; k < 12; ++k) tiny.push_back(std::to_string(2 * k + 1) + "e-320");
  EXPECT_EQ(rounding_of(tiny), BoundRounding());
  EXPECT_EQ(writing_of(tiny).suspected(), BoundRounding());
}

TEST(BoundWriting, TooFewNumbersAreSuspected) {
  const auto suspected = [](const std::vector<std::string>& bounds) {
    return writing_of(bounds).suspected();
  };
  EXPECT_EQ(suspected({"0", "0.5", "1.23457"}), (BoundRounding{6, 0, false}));
  EXPECT_EQ(suspected({"0.5", "12.34", "1.234"}), (BoundRounding{4, 0, false}));
  EXPECT_EQ(suspected({"0.500", "0.123", "1"}), (BoundRounding{0, 3, false}));
  EXPECT_EQ(suspected({"0.50", "0.33"}), BoundRounding());
  EXPECT_EQ(suspected({"0.125", "0.375"}), BoundRounding()) << "binary fractions";
  EXPECT_EQ(suspected({"0.1", "0.123"}), BoundRounding());
  EXPECT_EQ(suspected({"0.5", "1.23456789"}), BoundRounding());
  EXPECT_EQ(suspected({"0.123457", "0.234568", "0.345679"}), BoundRounding()) << "they are sure";
}

/// %g leaves nothing of boxes that lie far out: a right engine was accused of missing all of their pairs.
TEST(BoundWriting, NumbersWithoutRoomForTheirLastDigitsAreRounded) {
  EXPECT_EQ(rounding_of({"1e+06", "1e+06"}), (BoundRounding{6, 0, false}));
  EXPECT_EQ(rounding_of({"0.5", "1.01e+06"}), (BoundRounding{6, 0, false}));
  EXPECT_EQ(rounding_of({"12.3", "-1.2E+03"}), BoundRounding()) << "%.3g is suspected at most";
  EXPECT_EQ(rounding_of({"1e6", "1e3"}), BoundRounding()) << "written by hand";
  EXPECT_EQ(rounding_of({"1.00000000e+09"}), BoundRounding()) << "all of a float";
  EXPECT_EQ(rounding_of({"1.5e+00", "1.25e+02"}), BoundRounding()) << "no whole number";
  EXPECT_EQ(rounding_of({"1e+06", "1234567"}), BoundRounding()) << "which has 7 digits";
  EXPECT_EQ(rounding_of({"1e+06", "0.1234567"}), BoundRounding()) << "the same";
  EXPECT_EQ(rounding_of({"1e+30", "0.5"}), BoundRounding()) << "no bound";
}

/// Where six digits leave no decimals, whole numbers may be what %g left.
TEST(BoundWriting, WholeNumbersOfSixDigitsAreSuspected) {
  EXPECT_EQ(writing_of({"123456", "123457", "0.5"}).suspected(), (BoundRounding{6, 0, false}));
  EXPECT_EQ(writing_of({"123456", "123457", "0.5"}).suspected_from(), 1e5);
  EXPECT_EQ(writing_of({"0.123457"}).suspected_from(), 0);
  EXPECT_EQ(rounding_of({"123456", "123457", "0.5"}), BoundRounding());
  EXPECT_EQ(writing_of({"12345", "99999"}).suspected(), BoundRounding());
  EXPECT_EQ(writing_of({"123456", "1234567"}).suspected(), BoundRounding());
  EXPECT_EQ(writing_of({"123456", "1.00000012"}).suspected(), BoundRounding());
}

/// A grid of halves is exact; one of tenths may be one, or what rounding left.
TEST(BoundWriting, DozensOfShortNumbersAreSuspected) {
  Random random(11);
  const auto suspected = [&](const char* format, auto number) {
    std::vector<std::string> all;
    for (int k = 0; k < 100; ++k) all.push_back(formatted(format, number()));
    EXPECT_EQ(rounding_of(all), BoundRounding()) << format;
    return writing_of(all).suspected();
  };
  const auto any = [&] { return random.uniform(0, 40); };
  EXPECT_EQ(suspected("%.1f", any), (BoundRounding{0, 1, false}));
  EXPECT_EQ(suspected("%.3g", any), (BoundRounding{3, 0, false}));
  EXPECT_EQ(suspected("%.2e", any), (BoundRounding{3, 0, false}));
  EXPECT_EQ(suspected("%.2g", [&] { return random.uniform(0, 4); }), (BoundRounding{2, 0, false}));
  for (const char* const format : {"%g", "%.1f"}) {
    EXPECT_EQ(suspected(format, [&] { return std::round(any()); }), BoundRounding()) << format;
    EXPECT_EQ(suspected(format, [&] { return std::round(any()) / 2; }), BoundRounding()) << format;
  }
  std::vector<std::string> few;
  for (int k = 1; k < 25; ++k) few.push_back(formatted("%.1f", k / 10.0));
  EXPECT_EQ(writing_of(few).suspected(), BoundRounding()) << "too few may be meant";
}

TEST(BoundWriting, APlaneIsWhereAllBoxesAreFlatAtOneNumber) {
  Random random(9);
  const auto planes_of = [&](const std::vector<std::array<std::string, 2>>& along_z) {
    BoundWriting writing;
    for (const auto& [min, max] : along_z) {
      const std::string x = formatted("%.6f", random.unit());
      writing.note(0, x, x);
      writing.note(2, min, max);
    }
    for (int k = 0; k < 20; ++k) writing.note(1, formatted("%.6f", random.unit()), "2.000000");
    EXPECT_EQ(writing.rounding().decimals, 6U);
    return writing.rounding().planes;
  };
  EXPECT_EQ(planes_of({{"0.000000", "0.000000"}, {"-0.000000", "0.000000"}, {"", ""}}), 0b100U);
  EXPECT_EQ(planes_of({{"0.000000", "0.000000"}, {"0.000001", "0.000001"}}), 0U);
  EXPECT_EQ(planes_of({{"0.000000", "0.000000"}, {"0.000000", "0.000001"}}), 0U);
}

TEST(BoundWriting, AFewNumbersThatStandOutHideNothing) {
  Random random(8);
  std::vector<std::string> six{"3.14159265", "-3.14159265", "1.7976931348623157e+308"};
  std::vector<std::string> floats{"-2147483648", "2147483647", "1.7976931348623157e+308", "12345678912"};
  for (int k = 0; k < 200; ++k) {
    six.push_back(formatted("%g", random.uniform(0, 40)));
    floats.push_back(formatted("%.9g", static_cast<double>(static_cast<float>(random.uniform(0, 40)))));
  }
  EXPECT_EQ(rounding_of(six), BoundRounding()) << "not surely";
  EXPECT_EQ(writing_of(six).suspected().digits, 6U);
  EXPECT_EQ(rounding_of(floats), BoundRounding()) << "they have all of each float";
  EXPECT_EQ(writing_of(floats).suspected(), BoundRounding());
}

/// A plane that reaches far, an object far out, and a number near 0 are written at greater length.
TEST(BoundWriting, ASingleNumberHidesNoDecimals) {
  Random random(10);
  std::vector<std::string> three;
  std::vector<std::string> whole;
  for (int k = 0; k < 200; ++k) {
    const double x = static_cast<double>(static_cast<float>(random.uniform(0, 40)));
    three.push_back(shortest_text(std::stod(formatted("%.3f", x))));
    whole.push_back(shortest_text(static_cast<float>(x)));
  }
  for (const char* const text :
       {"-9.999999843067494e+17", "1.7976931348623157e+308", "123456.789", "-2.5e-2"}) {
    three.emplace_back(text);
    whole.emplace_back(text);
    EXPECT_EQ(rounding_of(three).decimals, 3U) << text;
    EXPECT_EQ(rounding_of(whole), BoundRounding()) << text;
  }
  for (const char* const far : {"234567.891", "234999.375", "-345678.91", "456789.123"})
    three.emplace_back(far);
  EXPECT_EQ(rounding_of(three).decimals, 3U);
  three.emplace_back("-9e-5");
  EXPECT_EQ(rounding_of(three).decimals, 0U) << "which has five";
  std::vector<std::string> huge;
  for (int k = 0; k < 200; ++k) huge.push_back(formatted("%g", random.uniform(1e18, 4e18)));
  EXPECT_EQ(rounding_of(huge).digits, 6U) << "all are";
}

/// Two walls or two points with the same text may be apart.
TEST(BoundRounding, OnlyAnAxisAlongWhichAllAreFlatDecidesNothing) {
  const BoundRounding rounding{0, 6, false, 0b100};
  const GivenBox<3> a{{0, 0, 0}, {1, 1, 0}};
  const GivenBox<3> b{{0.5, 0.5, 0}, {2, 2, 0}};
  EXPECT_EQ(undecided_axis(rounding, a, b), std::nullopt);
  EXPECT_EQ(undecided_axis(rounding, a, GivenBox<3>{{1, 0, 0}, {2, 1, 0}}), 0);
  EXPECT_EQ(undecided_axis(rounding, a, GivenBox<3>{{0, 0, 0}, {2, 2, 1}}), 2) << "one of them is flat";
  EXPECT_EQ(undecided_axis({0, 6, false}, a, b), 2);
}

TEST(BoundRounding, LeavesNumbersThatTheTextIdentifies) {
  EXPECT_EQ(lost_of({6, 0, true}, 0), 0);
  EXPECT_DOUBLE_EQ(lost_of({6, 0, true}, -1), 5e-6);
  EXPECT_EQ(lost_of({8, 0, true}, 0.3), 0) << "floats are 3e-8 apart there";
  EXPECT_DOUBLE_EQ(lost_of({8, 0, true}, 1000), 5e-5);
  EXPECT_DOUBLE_EQ(lost_of({8, 0, false}, 0.3), 5e-9);
  EXPECT_DOUBLE_EQ(lost_of({0, 3, false}, 0), 5e-4);
  EXPECT_EQ(lost_of({0, 3, true}, 3e7), 0);
  EXPECT_EQ(lost_of({}, 0.1), 0);
}

}  // namespace
}  // namespace kerf
