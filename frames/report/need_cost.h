#pragma once

#include <string>
#include <vector>

#include "frames/report/take.h"

namespace kerf {

/// The modelled needs of a scene; by default the least: boxes that do not turn, of objects that all move,
/// partitioners along the axes, pairs only.
struct Model {
  std::string need;  ///< the need that it adds to the least model
  bool third_axis = false;
  bool fixed_objects = false;
  bool rotation = false;
  bool free_directions = false;
  bool contacts = false;
  VolumeKind volume = VolumeKind::box;
};

/// The least model, each need of D dimensions switched on alone, and all of them. Only 2D can add a third
/// axis.
template <int D>
std::vector<Model> models();

/// Runs a take as modelled: {"need", "mean_ns", "median_ns", "p99_ns", "max_ns" (a moving object and step:
/// bounding, broad phase and, if it is modelled, narrow phase), "candidates" (a moving object and step)}.
template <int D>
Json run_model(const Take<D>& take, const Model& model, std::uint32_t rounds, const Poll& poll);

}  // namespace kerf
