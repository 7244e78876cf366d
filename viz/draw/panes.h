#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/objects/structure.h"
#include "core/query/structure_measures.h"
#include "core/scene/scene.h"

namespace kerf {

/// A picture has so many panes at most.
inline constexpr std::size_t kMostPanes = 6;

/// The numbers of a pane.
struct PaneFigures {
  std::optional<std::uint64_t> tests;  ///< of pairs of boxes, in the last step; none: unknown
  std::uint64_t pairs = 0;
  StructureMeasures structure;
  std::optional<std::uint64_t> bytes;
  std::optional<double> milliseconds;  ///< of a step, on average over the last ones; none: not measured
};

/// A broad phase beside others.
template <int D>
struct StructurePane {
  std::string name;
  StructureParts<D> parts;     ///< without what it tested
  std::vector<Pair> pairs;     ///< sorted
  std::vector<Pair> rejected;  ///< tested and no pairs: sorted, each once
  PaneFigures figures;
};

/// Broad phases side by side, on the same boxes at the same step.
template <int D>
struct PanesFrame {
  std::string scene;
  std::uint32_t step = 0;
  std::string step_name;        ///< what an import calls the step; empty: its number
  std::uint32_t objects = 0;    ///< that are there
  std::uint32_t moving = 0;     ///< of them
  std::vector<Body<D>> bodies;  ///< body k is object k, also of one that is gone
  std::vector<Pair> contacts;   ///< sorted
  Box<D> bounds;                ///< that each pane frames
  bool has_strips = false;      ///< panes keep room for lists along axes
  bool is_timed = false;        ///< panes keep room for times
  int samples = 4;              ///< of a pixel
  int columns = 0;              ///< of panes; 0: as the bounds call for
  std::vector<StructurePane<D>> panes;
};

/// Whether so many panes are worth looking at in a picture of that size.
bool have_room(int picture_width, int picture_height, std::size_t panes);

/// In how many columns panes show a scene largest; `aspect`: its width over its height.
int choose_columns(int picture_width, int picture_height, std::size_t panes, double aspect);
/// Of what is framed, as a camera usually sees it.
template <int D>
double aspect_of(const Box<D>& bounds);

/// Of the tests of a structure those that found no pair. `pairs`: sorted.
std::vector<Pair> rejected_of(std::vector<Pair> tested, const std::vector<Pair>& pairs);

}  // namespace kerf
