#include "frames/study/study_plot.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "frames/page/axis.h"
#include "frames/page/gnuplot.h"
#include "frames/page/plot_parts.h"

namespace kerf {
namespace {

constexpr int kPlotWidth = 940;
constexpr int kPlotHeight = 400;

struct Reading {
  double objects = 0;
  Estimate estimate;
};

struct Curve {
  std::string name;
  std::string color;
  std::vector<Reading> readings;
};

/// A curve for each broad phase that has the figure; the machine is named if there are several. Each has a
/// colour by its place among all, so that it has the same one in all figures.
std::vector<Curve> curves_of(const StudyComparison& comparison, const std::string& figure) {
  std::set<std::string> machines;
  for (const Group& group : comparison.groups) machines.insert(group.machine);
  std::vector<Curve> curves;
  for (const Group& group : comparison.groups) {
    const std::string name = group.broad_phase + (machines.size() > 1 ? ", " + group.machine : "");
    auto curve = std::ranges::find(curves, name, &Curve::name);
    if (curve == curves.end())
      curve = curves.insert(curves.end(), Curve{name, series_color(curves.size()), {}});
    const auto estimate = group.estimate(figure);
    if (estimate) curve->readings.push_back({static_cast<double>(group.objects), *estimate});
  }
  std::erase_if(curves, [](const Curve& curve) { return curve.readings.empty(); });
  for (Curve& curve : curves) std::ranges::sort(curve.readings, {}, &Reading::objects);
  return curves;
}

/// Neither times nor counts are negative.
double low_end(const Estimate& estimate) { return std::max(0.0, estimate.mean - estimate.half); }
double high_end(const Estimate& estimate) { return estimate.mean + estimate.half; }

std::vector<double> ends_of(const std::vector<Curve>& curves, bool log) {
  std::vector<double> ends;
  for (const Curve& curve : curves)
    for (const Reading& reading : curve.readings)
      for (const double end : {low_end(reading.estimate), reading.estimate.mean, high_end(reading.estimate)})
        if (!log || end > 0) ends.push_back(end);
  return ends;
}

bool spans_decades(const std::vector<Curve>& curves) {
  constexpr double kMany = 12;
  double least = INFINITY;
  double most = 0;
  for (const Curve& curve : curves)
    for (const Reading& reading : curve.readings) {
      least = std::min(least, reading.estimate.mean);
      most = std::max(most, reading.estimate.mean);
    }
  return least > 0 && most > kMany * least;
}

std::string line_of(double place, const Estimate& estimate, const Axis& axis) {
  return plot_number(place) + " " + plot_number(axis.place(estimate.mean)) + " " +
         plot_number(axis.place(low_end(estimate))) + " " + plot_number(axis.place(high_end(estimate))) +
         "\n";
}

/// Curves stand a little aside of each other, so that their bars are seen.
std::string curves_script(const std::vector<Curve>& curves, const Axis& y) {
  constexpr double kAside = 1.025;
  std::string blocks;
  std::string plots;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const std::string name = "$c" + std::to_string(k);
    const double aside = std::pow(kAside, static_cast<double>(k) - 0.5 * static_cast<double>(curves.size()));
    blocks += name + " << EOD\n";
    for (const Reading& reading : curves[k].readings)
      blocks += line_of(reading.objects * aside, reading.estimate, y);
    blocks += "EOD\n";
    plots += (k == 0 ? "plot " : ", ") + name + " with yerrorlines lw 1.5 pt 7 ps 0.6 lc rgb " +
             curves[k].color + " title " + in_quotes(curves[k].name);
  }
  return blocks + plots;
}

std::string plot_curves(const std::vector<Curve>& curves, const PlottedFigure& figure, std::string_view id) {
  const bool log = spans_decades(curves);
  const Axis y(ends_of(curves, log), log);
  std::vector<double> objects;
  for (const Curve& curve : curves)
    for (const Reading& reading : curve.readings) objects.push_back(reading.objects);
  const Axis x(objects, true);
  const std::string script = frame_script(figure.title, "objects") + "set ylabel " + in_quotes(figure.unit) +
                             "\nset key outside right top Left reverse\n" + x.script("x") + y.script("y") +
                             curves_script(curves, y);
  return run_gnuplot(script, kPlotWidth, kPlotHeight, id);
}

/// A row for each broad phase, the first on top.
std::string plot_rows(const std::vector<Curve>& curves, const PlottedFigure& figure, std::string_view id) {
  constexpr int kRow = 26;
  constexpr int kRest = 110;
  const bool log = spans_decades(curves);
  const Axis x(ends_of(curves, log), log);
  std::vector<std::string> names;
  std::string block;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    names.push_back(curves[k].name);
    block += line_of(static_cast<double>(k), curves[k].readings.front().estimate, x);
  }
  const std::string script =
      frame_script(figure.title, figure.unit) + "set ytics " + names_as_tics(names) + "\nset yrange [" +
      std::to_string(curves.size()) + "-0.4:-0.6]\nunset key\n" + x.script("x") + "$rows << EOD\n" + block +
      "EOD\nplot $rows using 2:1:3:4 with xerrorbars pt 7 ps 0.8 lw 1.5 lc rgb " + series_color(0);
  return run_gnuplot(script, kPlotWidth, kRest + kRow * static_cast<int>(curves.size()), id);
}

}  // namespace

std::string plot_figure(const StudyComparison& comparison, const PlottedFigure& figure, std::string_view id) {
  const std::vector<Curve> curves = curves_of(comparison, figure.key);
  if (curves.empty()) return "";
  const bool several =
      std::ranges::any_of(curves, [](const Curve& curve) { return curve.readings.size() > 1; });
  return several ? plot_curves(curves, figure, id) : plot_rows(curves, figure, id);
}

}  // namespace kerf
