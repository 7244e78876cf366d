#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "frames/experiment/simulation.h"
#include "frames/page/curve_plot.h"

namespace kerf {

/// How many points the curves have at most; each stands for the steps around it.
inline constexpr std::size_t kCurvePoints = 60;

/// The panels of one simulation, from top to bottom of its column in the paper's figures 12 and 13: frames a
/// second, pairs, collision time, overhead, depth, leaves and operators. A point is the median of its steps,
/// and of all runs; its band is the spread over the runs. Points link to `links` and their step.
std::vector<CurvePlot> experiment_panels(const Simulation& simulation, const std::vector<TimedRun>& runs,
                                         const std::string& links);

/// Of one simulation in all readings of the paper's tree: depth, leaves, pairs and overhead.
std::vector<CurvePlot> reading_panels(const Simulation& simulation, const std::vector<TimedRun>& runs);

/// The curves of their legend, without points.
std::vector<Curve> reading_legend();

/// The curves of the legend of `experiment_panels`, without points: the contestants by the paper's names, and
/// the true pairs.
std::vector<Curve> experiment_legend();

/// The steps of the points.
std::vector<std::uint32_t> curve_steps(const ExperimentRun& run);

/// The names of the figures' files.
inline constexpr std::array<const char*, 4> kFigureNames{"figure-12.svg", "figure-12.png", "figure-13.svg",
                                                         "figure-13.png"};

/// Draws the paper's figures 12 (simulations 1 and 2, a column each) and 13 (3 and 4) by gnuplot, each as SVG
/// and as PNG, into files in the order of `kFigureNames`. Throws std::runtime_error, saying what to do, if
/// gnuplot fails.
void plot_experiment(const std::array<std::filesystem::path, 4>& files, const ExperimentRuns& runs);

}  // namespace kerf
