#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/random.h"
#include "frames/import/written_digits.h"
#include "tests/frames/import_program.h"

namespace kerf::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string printed(const char* format, double number) {
  std::array<char, 400> text{};
  (void)std::snprintf(text.data(), text.size(), format, number);
  return text.data();
}

/// Two intervals of an engine.
template <class Number>
struct Two {
  std::array<Number, 2> a;
  std::array<Number, 2> b;
  [[nodiscard]] bool overlap() const { return b[0] <= a[1]; }
  [[nodiscard]] bool same_text(const char* format) const {
    return printed(format, static_cast<double>(b[0])) == printed(format, static_cast<double>(a[1]));
  }
};

/// In each place two boxes, of which the second one begins where the first one ends: an ulp or a few before
/// or behind, or up to two units of the sixth digit.
template <class Number>
std::vector<Two<Number>> touching(std::uint64_t seed) {
  Random random(seed);
  std::vector<Two<Number>> all;
  for (int k = 0; k < 60; ++k) {
    const auto from = static_cast<Number>(10 * k + random.unit());
    const auto to = static_cast<Number>(10 * k + 2 + random.unit());
    Number next = to;
    for (std::uint64_t ulps = random.below(4); ulps > 0; --ulps)
      next = std::nextafter(next, static_cast<Number>(k % 2 == 0 ? -1e9 : 1e9));
    if (k % 3 == 0) next += static_cast<Number>(4e-3 * (random.unit() - 0.5));
    all.push_back({{from, to}, {next, static_cast<Number>(10 * k + 6)}});
  }
  return all;
}

class ImportDigits : public test::ImportProgram {
 protected:
  /// The verdict on an engine that has the boxes of `all`, and reports those that overlap, or, if it is
  /// `wrong`, all others.
  template <class Number>
  [[nodiscard]] std::string verdict(const std::vector<Two<Number>>& all, const char* format,
                                    bool wrong = false) const {
    std::string boxes = "step,object,min_x,max_x,min_y,max_y\n";
    std::string pairs = "step,a,b\n";
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::string a = std::to_string(2 * k);
      const std::string b = std::to_string(2 * k + 1);
      for (const auto& [name, bounds] : {std::pair(a, all[k].a), std::pair(b, all[k].b)})
        boxes += "1," + name + "," + printed(format, static_cast<double>(bounds[0])) + "," +
                 printed(format, static_cast<double>(bounds[1])) + ",0,1\n";
      if (all[k].overlap() != wrong) pairs += "1," + a + "," + b + "\n";
    }
    return imported("a", write("boxes.csv", boxes), {"--pairs", write("pairs.csv", pairs)});
  }
  /// Of two boxes along x, and whether their pair is reported.
  [[nodiscard]] std::string verdict(const std::string& a, const std::string& b, bool reported,
                                    const std::vector<std::string>& more = {}) const {
    const std::string text = "step,object,min_x,max_x,min_y,max_y\n1,0," + a + ",0,1\n1,1," + b + ",0,1\n";
    std::vector<std::string> options{
        "--pairs", write("pairs.csv", "step,a,b\n" + std::string(reported ? "1,0,1\n" : ""))};
    options.insert(options.end(), more.begin(), more.end());
    return imported("a", write("boxes.csv", text), options);
  }

  /// A right engine is accused of nothing; one that is wrong about every pair of all those of which the texts
  /// of the two bounds differ.
  template <class Number>
  void expect_fair(const char* format, std::uint64_t seed) const {
    const std::vector<Two<Number>> all = touching<Number>(seed);
    EXPECT_THAT(verdict(all, format), HasSubstr(": 0 missed, 0 extra, 0 twice, 0 ignored")) << format;
    std::array<std::uint64_t, 2> wrong{};
    for (const Two<Number>& two : all)
      if (!two.same_text(format)) ++wrong[two.overlap() ? 0 : 1];
    const std::string said = verdict(all, format, true);
    EXPECT_THAT(said, HasSubstr(": " + std::to_string(wrong[0]) + " missed, " + std::to_string(wrong[1]) +
                                " extra, 0 twice, 0 ignored"))
        << format;
    const std::uint64_t open = all.size() - wrong[0] - wrong[1];
    EXPECT_THAT(said, HasSubstr(", " + std::to_string(open) + " undecided in the ")) << format;
    EXPECT_GT(wrong[0], 1U) << format;
    EXPECT_GT(wrong[1], 1U) << format;
    EXPECT_GT(open, 9U) << format;
  }
};

