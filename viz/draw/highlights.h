#pragma once

#include <map>
#include <string>
#include <vector>

#include "viz/draw/draw_context.h"

namespace kerf {

/// An operator that acted lately.
struct Highlight {
  std::uint64_t event = 0;
  OperatorActed acted;
  std::uint32_t age = 0;                    ///< steps since
  std::vector<Polygon> faces;               ///< of the node's cell; empty if nothing is known of it
  Polygon partitioner;                      ///< the new plane within the cell; empty if there is none
  Polygon old_partitioner;                  ///< balance: where it was; merge, swap: the one that is gone
  [[nodiscard]] double strength() const;    ///< 1 when new, fading with age
  [[nodiscard]] std::string label() const;  ///< "split n5"
};

/// The operators to be highlighted. Cells of nodes that have died since (swap removes its node) are those of
/// the last frame in which they lived.
template <int D>
class Highlights {
 public:
  /// Takes in the events of a frame. `before`: the tree of the frame before this one.
  void update(const FrameInput<D>& input, const Skeleton<D>& now, const Skeleton<D>& before,
              const Box<D>& bounds);
  /// Newest first.
  [[nodiscard]] const std::vector<Highlight>& all() const { return highlights_; }

 private:
  std::vector<Highlight> highlights_;
  std::map<std::uint64_t, Highlight> remembered_;  ///< by event: those whose node is gone
};

/// Outlines the cells that operators acted on, above everything else in the scene.
/// `list`: takes note of them; may be null.
void draw_highlights(const View& view, double line_scale, const std::vector<Highlight>& highlights,
                     Batch& batch, DrawList* list = nullptr);

extern template class Highlights<2>;
extern template class Highlights<3>;

}  // namespace kerf
