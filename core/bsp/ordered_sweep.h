#pragma once

#include <vector>

#include "core/base/append_buffer.h"
#include "core/base/ids.h"
#include "core/tree/tree.h"

namespace kerf {

/// Scratch memory of the sweep, kept between steps so that a step allocates nothing.
template <int D>
struct SweepBuffer {
  std::vector<Box<D>> boxes;
  std::vector<std::uint8_t> fixed;
};

/// Orders the entries of a leaf by (key.lo, object); nearly linear when they are nearly ordered.
void sort_entries(std::vector<Entry>& entries);

/// Appends the pairs of one leaf that the canonical-leaf rule (DESIGN.md, "Each pair once") gives to it. The
/// entries are ordered; two boxes can overlap only if their keys do, so the inner loop ends at the first key
/// beyond.
template <int D>
void sweep_leaf(const ObjectTable<D>& table, const Node<D>& leaf, SweepBuffer<D>& buffer, PairBuffer& pairs);

/// Removes the pairs from place `begin` on whose volumes do not overlap, though their boxes do.
template <int D>
void drop_separated(const ObjectTable<D>& table, std::size_t begin, PairBuffer& pairs);

}  // namespace kerf
