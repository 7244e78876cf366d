#include "frames/experiment/experiment_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "frames/catalog/algorithm.h"
#include "frames/experiment/reading.h"
#include "frames/experiment/run_measures.h"
#include "frames/experiment/spread.h"
#include "frames/page/gnuplot.h"

namespace kerf {
namespace {

using PanelValue = double (*)(const ExperimentStep&, std::size_t contestant);

/// One panel of a column; a value below zero is no figure.
struct Panel {
  const char* title;
  const char* unit;
  bool logarithmic;
  bool trees_only;
  bool is_time;
  PanelValue value;
};

constexpr std::array<Panel, 7> kPanels{
    {{"frames a second", "", true, false, true, [](const auto& row, std::size_t k) { return row.fps(k); }},
     {"pairs left to be tested", "", true, false, false,
      [](const auto& row, std::size_t k) { return row.contestants[k].candidates; }},
     {"collision time, ms a step", " ms", true, false, true,
      [](const auto& row, std::size_t k) { return row.contestants[k].collision; }},
     {"overhead, ms a step", " ms", true, false, true,
      [](const auto& row, std::size_t k) { return row.contestants[k].update; }},
     {"depth of the tree", "", false, true, false,
      [](const auto& row, std::size_t k) { return double{1} * row.contestants[k].height; }},
     {"leaves of the tree", "", false, true, false,
      [](const auto& row, std::size_t k) { return double{1} * row.contestants[k].leaves; }},
     {"operators of the tree so far", "", false, true, false,
      [](const auto& row, std::size_t k) { return static_cast<double>(row.contestants[k].operators); }}}};
constexpr std::size_t kPairsPanel = 1;
constexpr std::array<std::size_t, 4> kReadingPanels{4, 5, kPairsPanel, 3};

std::size_t stretch_of(const ExperimentRun& run) {
  constexpr std::size_t kLeast = 5;  // candidates are counted each fifth step
  return std::max(kLeast, (run.size() + kCurvePoints - 1) / kCurvePoints);
}

double median_of(std::span<const ExperimentStep> steps, const StepValue& value) {
  std::vector<double> values;
  for (const ExperimentStep& row : steps)
    if (const double one = value(row); one >= 0) values.push_back(one);
  const auto spread = spread_of(values);
  return spread ? spread->median : std::nan("");
}

/// Runs of different seeds have the same length.
std::vector<CurvePoint> points_of(const std::vector<TimedRun>& runs, bool is_time, const StepValue& value) {
  const std::size_t stretch = stretch_of(runs.front().steps);
  const std::vector<std::uint32_t> steps = curve_steps(runs.front().steps);
  std::vector<CurvePoint> points;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    std::vector<double> samples;
    for (const TimedRun& run : runs) {
      if (!is_time && run.repeat > 1) continue;
      const std::size_t begin = k * stretch;
      const std::size_t count = std::min(stretch, run.steps.size() - begin);
      samples.push_back(median_of(std::span(run.steps).subspan(begin, count), value));
    }
    if (const auto spread = spread_of(samples))
      points.push_back({double{1} * steps[k], spread->median, spread->low, spread->high});
  }
  return points;
}

bool is_tree(std::string_view contestant) { return contestant == kPaperTree || contestant == kTunedTree; }

/// A plot of a panel's kind without curves.
CurvePlot empty_plot(const Panel& panel, const Simulation& simulation, const std::vector<TimedRun>& runs) {
  CurvePlot plot;
  plot.title = "Simulation " + std::to_string(simulation.number) + " (" + std::string(simulation.scene) +
               "): " + panel.title;
  plot.x_label = "step";
  plot.unit = panel.unit;
  plot.log_y = panel.logarithmic;
  plot.x_end = static_cast<double>(runs.front().steps.size());
  return plot;
}

std::vector<CurvePoint> points_of(const std::vector<TimedRun>& runs, const Panel& panel,
                                  std::string_view contestant) {
  const auto k =
      static_cast<std::size_t>(std::ranges::find(contestants(), contestant) - contestants().begin());
  return points_of(runs, panel.is_time, [&](const ExperimentStep& row) { return panel.value(row, k); });
}

/// In the steps in which those left to be tested were counted, with which they share a panel.
StepValue true_pairs() {
  return [](const ExperimentStep& row) {
    const bool are_counted =
        std::ranges::any_of(row.contestants, [](const auto& each) { return each.candidates >= 0; });
    return are_counted ? static_cast<double>(row.pairs) : -1.0;
  };
}

/// The script with a place on the sheet for what it draws; it begins by a reset, which would undo it.
std::string placed(std::string script, double x, double y, double width, double height) {
  return script.insert(script.find("set encoding"), "set origin " + plot_number(x) + "," + plot_number(y) +
                                                        "\nset size " + plot_number(width) + "," +
                                                        plot_number(height) +
                                                        "\nset lmargin 9\nset rmargin 4\n");
}

/// Two columns of panels below a legend.
std::string figure_script(const std::string& terminal, const std::filesystem::path& path, std::size_t left,
                          const ExperimentRuns& runs) {
  std::array<std::vector<CurvePlot>, 2> columns;
  for (std::size_t side = 0; side < 2; ++side)
    columns[side] = experiment_panels(simulations()[left + side], runs[left + side], "");
  const std::size_t rows = columns[0].size();
  std::string script = "set terminal " + terminal + "\nset output " + in_quotes(path.string()) +
                       "\nset multiplot\n" +
                       placed(curve_legend_script(experiment_legend()), 0, 0.975, 1, 0.025);
  const double height = 0.97 / static_cast<double>(rows);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t side = 0; side < 2; ++side) {
      const std::string name = "p" + std::to_string(side) + "_" + std::to_string(row) + "_";
      script += placed(curve_script(columns[side][row], name), 0.5 * static_cast<double>(side),
                       height * static_cast<double>(rows - 1 - row), 0.5, height);
    }
  return script + "unset multiplot\n";
}

}  // namespace

