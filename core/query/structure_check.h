#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/objects/structure.h"
#include "core/recording/their_digits.h"

namespace kerf {

/// What can be wrong with a structure.
enum class StructureFaultKind : std::uint8_t {
  child_outside_parent,  ///< a refit was forgotten
  object_outside_cell,   ///< its box has left the cell's
  object_in_no_cell,     ///< its leaf is lost, or was never inserted
  object_in_two_cells,   ///< of a structure that keeps each in one
  object_not_where_it_reaches,
  unknown_object,  ///< a cell or a list holds what is no object
  leaf_without_object,
  child_of_two,  ///< two nodes have one child
  too_deep,
  too_much_overlap,  ///< of siblings
  no_margin,         ///< a leaf is as tight as its object, so that each move places it anew
  list_out_of_order,
  object_not_in_list,
  pair_never_tested,  ///< it was reported, but the structure does not bring it together
  node_lost,          ///< no way leads to it from a root
  leaf_with_children,
};
/// "child outside its parent"
std::string_view to_string(StructureFaultKind kind);

struct StructureFault {
  StructureFaultKind kind = StructureFaultKind::child_outside_parent;
  std::uint32_t cell = kNoPart;  ///< its name, if it is about a cell
  ObjectId object;               ///< none: it is not about one
  std::string text;              ///< a sentence
};

/// What things are called in sentences; none: by their numbers.
struct StructureNames {
  std::function<std::string(ObjectId)> object{};
  std::function<std::string(std::uint32_t)> cell{};  ///< by its name; "n17"
};

/// How far a bound may lie outside of another without a fault: not at all, for floats as they are, and more
/// for numbers that were written as text.
struct BoundTolerance {
  double share = 0;              ///< of the lesser of the two
  double ulps = 0;               ///< of a float of their size
  WrittenDigits outer_digits{};  ///< how each was written
  WrittenDigits inner_digits{};

  [[nodiscard]] double allowed(double outer, double inner) const;
  /// The same for how far apart they are: rounding keeps the order of two numbers, but not their distance.
  [[nodiscard]] double allowed_apart(double outer, double inner) const;
};

/// Of the boxes of a structure.
struct StructureTolerance {
  BoundTolerance child{};   ///< in its parent
  BoundTolerance object{};  ///< in its cell
};

/// Bounds for a structure; by default there are none.
struct StructureLimits {
  std::uint32_t depth = std::numeric_limits<std::uint32_t>::max();
  double overlap = std::numeric_limits<double>::infinity();  ///< of two siblings, as a share of their parent
  StructureTolerance tolerance{};
  Scalar margin = 0;              ///< that a leaf has at least around its object, along each axis
  std::vector<Scalar> margins{};  ///< by cell, where one claims more
};

/// An object with the box that the structure was last given.
template <int D>
struct KnownObject {
  ObjectId object;
  Box<D> box;
};

/// All that is wrong with a described structure: empty if it keeps what its `holding` promises.
/// `pairs`: what it reported. Objects are bounded by their boxes.
template <int D>
std::vector<StructureFault> check_structure(const StructureParts<D>& parts,
                                            std::span<const KnownObject<D>> objects,
                                            std::span<const Pair> pairs, const StructureLimits& limits = {},
                                            const StructureNames& names = {});

/// Where `inner` leaves `outer`: "along x it ends at 5.2, beyond 5".
template <int D>
std::string how_outside(const Box<D>& inner, const Box<D>& outer, const BoundTolerance& tolerance = {});
/// Whether `outer` holds `inner` but for what is allowed.
template <int D>
bool holds_rounded(const Box<D>& outer, const Box<D>& inner, const BoundTolerance& tolerance);

}  // namespace kerf
