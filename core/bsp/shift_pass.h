#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/bsp/step_context.h"
#include "core/geometry/packed_box.h"
#include "core/geometry/plane.h"
#include "core/tree/placement.h"

namespace kerf {

/// An ancestor of a leaf, as the leaf's entries must be compared with it.
template <int D>
struct LeafAncestor {
  Plane<D> plane;
  std::uint32_t direction = 0;
  DepthMask bit = 0;
  bool is_right = false;  ///< the leaf lies right of it
};

/// Moves partitioners and fat boxes by the common motion of a step in which pairs are kept (see
/// `common_motion`). Rounding keeps the order of numbers: a fat box still holds its box, boxes that
/// overlapped still do. But numbers that differed may become equal: an object may then reach other leaves
/// than those that have its entries; it is *misplaced*. Afterwards the changed objects of the step are those
/// that are misplaced, and those that did not follow the shift. Its memory is kept between steps.
template <int D>
class ShiftPass {
 public:
  /// Returns false if something would leave the range of floats; then all is as before.
  bool run(const StepContext<D>& step);

  /// By how much a gap between two boxes may have shrunk by rounding, in units of length. It includes what
  /// rounding may have done to a gap that was measured before.
  [[nodiscard]] Scalar drift() const;
  /// The slack that kept pairs should have: enough for `kShiftsOfSlack` shifts, but at most half of the
  /// thickest skin of a typical object. 0 if that is hardly enough for one.
  [[nodiscard]] Scalar slack() const;
  /// Appends the leaves that have entries of a misplaced object, and all nodes on the way.
  void append_places(ObjectId object, std::vector<Reached>& reached, std::vector<NodeId>& passed) const;

 private:
  /// Of one slice of leaves.
  struct Piece {
    std::vector<LeafAncestor<D>> ancestors;  ///< of one leaf
    std::vector<ObjectId> misplaced;         ///< an object perhaps in several places
  };
  struct Misplaced {
    ObjectId object;
    std::vector<Reached> reached{};  ///< the leaves that have its entries
    std::vector<NodeId> passed{};    ///< the nodes on the way, the leaves included
  };

  bool move_offsets(const StepContext<D>& step);
  bool measure(const StepContext<D>& step);
  void find_left_behind(const StepContext<D>& step);
  void unlist_followers(const StepContext<D>& step);
  void exchange_offsets(Tree<D>& tree);
  void find_misplaced(const StepContext<D>& step);
  void find_misplaced_in(const StepContext<D>& step, NodeId leaf, Piece& piece) const;
  void find_entries(const StepContext<D>& step);
  void move_table(const StepContext<D>& step) const;
  void list_changed(const StepContext<D>& step) const;

  std::vector<Scalar> offsets_;  ///< of the partitioners, by node: those that the tree does not have
  Scalar reach_before_ = 0;      ///< the largest coordinate of a box
  Scalar reach_after_ = 0;
  Scalar size_ = 0;                   ///< a typical one
  std::vector<PackedBox<D>> around_;  ///< all boxes of each slice of objects
  std::vector<Piece> pieces_;
  std::vector<ObjectId> left_behind_;
  std::vector<NodeId> leaves_;
  std::vector<Misplaced> misplaced_;  ///< in ascending order
};

extern template class ShiftPass<2>;
extern template class ShiftPass<3>;

}  // namespace kerf
