#pragma once

#include <span>
#include <string_view>

#include "frames/experiment/simulation.h"

namespace kerf {

/// A way to read the paper's tree where its words leave one open.
struct Reading {
  std::string_view contestant;  ///< "kerf-paper:" and the parameters that differ, or "kerf-paper" itself
  std::string_view label;       ///< a few words for legends
  std::string_view words;       ///< what the paper says and how it is read
};

/// The one that `kerf-paper` is comes first. All of them run in each simulation, on the same boxes.
std::span<const Reading> readings();

/// What a run shows of a reading's tree after its first third.
struct ReadingShape {
  double least_leaves = 0;
  double most_leaves = 0;
  double least_depth = 0;
  double most_depth = 0;
};
ReadingShape shape_of(const ExperimentRun& run, std::string_view contestant);

}  // namespace kerf
