#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/given_names.h"
#include "core/objects/object_table.h"
#include "core/query/structure_check.h"
#include "core/recording/their_structure.h"

namespace kerf {

/// Another engine's nodes as a structure that can be drawn, measured and checked.
template <int D>
struct TheirParts {
  StructureParts<D> parts;  ///< a cell's name is the place of the first node of that name in the recording
  std::vector<Scalar> margins;         ///< by cell: what the engine claims
  std::vector<StructureFault> faults;  ///< why some nodes hang nowhere, or cannot be leaves
};

/// "n17", as the engine calls it.
template <int D>
std::string node_name(const TheirStructure<D>& structure, std::uint32_t place);

/// Nodes to which no way leads become roots, so that parents always stand before their children.
template <int D>
TheirParts<D> parts_of(const TheirStructure<D>& structure);

/// Whether any of its objects is fixed: engines may keep these apart.
template <int D>
bool holds_fixed(const TheirStructure<D>& structure, const ObjectTable<D>& objects);

/// What bounds may be off for how they were written. A child and its parent stand in one table, and what
/// rounds both alike keeps their order. A recording that does not say it is taken to have six digits
/// everywhere.
StructureTolerance tolerance_of(const std::optional<TheirDigits>& digits);

/// What is known of the steps before the one that is checked.
template <int D>
struct TheirPast {
  const TheirStructure<D>* structure = nullptr;  ///< the last one known; none: this is the first
  bool is_next = false;                          ///< it is of the step just before
  bool held_fixed = false;                       ///< one of them held a fixed object
};

/// All that is wrong with it after a step. `objects`: as they were then. Fixed ones are missed if it holds,
/// or has held, any. A margin that is claimed is judged where a leaf was placed anew since the step before,
/// one that is asked for (`limits`) in new leaves, too: in one that stayed an object may have turned or
/// grown.
template <int D>
std::vector<StructureFault> check_theirs(const TheirStructure<D>& structure, const ObjectTable<D>& objects,
                                         const GivenNames& names, const TheirPast<D>& past = {},
                                         StructureLimits limits = {});

}  // namespace kerf
