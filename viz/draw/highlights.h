#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viz/draw/draw_context.h"

namespace kerf {

/// An operator that acted recently.
struct Highlight {
  std::uint64_t event = 0;
  OperatorActed acted;
  std::uint32_t age = 0;                     ///< steps since
  std::uint32_t lifetime = kHighlightSteps;  ///< steps until it has faded
  std::vector<Polygon> faces;                ///< of the node's cell; empty if it is unknown
  Polygon partitioner;                       ///< the new plane within the cell; empty if there is none
  Polygon old_partitioner;                   ///< balance: the old position; merge, swap: the deleted one
  /// The point that its label names: the middle of its partitioner, or else of its cell, when it first
  /// appeared. It does not move, or the label would wander with every plane nearby.
  std::optional<Eigen::Vector3d> anchor;
  [[nodiscard]] double strength() const;    ///< 1 when new, fading with age
  [[nodiscard]] std::string label() const;  ///< "split n5"
  /// Why it acted and what then became of it: "leaf n26 got crowded: split into 61 and 58".
  [[nodiscard]] std::string sentence() const;
};

/// The nodes of a moment and where they are drawn.
template <int D>
struct DrawnTree {
  const TreeSnapshotOf<D>& snapshot;
  std::span<const Box<D>> crowds{};  ///< by node, see `find_crowds`; empty: everywhere
};

/// The operators to highlight. Cells of nodes that have died since (swap removes its node) are those of the
/// last frame in which they lived.
template <int D>
class Highlights {
 public:
  /// Takes in the events of a frame. `before`: the tree of the frame before this one.
  void update(const FrameInput<D>& input, const DrawnTree<D>& now, const DrawnTree<D>& before,
              const Box<D>& bounds);
  /// Newest first.
  [[nodiscard]] const std::vector<Highlight>& all() const { return highlights_; }

 private:
  std::vector<Highlight> highlights_;
  std::map<std::uint64_t, Highlight> remembered_;  ///< by event, as last shown
};

/// Outlines the cells that operators acted on, above everything else in the scene. `list`: records them; may
/// be null.
void draw_highlights(const View& view, double line_scale, const std::vector<Highlight>& highlights,
                     Batch& batch, DrawList* list = nullptr);

}  // namespace kerf
