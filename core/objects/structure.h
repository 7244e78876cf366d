#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/box.h"
#include "core/geometry/plane.h"

namespace kerf {

/// The parent of a root, and the cut of a cell that its box alone bounds.
inline constexpr std::uint32_t kNoPart = UINT32_MAX;

/// Which objects a cell holds.
enum class Holding : std::uint8_t {
  inside,       ///< those whose boxes lie in its box, each in one cell
  reaching,     ///< all whose boxes reach it. Cells are half-open: a box reaches min <= p < max
  of_its_depth  ///< likewise, but each object has a depth, and is in cells of no other
};

/// The side of a partitioner: right is beyond it.
template <int D>
struct Cut {
  Plane<D> plane;
  bool right = false;
};

/// A part of space, or of the objects. It holds objects, or cells, or both.
template <int D>
struct StructureCell {
  Box<D> box;                      ///< infinite where it has no end
  std::uint32_t name = 0;          ///< its number in the structure: a node, a place
  std::uint32_t parent = kNoPart;  ///< stands before it in the list of cells
  std::uint32_t depth = 0;         ///< of a root 0
  std::uint32_t cut = kNoPart;     ///< which of the cuts divides it from the rest of its parent
};

/// An object in a cell.
struct CellMember {
  std::uint32_t cell = 0;
  ObjectId object;
  friend constexpr auto operator<=>(const CellMember&, const CellMember&) = default;
};

/// An end of an object's box along an axis, as the structure has it.
struct AxisEnd {
  Scalar value = 0;
  ObjectId object;
  bool upper = false;
};

/// The order of objects along an axis: of their beginnings, or of both ends.
struct AxisList {
  int axis = 0;
  std::vector<AxisEnd> ends;
};

/// The description of a structure: a value that does not depend on it any more.
template <int D>
struct StructureParts {
  std::string kind;  ///< "tree of boxes"
  Holding holding = Holding::inside;
  bool is_round = false;                ///< cells are the balls in their boxes
  std::vector<StructureCell<D>> cells;  ///< parents before children
  std::vector<Cut<D>> cuts;
  std::vector<CellMember> members;
  std::vector<AxisList> lists;
  /// How many pairs of boxes were compared in the last step; none: unknown.
  std::optional<std::uint64_t> tests;
  bool tells_tested = false;  ///< which these were, too
  std::vector<Pair> tested;   ///< one for each test
  /// About what the structure takes beside its table of objects and the pairs that it reports; none: unknown.
  std::optional<std::uint64_t> bytes;
  std::string unseen;  ///< why something is missing, as a sentence; empty: nothing is

  void tell_tested(ObjectId a, ObjectId b) { tested.push_back(make_pair(a, b)); }
  /// Ends what was begun with `tell_tested`.
  void end_tested() {
    tells_tested = true;
    tests = tested.size();
  }
};

/// A broad phase that shows its structure implements it beside BroadPhase. It costs nothing until called.
template <int D>
class SelfDescribing {
 public:
  SelfDescribing() = default;
  SelfDescribing(const SelfDescribing&) = delete;
  SelfDescribing& operator=(const SelfDescribing&) = delete;
  virtual ~SelfDescribing() = default;

  /// Adds what the last `step()` has left to `parts`, which are empty. Requests since then are not part of
  /// it, so call it right after a step. The same state gives the same parts in the same order.
  virtual void describe(StructureParts<D>& parts) const = 0;
};

/// A box without ends.
template <int D>
constexpr Box<D> everywhere() {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    box.min[i] = -std::numeric_limits<Scalar>::infinity();
    box.max[i] = std::numeric_limits<Scalar>::infinity();
  }
  return box;
}

/// The memory of a vector.
template <class T>
std::uint64_t bytes_of(const std::vector<T>& list) {
  return list.capacity() * sizeof(T);
}

/// Describes a broad phase without a structure that tests each of so many boxes against each.
template <int D>
void tell_each_with_each(std::uint64_t boxes, StructureParts<D>& parts) {
  parts.kind = "each with each";
  parts.tests = boxes * (boxes - (boxes > 0 ? 1 : 0)) / 2;
  parts.bytes = 0;
  parts.unseen = "it has no structure: each box is tested against each";
}

/// Adds the tests of a sweep: each object, in the order of `sorted`, against those behind it that begin
/// before it ends. `box_of(object)`: its box.
template <int D, class BoxOf>
void tell_sweep(const std::vector<ObjectId>& sorted, int axis, BoxOf box_of, StructureParts<D>& parts) {
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const Scalar end = box_of(sorted[k]).max[axis];
    for (std::size_t i = k + 1; i < sorted.size() && box_of(sorted[i]).min[axis] <= end; ++i)
      parts.tell_tested(sorted[k], sorted[i]);
  }
}

}  // namespace kerf
