#pragma once

#include <vector>

#include "viz/debugger/model/node_figures.h"
#include "viz/debugger/model/view_settings.h"
#include "viz/draw/color.h"

namespace kerf {

/// A value for each living node by the meaning of the tint, and the value at which the colours should end.
/// Where the tint is of leaves alone (population, cost), a partitioner has the greatest value below it.
struct NodeTints {
  std::vector<float> values;
  double end = 1;
  /// From 0 to 1, for colours that end there.
  [[nodiscard]] float share(NodeId node, double colors_end) const;
  [[nodiscard]] Color color(NodeId node, double colors_end) const;
};
NodeTints find_tints(const TreeMoment& moment, Tint tint);

}  // namespace kerf
