#include "frames/page/plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "frames/page/axis.h"
#include "frames/page/gnuplot.h"
#include "frames/page/label_places.h"
#include "frames/page/pareto.h"

namespace kerf {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Pareto, OnlyWhatNothingBeatsIsOnTheFront) {
  EXPECT_THAT(pareto_front({{0, 10}, {1, 5}, {2, 5}, {3, 1}, {0, 12}}),
              ElementsAre(true, true, false, true, false));
}

TEST(Pareto, EqualPointsAreAllOnIt) { EXPECT_THAT(pareto_front({{1, 1}, {1, 1}}), ElementsAre(true, true)); }

TEST(Axis, ZerosStandLeftOfAllOnALogarithmicOne) {
  const Axis axis({0, 0.01, 10}, true);
  EXPECT_LT(axis.share(0), axis.share(0.01));
  EXPECT_GT(axis.share(0), 0);
  EXPECT_LT(axis.share(10), 1);
  EXPECT_THAT(axis.script("x"), HasSubstr("\"0\""));
  EXPECT_THAT(axis.script("x"), HasSubstr("set logscale x"));
}

TEST(Axis, HoldsASingleValue) {
  for (const bool log : {false, true}) {
    const Axis axis({5}, log);
    EXPECT_GT(axis.share(5), 0);
    EXPECT_LT(axis.share(5), 1);
  }
}

TEST(Axis, HoldsNothing) {
  EXPECT_THAT(Axis({}, true).script("y"), HasSubstr("set yrange"));
  EXPECT_THAT(Axis({0, 0}, true).script("y"), HasSubstr("set yrange"));
}

TEST(LabelPlaces, DoNotOverlap) {
  const std::vector<LabelWish> wishes{{100, 100, "first"}, {104, 102, "second"}, {101, 99, "third"}};
  const auto places = place_labels(wishes, {}, 0, 400);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (places[i] && places[j] && std::abs(places[i]->y - places[j]->y) < 13) {
        const bool left = places[i]->x + 6 * static_cast<double>(wishes[i].text.size()) < places[j]->x;
        const bool right = places[j]->x + 6 * static_cast<double>(wishes[j].text.size()) < places[i]->x;
        EXPECT_TRUE(left || right) << i << " and " << j;
      }
  EXPECT_TRUE(places[0]);
}

TEST(LabelPlaces, StayInThePicture) {
  const auto places = place_labels({{395, 50, "a long label"}}, {}, 0, 400);
  ASSERT_TRUE(places[0]);
  EXPECT_LT(places[0]->x, 395);
  EXPECT_FALSE(place_labels({{5, 5, "too long for this"}}, {}, 0, 20)[0]);
}

TEST(Gnuplot, QuotesWhatWouldEndAText) { EXPECT_EQ(in_quotes("a \"b\" \\"), "\"a \\\"b\\\" \\\\\""); }

TEST(Plot, IsAnElementWithIdsOfItsOwn) {
  const Plot plot{"title <&>", "x",  "y",
                  true,        true, {{"series", {{0, 1, "label", true}, {2, 3, "", false}}}}};
  const std::string svg = draw(plot, "mine");
  EXPECT_TRUE(svg.starts_with("<svg"));
  EXPECT_THAT(svg, HasSubstr("label"));
  EXPECT_THAT(svg, HasSubstr("mine-gpPt0"));
  EXPECT_THAT(svg, Not(HasSubstr("'gpPt0'")));
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  EXPECT_THAT(svg, Not(HasSubstr("<title"))) << "browsers show gnuplot's own names under the pointer";
}

