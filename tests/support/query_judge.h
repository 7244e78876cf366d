#pragma once

#include <cstdint>
#include <string>

#include "core/objects/object_table.h"
#include "core/spatial/spatial_index.h"
#include "core/spatial/tree_walk.h"

namespace kerf::test {

/// Asks an index, batches and, if there is one, the tree `rounds` queries of each kind (QueryMaker) and
/// compares what they find with what a look at each box of the table finds. Returns the first difference in
/// words; empty if there is none.
template <int D>
std::string judge_queries(const ObjectTable<D>& table, const SpatialIndex<D>& index, TreeWalk<D>* walk,
                          std::uint32_t rounds, std::uint64_t seed);

}  // namespace kerf::test
