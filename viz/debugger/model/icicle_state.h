#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "viz/debugger/model/run.h"
#include "viz/draw/icicle.h"

namespace kerf {

/// The tree in bars at a moment, and the marks of its nodes.
struct IcicleState {
  std::vector<IcicleBar> bars;
  std::uint32_t rows = 1;           ///< of bars, one a depth
  std::optional<OperatorRow> last;  ///< only before it: the operator just before which the tree is shown
  std::optional<NodeId> acted;      ///< the node of the present event, or of `last`
  std::map<NodeId, double> recent;  ///< see `recent_operators`
  std::set<NodeId> selected;        ///< the selected node, or the leaves that hold the selected objects
};

/// The tree of the run's moment, or, with `before`, the tree just before the last operator that acted; if
/// none has, it is the same.
IcicleState make_icicle(Run& run, const Selection& selection, bool before);
/// The tree of which the bars are. Valid until the run moves.
const TreeSnapshot& tree_of(const IcicleState& icicle, Run& run);

/// Keeps the icicle until the run, its moment, the selection or `before` changes.
class IcicleKeeper {
 public:
  const IcicleState& icicle(Run& run, const Selection& selection, bool before);

  /// The last one.
  [[nodiscard]] const IcicleState& kept() const { return icicle_; }

 private:
  const Run* run_ = nullptr;
  Position position_;
  Selection selection_;
  bool before_ = false;
  IcicleState icicle_;
};

}  // namespace kerf
