#pragma once

#include <string>

#include "core/base/given_names.h"
#include "core/objects/object_table.h"
#include "core/recording/their_structure.h"

namespace kerf {

/// Where searches through another engine's structure lose a pair, or that they find it: a line for each
/// search, from the root with the box of one object's node for the other object. It ends at *their* node.
template <int D>
std::string explain_their_search(const TheirStructure<D>& structure, const ObjectTable<D>& objects,
                                 const Pair& pair, const GivenNames& names);

}  // namespace kerf
