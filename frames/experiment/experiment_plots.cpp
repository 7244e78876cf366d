#include "frames/experiment/experiment_plots.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "frames/experiment/experiment_panels.h"
#include "frames/page/gnuplot.h"

namespace kerf {
namespace {

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

void plot_experiment(const std::array<std::filesystem::path, 4>& files, const ExperimentRuns& runs) {
  constexpr const char* kSvg = "svg size 1500,2300 dynamic background rgb 'white' font 'DejaVu Sans,13'";
  constexpr const char* kPng = "pngcairo size 1500,2300 background rgb 'white' font 'DejaVu Sans,11'";
  for (std::size_t k = 0; k < files.size(); ++k)
    if (!feed_gnuplot(figure_script(k % 2 == 0 ? kSvg : kPng, files[k], k / 2 * 2, runs)))
      throw std::runtime_error("gnuplot did not draw the figures; the simulations are kept");
}

}  // namespace kerf