/// An engine was said to have missed pairs whose boxes were the same only as written. Rounding keeps the
/// order of numbers, so that nothing but the same text is open: boxes that are apart, or overlap, by less
/// than a unit of the last digit are judged.
TEST_F(ImportDigits, OnlyBoundsWithTheSameTextAreOpen) {
  for (const char* const format : {"%g", "%.7g", "%.5e", "%.3f"}) expect_fair<float>(format, 1);
  for (const char* const format : {"%g", "%.7g", "%.8g", "%.9g", "%.12g", "%.15g", "%.3f", "%.6f", "%.9f"})
    expect_fair<double>(format, 2);
}

/// Some formats have most numbers whole, but not all.
TEST_F(ImportDigits, ARightEngineIsAccusedInNoFormat) {
  for (const char* const format : {"%.5f", "%.6f", "%.8g", "%.7f", "%.8f", "%.9g", "%.12g", "%.17g"})
    EXPECT_THAT(verdict(touching<float>(3), format), HasSubstr(": 0 missed, 0 extra")) << format;
  for (const char* const format : {"%.16g", "%.15f", "%.17g"})
    EXPECT_THAT(verdict(touching<double>(4), format), HasSubstr(": 0 missed, 0 extra")) << format;
}

TEST_F(ImportDigits, WholeNumbersAreJudged) {
  for (const char* const format : {"%.9g", "%.8e", "%.12g", "%.17g"}) {
    const std::vector<Two<float>> all = touching<float>(5);
    const auto overlaps = std::ranges::count_if(all, &Two<float>::overlap);
    EXPECT_THAT(verdict(all, format), AllOf(HasSubstr(": 0 missed, 0 extra"), Not(HasSubstr("undecided"))));
    EXPECT_THAT(verdict(all, format, true),
                HasSubstr(": " + std::to_string(overlaps) + " missed, " +
                          std::to_string(static_cast<std::ptrdiff_t>(all.size()) - overlaps) +
                          " extra, 0 twice, 0 ignored\n"))
        << format;
  }
}

/// As Python and JavaScript write what they rounded: without zeros at the end.
TEST_F(ImportDigits, RoundedNumbersWithoutZerosAtTheEndAreOpen) {
  std::string boxes = "step,object,min_x,max_x,min_y,max_y\n";
  int object = 0;
  for (const Two<double>& two : touching<double>(6))
    for (const auto& [from, to] : {two.a, two.b})
      boxes += "1," + std::to_string(object++) + "," + printed("%.10g", std::stod(printed("%.2f", from))) +
               "," + printed("%.10g", std::stod(printed("%.2f", to))) + ",0,1\n";
  EXPECT_THAT(imported("a", write("boxes.csv", boxes), {"--pairs", write("none.csv", "step,a,b\n")}),
              HasSubstr("0 ignored, 58 undecided in the 2 decimals that were written"))
      << "one of the other two overlaps by more";
}

/// Points and walls have no extent: two that are apart may have the same text.
TEST_F(ImportDigits, FlatBoxesWithTheSameTextAreOpen) {
  std::string walls = "step,object,min_x,max_x,min_y,max_y,min_z,max_z\n";
  for (int k = 0; k < 20; ++k) {
    const std::string x = printed("%.3f", std::sqrt(k));
    for (const int object : {2 * k, 2 * k + 1})
      walls += "1," + std::to_string(object) + "," + x + "," + x + ",0.000,1.000,0.125,0.125\n";
  }
  EXPECT_THAT(imported("a", write("walls.csv", walls), {"--pairs", write("none.csv", "step,a,b\n")}),
              HasSubstr(": 0 missed, 0 extra, 0 twice, 0 ignored, 20 undecided in the 3 decimals"));
  EXPECT_THAT(explained("a", "1", "2,3"), HasSubstr("that were written they touch along x"));
  EXPECT_EQ(run_kerf({"verify", path("a.kerf")}).exit, 0);
}

/// A right engine was accused of missing nearly all pairs, and nothing was said to be odd.
TEST_F(ImportDigits, BoxesOfOneTextFarOutAreOpen) {
  for (const char* const high : {"1", "2000"}) {
    std::string boxes = "step,object,min_x,max_x,min_y,max_y\n";
    int object = 0;
    for (const Two<double>& two : touching<double>(7))
      for (const auto& [from, to] : {two.a, two.b})
        boxes += "1," + std::to_string(object++) + "," + printed("%g", 1e6 + from / 1e4) + "," +
                 printed("%g", 1e6 + to / 1e4) + ",0," + high + "\n";
    EXPECT_THAT(imported("a", write("boxes.csv", boxes), {"--pairs", write("none.csv", "step,a,b\n")}),
                HasSubstr(": 0 missed, 0 extra, 0 twice, 0 ignored, 7140 undecided in the 6 digits"));
    EXPECT_THAT(explained("a", "1", "2,3"), HasSubstr("that were written they touch along x"));
  }
}

