#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/objects/structure.h"

namespace kerf {

/// How good a structure is, in figures that do not depend on the machine.
struct StructureMeasures {
  std::uint32_t cells = 0;
  std::uint32_t depth = 0;    ///< of the deepest cell
  std::uint64_t members = 0;  ///< an object counts once for each cell that holds it
  double overlap = 0;         ///< share of a parent that two of its children cover both, on average
  double dead = 0;            ///< share of a cell that nothing in it covers, on average
  bool has_parents = false;   ///< `overlap` means something
};

/// `boxes`: by object. A cell without ends is measured within `bounds`.
template <int D>
StructureMeasures measure(const StructureParts<D>& parts, std::span<const Box<D>> boxes,
                          const Box<D>& bounds);

/// By cell: the cells whose parent it is.
template <int D>
std::vector<std::vector<std::uint32_t>> children_of(const StructureParts<D>& parts);

/// The box with its ends at those of `bounds` where it has none.
template <int D>
Box<D> with_ends(Box<D> box, const Box<D>& bounds);

/// The share of their parent's box that two siblings cover both, without axes along which it is flat; 0 of
/// siblings that a plane divides, and of a parent without ends unless there are `bounds`.
template <int D>
double overlap_share(const StructureParts<D>& parts, std::uint32_t a, std::uint32_t b,
                     const Box<D>& bounds = everywhere<D>());

}  // namespace kerf
