#include "frames/page/curve_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kerf {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

CurvePlot two_curves() {
  CurvePlot plot{"title <&>", "step", true, 10, " ms", "#at-", {}};
  plot.curves.push_back({"one", 0, {{1, 2, 1, 3}, {5, 4, 4, 4}, {9, 0, 0, 0}}});
  plot.curves.push_back({"two", 1, {{1, 2, 2, 2}, {5, 4, 3, 5}}});
  return plot;
}

TEST(CurvePlot, ShowsValuesWithTheirSpreadAtEachX) {
  const std::string svg = draw(two_curves(), "mine");
  EXPECT_TRUE(svg.starts_with("<svg"));
  EXPECT_THAT(svg, HasSubstr("one 2 ms (1 to 3)"));
  EXPECT_THAT(svg, HasSubstr("two 2 ms<"));
  EXPECT_THAT(svg, HasSubstr("href=\"#at-5\""));
  EXPECT_THAT(svg, HasSubstr("mine-gnuplot_canvas"));
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
}

TEST(CurvePlot, LiesWithBandsBelowLinesAndThinLinesAboveThickOnes) {
  const std::string script = curve_script(two_curves(), "c");
  EXPECT_LT(script.rfind("filledcurves"), script.find("with lines"));
  EXPECT_LT(script.find("$c0 using 1:2 with lines"), script.find("$c1 using 1:2 with lines"));
  EXPECT_THAT(script, HasSubstr("lw 4.5"));
  EXPECT_THAT(script, HasSubstr("lw 3.6"));
}

/// Points of two curves that lie on each other have markers at places of their own.
TEST(CurvePlot, MarkersOfCurvesDoNotCoverEachOther) {
  CurvePlot plot{"", "step", false, 20, "", "", {}};
  for (const std::size_t look : {0U, 1U}) {
    Curve& curve = plot.curves.emplace_back(Curve{"curve", look, {}});
    for (int k = 0; k < 16; ++k) curve.points.push_back({1.0 * k, 5, 5, 5});
  }
  const std::string script = curve_script(plot, "c");
  EXPECT_THAT(script, HasSubstr("$mc0 << EOD\n0 5 5 5\n8 5 5 5\nEOD"));
  EXPECT_THAT(script, HasSubstr("$mc1 << EOD\n1 5 5 5\n9 5 5 5\nEOD"));
}

TEST(CurvePlot, LeavesOutWhatALogarithmicAxisHasNoPlaceFor) {
  EXPECT_THAT(curve_script(two_curves(), "c"), Not(HasSubstr("9 0 0 0")));
  CurvePlot plot = two_curves();
  plot.log_y = false;
  EXPECT_THAT(curve_script(plot, "c"), HasSubstr("9 0 0 0"));
}

TEST(CurvePlot, OfNothingIsAnEmptyFrame) {
  const CurvePlot plot{"nothing", "step", true, 10, "", "", {}};
  EXPECT_THAT(draw(plot, "none"), HasSubstr("nothing"));
}

}  // namespace
}  // namespace kerf
