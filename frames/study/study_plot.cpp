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
  std::vector<Reading> readings;
};

/// A curve for each broad phase; the machine is named if there are several.
std::vector<Curve> curves_of(const Comparison& comparison, const std::string& figure) {
  std::set<std::string> machines;
  for (const Group& group : comparison.groups) machines.insert(group.machine);
  std::vector<Curve> curves;
  for (const Group& group : comparison.groups) {
    const auto estimate = group.estimate(figure);
    if (!estimate) continue;
    const std::string name = group.broad_phase + (machines.size() > 1 ? ", " + group.machine : "");
    auto curve = std::ranges::find(curves, name, &Curve::name);
    if (curve == curves.end()) curve = curves.insert(curves.end(), Curve{name, {}});
    curve->readings.push_back({static_cast<double>(group.objects), *estimate});
  }
  for (Curve& curve : curves) std::ranges::sort(curve.readings, {}, &Reading::objects);
  return curves;
}

std::vector<double> ends_of(const std::vector<Curve>& curves, bool log) {
  std::vector<double> ends;
  for (const Curve& curve : curves)
    for (const Reading& reading : curve.readings)
      for (const double side : {-1.0, 0.0, 1.0}) {
        const double end = reading.estimate.mean + side * reading.estimate.half;
        if (!log || end > 0) ends.push_back(end);
      }
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
  // A logarithmic axis has no place for the lower end of a wide estimate.
  const double low = estimate.mean - estimate.half;
  return plot_number(place) + " " + plot_number(axis.place(estimate.mean)) + " " +
         plot_number(axis.place(low)) + " " + plot_number(axis.place(estimate.mean + estimate.half)) + "\n";
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
             series_color(k) + " title " + in_quotes(curves[k].name);
  }
  return blocks + plots;
}

std::string plot_curves(const std::vector<Curve>& curves, const std::string& title, const std::string& label,
                        std::string_view id) {
  const bool log = spans_decades(curves);
  const Axis y(ends_of(curves, log), log);
  std::vector<double> objects;
  for (const Curve& curve : curves)
    for (const Reading& reading : curve.readings) objects.push_back(reading.objects);
  const Axis x(objects, true);
  const std::string script = frame_script(title, "objects") + "set ylabel " + in_quotes(label) +
                             "\nset key outside right top Left reverse\n" + x.script("x") + y.script("y") +
                             curves_script(curves, y);
  return run_gnuplot(script, kPlotWidth, kPlotHeight, id);
}

/// A row for each broad phase, the first on top.
std::string plot_rows(const std::vector<Curve>& curves, const std::string& title, const std::string& label,
                      std::string_view id) {
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
      frame_script(title, label) + "set ytics " + names_as_tics(names) + "\nset yrange [" +
      std::to_string(curves.size()) + "-0.4:-0.6]\nunset key\n" + x.script("x") + "$rows << EOD\n" + block +
      "EOD\nplot $rows using 2:1:3:4 with xerrorbars pt 7 ps 0.8 lw 1.5 lc rgb " + series_color(0);
  return run_gnuplot(script, kPlotWidth, kRest + kRow * static_cast<int>(curves.size()), id);
}

}  // namespace

std::string plot_figure(const Comparison& comparison, const std::string& figure, const std::string& label,
                        std::string_view id) {
  const std::vector<Curve> curves = curves_of(comparison, figure);
  if (curves.empty()) return "";
  const std::string title = comparison.title;
  const bool several =
      std::ranges::any_of(curves, [](const Curve& curve) { return curve.readings.size() > 1; });
  return several ? plot_curves(curves, title, label, id) : plot_rows(curves, title, label, id);
}

}  // namespace kerf