std::vector<std::uint32_t> curve_steps(const ExperimentRun& run) {
  const std::size_t stretch = stretch_of(run);
  std::vector<std::uint32_t> steps;
  for (std::size_t begin = 0; begin < run.size(); begin += stretch)
    steps.push_back(run[std::min(begin + stretch / 2, run.size() - 1)].step);
  return steps;
}

std::vector<Curve> experiment_legend() {
  std::vector<Curve> legend;
  for (const std::string_view name : contestants_in_figures())
    legend.push_back({std::string(paper_name(name)), legend.size(), {}});
  legend.push_back({"pairs reported by all", legend.size(), {}});
  return legend;
}

std::vector<Curve> reading_legend() {
  std::vector<Curve> legend;
  for (const Reading& reading : readings()) legend.push_back({std::string(reading.label), legend.size(), {}});
  return legend;
}

std::vector<CurvePlot> experiment_panels(const Simulation& simulation, const std::vector<TimedRun>& runs,
                                         const std::string& links) {
  std::vector<CurvePlot> plots;
  for (const Panel& panel : kPanels) {
    CurvePlot& plot = plots.emplace_back(empty_plot(panel, simulation, runs));
    plot.links = links;
    for (Curve& curve : experiment_legend()) {
      if (curve.look == contestants_in_figures().size()) continue;
      const std::string_view contestant = contestants_in_figures()[curve.look];
      if (panel.trees_only && !is_tree(contestant)) continue;
      curve.points = points_of(runs, panel, contestant);
      plot.curves.push_back(std::move(curve));
    }
  }
  Curve reported = experiment_legend().back();
  reported.points = points_of(runs, false, true_pairs());
  plots[kPairsPanel].curves.push_back(std::move(reported));
  return plots;
}

std::vector<CurvePlot> reading_panels(const Simulation& simulation, const std::vector<TimedRun>& runs) {
  std::vector<CurvePlot> plots;
  for (const std::size_t k : kReadingPanels) {
    CurvePlot& plot = plots.emplace_back(empty_plot(kPanels[k], simulation, runs));
    for (Curve& curve : reading_legend()) {
      curve.points = points_of(runs, kPanels[k], readings()[curve.look].contestant);
      plot.curves.push_back(std::move(curve));
    }
  }
  return plots;
}

void plot_experiment(const std::array<std::filesystem::path, 4>& files, const ExperimentRuns& runs) {
  constexpr const char* kSvg = "svg size 1500,2300 dynamic background rgb 'white' font 'DejaVu Sans,13'";
  constexpr const char* kPng = "pngcairo size 1500,2300 background rgb 'white' font 'DejaVu Sans,11'";
  for (std::size_t k = 0; k < files.size(); ++k)
    if (!feed_gnuplot(figure_script(k % 2 == 0 ? kSvg : kPng, files[k], k / 2 * 2, runs)))
      throw std::runtime_error("gnuplot did not draw the figures; the simulations are kept");
}

}  // namespace kerf
