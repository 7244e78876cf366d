#include "frames/study/study_page.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "core/recording/recording_info.h"
#include "frames/page/axis.h"
#include "frames/page/gnuplot.h"
#include "frames/page/page.h"
#include "frames/page/plot_parts.h"
#include "frames/study/summary.h"

namespace kerf {
namespace {

/// What a plot shows of the cells.
struct PlottedFigure {
  const char* key;  ///< in the counts or times of a cell
  const char* title;
  const char* unit;
  const char* caption;
};

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

/// A figure against the number of objects, a curve for each broad phase, with 95 % confidence intervals as
/// bars, which end at 0; of one number of objects, a row for each broad phase. An SVG element for a page in
/// which `id` is unique; empty if no group has the figure. Throws std::runtime_error if gnuplot fails.
std::string plot_figure(const StudyComparison& comparison, const PlottedFigure& figure, std::string_view id) {
  const std::vector<Curve> curves = curves_of(comparison, figure.key);
  if (curves.empty()) return "";
  const bool several =
      std::ranges::any_of(curves, [](const Curve& curve) { return curve.readings.size() > 1; });
  return several ? plot_curves(curves, figure, id) : plot_rows(curves, figure, id);
}

constexpr PlottedFigure kPlots[] = {
    {"total_ms", "Total", "milliseconds a step", "Overhead and collision together."},
    {"overhead_ms", "Overhead", "milliseconds a step",
     "Taking over the boxes and bringing the structure up to date, where the broad phase measures it."},
    {"collision_ms", "Collision", "milliseconds a step", "Finding the pairs, likewise."},
    {"candidates", "Candidates", "candidates a step",
     "Pairs that the structure left to be tested, where the broad phase counts them."}};

const std::vector<TableColumn>& columns() {
  constexpr int kDigits = kShortestDigits;
  static const std::vector<TableColumn> kColumns{{"broad phase", "broad_phase"},
                                                 {"objects", "objects"},
                                                 {"cells", "cells"},
                                                 {"samples", "samples"},
                                                 {"total ms", "total_ms", kDigits},
                                                 {"±", "total_ms_half", kDigits},
                                                 {"overhead ms", "overhead_ms", kDigits},
                                                 {"±", "overhead_ms_half", kDigits},
                                                 {"collision ms", "collision_ms", kDigits},
                                                 {"±", "collision_ms_half", kDigits},
                                                 {"pairs a step", "pairs", 1},
                                                 {"candidates a step", "candidates", 1},
                                                 {"leaves", "leaves", 1},
                                                 {"height", "height", 1},
                                                 {"missed a step", "missed", kDigits},
                                                 {"extra a step", "extra", kDigits},
                                                 {"machine", "machine"}};
  return kColumns;
}

Json row_of(const Group& group) {
  Json row{{"broad_phase", group.broad_phase},
           {"objects", group.objects},
           {"cells", group.cells()},
           {"machine", group.machine}};
  for (const TableColumn& column : columns()) {
    const auto estimate = group.estimate(column.key);
    if (!estimate) continue;
    row[column.key] = estimate->mean;
    row["samples"] = estimate->samples;
    if (estimate->samples > 1) row[column.key + "_half"] = estimate->half;
  }
  return row;
}

/// Only the columns in which some row has a value.
std::vector<TableColumn> filled_columns(const Json& rows) {
  std::vector<TableColumn> filled;
  for (const TableColumn& column : columns())
    for (const Json& row : rows)
      if (row.contains(column.key)) {
        filled.push_back(column);
        break;
      }
  return filled;
}

void write_comparison(const StudyComparison& comparison, const std::string& id, Page& page) {
  page.section(id, comparison.title);
  for (const PlottedFigure& figure : kPlots) {
    const std::string svg = plot_figure(comparison, figure, id + "-" + figure.key);
    if (!svg.empty()) page.figure(svg, figure.caption);
  }
  Json rows = Json::array();
  for (const Group& group : comparison.groups) rows.push_back(row_of(group));
  page.table("Figures", filled_columns(rows), rows, {}, true);
}

std::string machines_of(const JoinedStudy& joined) {
  std::set<std::string> machines;
  for (const JoinedStudy::Cell& cell : joined.cells) machines.insert(cell.file.machine);
  std::string text;
  for (const std::string& machine : machines) text += (text.empty() ? "" : "; ") + machine;
  return text;
}

}  // namespace

std::string study_page(const Study& study, const JoinedStudy& joined, const std::string& command) {
  Page page("Study " + study.name, std::to_string(joined.cells.size()) + " of " +
                                       std::to_string(study.cells.size()) + " cells, measured on " +
                                       machines_of(joined));
  const std::string missing = describe_missing(study, joined);
  if (!missing.empty()) page.paragraph(missing);
  page.paragraph(
      "Bars are 95 % confidence intervals of the mean (Student's t). With several seeds each seed's mean "
      "over its repeats is one sample; with one seed each repeat is. Without a bar there is one sample. "
      "Curves stand a little aside of each other, so that their bars are seen.");
  page.paragraph("All settings and counts have the hash " + to_hex(counts_hash(joined)) +
                 "; it does not depend on who measured them.");
  std::size_t number = 0;
  for (const StudyComparison& comparison : comparisons(joined))
    write_comparison(comparison, "s" + std::to_string(++number), page);
  page.command(command);
  return page.html();
}

}  // namespace kerf