/// They may be what %g left, or meant: the pair is missed, and it is said what that hangs on.
TEST_F(ImportDigits, WholeNumbersOfSixDigitsThatTouchAreOdd) {
  const auto odd = HasSubstr("odd: 1 pair that may touch only in the digits that were written");
  EXPECT_THAT(verdict("123400,123456", "123456,123500", false), AllOf(HasSubstr(" 1 missed, 0 extra"), odd));
  EXPECT_THAT(explained("a", "1", "0,1"),
              HasSubstr("the other engine missed it\nthey only touch: if what touches was rounded as it was "
                        "written, they may have been apart\n"));
  EXPECT_THAT(verdict("123400,123457", "123456,123500", false), Not(odd)) << "they overlap";
  EXPECT_THAT(explained("a", "1", "0,1"), Not(HasSubstr("they only touch")));
  EXPECT_THAT(verdict("12340,12345", "12345,12350", false), Not(odd)) << "there %g has decimals";
}

/// What people write by hand is what they mean.
TEST_F(ImportDigits, ShortNumbersAreJudged) {
  for (const std::string at : {"1", "1.0", "0.5", "0.1", "2.25", "1.0078125", "0.30000000000000004"})
    EXPECT_THAT(verdict("0," + at, at + ",3.5", false), HasSubstr(" 1 missed, 0 extra, 0 twice, 0 ignored\n"))
        << at;
  EXPECT_THAT(verdict("0,1.1", "1.1000000001,2", false), HasSubstr(" 0 missed, 0 extra"));
}

/// Two numbers between doubles are read as one, so that boxes that are apart seemed to touch.
TEST_F(ImportDigits, NumbersThatAreNoDoublesAreRefused) {
  const auto refusal = [&](const std::string& a, const std::string& b) {
    const std::string boxes =
        "step,object,min_x,max_x,min_y,max_y\n1,0,0," + a + ",0,1\n1,1," + b + ",1e30,0,1\n";
    return refused(write("boxes.csv", boxes), {"--pairs", write("none.csv", "step,a,b\n")});
  };
  EXPECT_THAT(refusal("9007199254740992", "9007199254740993"),
              HasSubstr("line 3: '9007199254740993' in column 3, min_x, is no double"));
  EXPECT_THAT(refusal("1.000000000000000001", "1.000000000000000002"), HasSubstr("line 2: '1.00000"));
  EXPECT_THAT(verdict("0,9223372036854775807", "9007199254740992,1e30", true),
              HasSubstr(" 0 missed, 0 extra"));
  (void)imported("a", path("boxes.csv"));
}

/// Whatever writes a double: with more digits than it needs, rounded half up, cut off, or with zeros behind.
TEST(WrittenDigits, AllTextsOfADoubleAreTakenForIt) {
  Random random(12);
  for (const char* const format : {"%.16g", "%.17g", "%.20f", "%.25e", "%.60g", "%.15f", "%.18f"})
    for (int k = 0; k < 300; ++k) {
      const double x = std::ldexp(random.unit() - 0.5, k % 60);
      for (const double number : {x, static_cast<double>(static_cast<float>(x)), std::round(x)}) {
        const std::string text = printed(format, number);
        EXPECT_TRUE(may_be_of_double(text, std::stod(text))) << text;
      }
    }
  EXPECT_TRUE(may_be_of_double("1234.000015258789062", 1234.0000152587890625));
  EXPECT_TRUE(may_be_of_double("1234.000015258789063", 1234.0000152587890625)) << "half up";
  EXPECT_TRUE(may_be_of_double("0.10000000000000000000", 0.1)) << "zeros behind the shortest text";
  EXPECT_TRUE(may_be_of_double("0.299999999999999988", 0.3)) << "cut off";
  EXPECT_TRUE(may_be_of_double("1.79769313486231570815e+308", std::numeric_limits<double>::max()));
  EXPECT_FALSE(may_be_of_double("9007199254740993", 9007199254740992));
  EXPECT_FALSE(may_be_of_double("0.123456789012345678", 0.123456789012345678));
}

TEST_F(ImportDigits, AMarginAndTheRoundingHoldTogether) {
  const std::string a = "0.123457,1.23457";
  EXPECT_THAT(verdict(a, "1.23558,2.34568", true, {"--margin", "0.000499"}),
              HasSubstr(" 1 extra, 0 twice, 0 ignored"));
  EXPECT_THAT(verdict(a, "1.23558,2.34568", true, {"--margin", "0.0005"}),
              HasSubstr(" 0 extra, 0 twice, 1 ignored"))
      << "0.00101 apart, but for 0.00001";
  EXPECT_THAT(explained("a", "1", "0,1"), HasSubstr("the boxes overlap, as its text may be rounded"));
  EXPECT_THAT(verdict(a, "1.23457,2.34568", false, {"--margin", "0.1"}),
              HasSubstr(" 0 missed, 0 extra, 0 twice, 0 ignored, 1 undecided in the 6 digits"));
  EXPECT_THAT(verdict(a, "1.23456,2.34568", false, {"--margin", "0.1"}), HasSubstr(" 1 missed, 0 extra"));
}

