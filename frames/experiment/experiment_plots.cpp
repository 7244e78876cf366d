#include "frames/experiment/experiment_plots.h"

#include <algorithm>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "frames/catalog/algorithm.h"
#include "frames/page/gnuplot.h"

namespace kerf {
namespace {

constexpr std::size_t kPoints = 100;  // of a line; each is the median of the steps around it

using Value = std::function<double(const ExperimentStep&, std::size_t contestant)>;

/// One panel of a column.
struct Panel {
  const char* title;
  bool trees_only;
  bool logarithmic;
  Value value;  ///< not drawn if negative, or if 0 on a logarithmic axis
};

const std::vector<Panel>& panels() {
  static const std::vector<Panel> kPanels{
      {"frames a second", false, true, [](const auto& row, std::size_t k) { return row.fps(k); }},
      {"pairs (black) and candidates", false, true,
       [](const auto& row, std::size_t k) { return row.contestants[k].candidates; }},
      {"collision time, ms a step", false, true,
       [](const auto& row, std::size_t k) { return row.contestants[k].collision; }},
      {"overhead (update) time, ms a step", false, true,
       [](const auto& row, std::size_t k) { return row.contestants[k].update; }},
      {"depth of the BSP-tree", true, false,
       [](const auto& row, std::size_t k) { return row.contestants[k].height; }},
      {"leaves of the BSP-tree", true, false,
       [](const auto& row, std::size_t k) { return row.contestants[k].leaves; }},
      {"operators of the BSP-tree so far", true, false,
       [](const auto& row, std::size_t k) { return static_cast<double>(row.contestants[k].operators); }}};
  return kPanels;
}

/// The medians of `value` over stretches of the run, as lines "step value".
std::string points(const ExperimentRun& run, bool logarithmic,
                   const std::function<double(const ExperimentStep&)>& value) {
  std::ostringstream text;
  const std::size_t stretch = std::max<std::size_t>(5, run.size() / kPoints);
  for (std::size_t begin = 0; begin < run.size(); begin += stretch) {
    std::vector<double> values;
    for (std::size_t k = begin; k < std::min(begin + stretch, run.size()); ++k)
      if (const double y = value(run[k]); y > 0 || (y == 0 && !logarithmic)) values.push_back(y);
    if (values.empty()) continue;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    text << run[std::min(begin + stretch / 2, run.size() - 1)].step << ' ' << *middle << '\n';
  }
  return text.str();
}

/// Data blocks and the plot command of one panel.
std::string panel_script(const Panel& panel, const Simulation& simulation, const ExperimentRun& run) {
  std::ostringstream data;
  std::ostringstream plot;
  const auto add = [&](std::size_t index, const std::string& lines, const std::string& style) {
    if (lines.empty()) return;
    const std::string name = "$line" + std::to_string(index);
    data << name << " << EOD\n" << lines << "EOD\n";
    plot << (plot.str().empty() ? "plot " : ", ") << name << " with lines " << style;
  };
  for (std::size_t k = 0; k < contestants().size(); ++k) {
    const std::string name(contestants()[k]);
    if (panel.trees_only && name != kTunedTree && name != kPaperTree) continue;
    const bool tree = name == kPaperTree;
    add(k, points(run, panel.logarithmic, [&](const ExperimentStep& row) { return panel.value(row, k); }),
        "lt " + std::to_string(k + 1) + " lw " + (tree ? "2.5" : "1.3") + " title '" + name + "'");
  }
  if (std::string(panel.title).starts_with("pairs"))
    add(contestants().size(),
        points(run, panel.logarithmic,
               [](const ExperimentStep& row) { return static_cast<double>(row.pairs); }),
        "lc rgb 'black' dt 2 lw 1.5 title 'pairs, all alike'");
  // gnuplot refuses a plot without a point.
  const bool empty = plot.str().empty();
  if (empty) plot << "plot [0:" << run.size() << "] 0 notitle";
  const std::string axis = panel.logarithmic && !empty ? "set logscale y\n" : "set yrange [0:1<*]\n";
  return "set title \"" +
         (&panel == &panels().front() ? "Simulation " + std::to_string(simulation.number) + ": " +
                                            std::string(simulation.title) + "\\n" + panel.title
                                      : std::string(panel.title)) +
         "\"\nunset logscale y\nset yrange [*:*]\n" + axis + data.str() + plot.str() + "\n";
}

std::string figure_script(const std::string& terminal, const std::filesystem::path& path, int left,
                          const ExperimentRuns& runs) {
  std::ostringstream text;
  text
      << "set terminal " << terminal << "\nset output " << in_quotes(path.string()) << "\n"
      << "set linetype 1 lc rgb '#d62728'\nset linetype 2 lc rgb '#1f77b4'\nset linetype 3 lc rgb '#2ca02c'\n"
      << "set linetype 4 lc rgb '#9467bd'\nset linetype 5 lc rgb '#ff7f0e'\nset linetype 6 lc rgb '#e377c2'\n"
      << "set linetype 7 lc rgb '#7f7f7f'\nset grid lc rgb '#dddddd'\nset key outside right top\n"
      << "set format y '%g'\nset xlabel 'step'\nset multiplot layout " << panels().size()
      << ",2 columnsfirst\n";
  for (int side = 0; side < 2; ++side) {
    const auto index = static_cast<std::size_t>(left + side);
    for (const Panel& panel : panels()) text << panel_script(panel, simulations()[index], runs[index]);
  }
  text << "unset multiplot\n";
  return text.str();
}

}  // namespace

void plot_experiment(const std::array<std::filesystem::path, 4>& files, const ExperimentRuns& runs) {
  const auto draw = [](const std::string& script) {
    if (!feed_gnuplot(script))
      throw std::runtime_error("gnuplot did not draw the figures; the simulations are kept");
  };
  for (const int figure : {12, 13}) {
    const int left = 2 * (figure - 12);
    draw(figure_script("svg size 1500,2300 dynamic background rgb 'white' font 'DejaVu Sans,13'",
                       files[static_cast<std::size_t>(left)], left, runs));
    draw(figure_script("pngcairo size 1500,2300 background rgb 'white' font 'DejaVu Sans,11'",
                       files[static_cast<std::size_t>(left + 1)], left, runs));
  }
}

}  // namespace kerf
