#pragma once

#include <array>
#include <filesystem>

#include "frames/experiment/simulation.h"

namespace kerf {

/// The names of the figures' files.
inline constexpr std::array<const char*, 4> kFigureNames{"figure-12.svg", "figure-12.png", "figure-13.svg",
                                                         "figure-13.png"};

/// Draws the paper's figures 12 (simulations 1 and 2, a column each) and 13 (3 and 4) by gnuplot, each as SVG
/// and as PNG, into files in the order of `kFigureNames`. Throws std::runtime_error, saying what to do, if
/// gnuplot fails.
void plot_experiment(const std::array<std::filesystem::path, 4>& files, const ExperimentRuns& runs);

}  // namespace kerf