TEST(Plot, PointsHaveErrorBarsAndValuesUnderThePointer) {
  Plot plot{"title", "error", "time", true, true, {{"series", {{1, 10}}}}};
  const std::string without = draw(plot, "p");
  EXPECT_THAT(without, HasSubstr("time: 10<"));
  plot.series[0].points[0].name = "a setting";
  plot.series[0].points[0].y_range = {8, 500};
  const std::string with = draw(plot, "p");
  EXPECT_THAT(with, HasSubstr("a setting"));
  EXPECT_THAT(with, HasSubstr("time: 10 (8 to 500)"));
  EXPECT_THAT(with, HasSubstr("class=\"strip\""));
  EXPECT_THAT(without, Not(HasSubstr("p-gnuplot_plot_2")));
  EXPECT_THAT(with, HasSubstr("p-gnuplot_plot_2")) << "bars are drawn apart from points";
  EXPECT_THAT(with, HasSubstr(">500<"));
}

TEST(Plot, LinesHaveBands) {
  Plot plot{"title", "x", "y", false, false, {{"series", {{1, 10}, {2, 20}}, PlotStyle::line}}};
  EXPECT_THAT(draw(plot, "p"), Not(HasSubstr("fill-opacity = '0.12'")));
  for (PlotPoint& point : plot.series[0].points) point.y_range = {point.y - 1, point.y + 1};
  EXPECT_THAT(draw(plot, "p"), HasSubstr("fill-opacity"));
}

/// What gnuplot drew as that plot, without the values under the pointer.
std::string drawn_as(const std::string& svg, const std::string& group) {
  const std::size_t begin = svg.find("\"" + group + "\"");
  if (begin == std::string::npos) return "";
  return svg.substr(begin, std::min(svg.find("<g id=", begin), svg.find("<g class=", begin)) - begin);
}

/// The axes are the same: a larger spread stands beside it.
TEST(Plot, ErrorBarsReachAsFarAsTheSpread) {
  const auto points = [](PlotRange x, PlotRange y) {
    PlotPoint spread{1, 10};
    spread.x_range = x;
    spread.y_range = y;
    PlotPoint widest{1, 10};
    widest.x_range = {0.01, 100};
    widest.y_range = {0.1, 1000};
    const Plot plot{"title", "error", "time", true, true, {{"series", {spread, widest}}}};
    return drawn_as(draw(plot, "p"), "p-gnuplot_plot_1");
  };
  const std::string narrow = points({0.5, 2}, {5, 20});
  ASSERT_NE(narrow, "");
  EXPECT_NE(points({0.2, 2}, {5, 20}), narrow);
  EXPECT_NE(points({0.5, 4}, {5, 20}), narrow);
  EXPECT_NE(points({0.5, 2}, {2, 20}), narrow);
  EXPECT_NE(points({0.5, 2}, {5, 40}), narrow);
  EXPECT_EQ(points({0.5, 2}, {5, 20}), narrow);
}

TEST(Plot, BarsHaveErrorBars) {
  const auto bars = [](double most) {
    return draw(BarPlot{"title", "ns", {{"one", 1, most}, {"two", 2, 40}}}, "bars");
  };
  EXPECT_THAT(bars(0), HasSubstr(" 40<")) << "the axis reaches the end of the error bar";
  const std::string none = drawn_as(bars(0), "bars-gnuplot_plot_2");
  ASSERT_NE(none, "");
  EXPECT_NE(drawn_as(bars(20), "bars-gnuplot_plot_2"), none);
  EXPECT_EQ(drawn_as(bars(1), "bars-gnuplot_plot_2"), none);
}

TEST(Plot, OfBarsAndOfCells) {
  const std::string bars = draw(BarPlot{"title", "ns", {{"one", 1}, {"two", 2.5}}}, "bars");
  EXPECT_THAT(bars, HasSubstr("2.5"));
  const std::string map = draw(HeatMap{{"column"}, {"row"}, {{0}}, {"exact"}}, "map");
  EXPECT_THAT(map, HasSubstr("column"));
  EXPECT_THAT(map, HasSubstr("exact"));
}

TEST(Plot, SaysWhenGnuplotWouldNot) {
  EXPECT_THROW(run_gnuplot("plot nothing here", 100, 100, "x"), std::runtime_error);
}

}  // namespace
}  // namespace kerf