/// All that reads the verdicts says the same.
TEST_F(ImportDigits, AnUndecidedPairIsOddExplainedVerifiedAndMinimized) {
  for (const bool reported : {false, true}) {
    const std::string said = verdict("0.123457,1.23457", "1.23457,2.34568", reported);
    EXPECT_THAT(said,
                HasSubstr(" 0 missed, 0 extra, 0 twice, 0 ignored, 1 undecided in the 6 digits that were "
                          "written\n"));
    const auto odd = HasSubstr("odd: 1 pair that may touch only in the digits that were written");
    if (reported) {
      EXPECT_THAT(said, Not(odd)) << "an engine that reports what touches is right";
    } else {
      EXPECT_THAT(said, odd);
      EXPECT_THAT(refused(path("boxes.csv"), {"--pairs", path("pairs.csv"), "--strict"}),
                  HasSubstr("pair 0,1 in step 1"));
    }
    const std::string why = explained("a", "1", "0,1");
    EXPECT_THAT(why,
                HasSubstr("0 and 1 may be a pair: in the 6 digits that were written they touch along x"));
    EXPECT_THAT(why, AllOf(HasSubstr("it is not judged"), Not(HasSubstr("missed it"))));
    EXPECT_THAT(stepped("a", "undecided>0"), HasSubstr("theirs, undecided: (0,1)"));
    EXPECT_EQ(run_kerf({"step", path("a.kerf"), "--to", "ignored+missed+extra>0"}).exit, 1);
    const auto verified = run_kerf({"verify", path("a.kerf")});
    EXPECT_EQ(verified.exit, 0) << verified.out;
    EXPECT_THAT(verified.out, HasSubstr("0 twice, 0 ignored, 1 undecided\n"));
    EXPECT_EQ(
        run_kerf({"minimize", path("a.kerf"), "--when", "undecided>0", "-o", path("s.kerf"), "--overwrite"})
            .exit,
        0);
    EXPECT_EQ(run_kerf({"step", path("s.kerf"), "--to", "missed+extra>0"}).exit, 1);
  }
}

TEST_F(ImportDigits, SurviveARoundTrip) {
  for (const char* const format : {"%g", "%.3f"}) {
    const std::string said = verdict(touching<float>(6), format, true);
    write("again.csv", exported("a", "--boxes"));
    write("again_pairs.csv", exported("a", "--pairs"));
    const std::string again = imported("b", path("again.csv"), {"--pairs", path("again_pairs.csv")});
    EXPECT_THAT(again, HasSubstr(said.substr(said.find("the other engine reported")))) << format;
    EXPECT_EQ(run_kerf({"compare", path("a.kerf"), path("b.kerf")}).exit, 0) << format;
  }
}

/// 2e+06 became 2000000, which no rounding to six digits writes, and what was undecided was missed.
TEST_F(ImportDigits, SurviveARoundTripWithExponents) {
  const std::string boxes =
      "step,object,min_x,max_x,min_y,max_y,fixed\n1,0,0,2e+06,0,1,0\n1,1,2e+06,3.12346e+06,0,1,0\n"
      "1,2,7.12345e+06,8.12345e+06,1.5e-05,1,0\n1,3,9.12345e+06,9.52345e+06,0,1,0\n";
  const std::string pairs = write("pairs.csv", "step,a,b\n");
  EXPECT_THAT(imported("a", write("boxes.csv", boxes), {"--pairs", pairs}),
              HasSubstr(" 0 missed, 0 extra, 0 twice, 0 ignored, 1 undecided in the 6 digits"));
  EXPECT_EQ(exported("a", "--boxes"), boxes);
}

TEST_F(ImportDigits, AreComparedAsTheyWereWritten) {
  (void)verdict("0.123457,1.23457", "1.23457,2.34568", false);
  (void)imported("b", write("few.csv", "step,object,min_x,max_x,min_y,max_y\n1,0,0,1.23457,0,1\n"),
                 {"--pairs", path("pairs.csv")});
  EXPECT_THAT(run_kerf({"compare", path("a.kerf"), path("b.kerf")}).out,
              HasSubstr("declared   rounding of boxes: to 6 digits in A, none in B\n"));
}

}  // namespace
}  // namespace kerf::test
