#pragma once

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

/// The placed objects. Without fixed ones if the structure has none of these: engines keep them apart.
template <int D>
std::vector<KnownObject<D>> objects_for(const TheirStructure<D>& structure, const ObjectTable<D>& objects);

/// What numbers of six digits round away together: a program need not write boxes and nodes alike.
inline constexpr Scalar kSixDigits = 1e-5F;
/// All that is wrong with it after a step, but for such differences. `objects`: as they were then.
template <int D>
std::vector<StructureFault> check_theirs(const TheirStructure<D>& structure, const ObjectTable<D>& objects,
                                         const GivenNames& names, StructureLimits limits = {});

}  // namespace kerf
