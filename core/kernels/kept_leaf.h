#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/broad_phase/pair_buffer.h"
#include "core/kernels/leaf_view.h"

namespace kerf {

/// The fat boxes of a leaf in bytes, in no order, so that one object can come, go or be looked up at the cost
/// of a scan of bytes; and the pairs of fat boxes found among them, which stay candidates for as long as the
/// boxes stay in their fat ones.
template <int D>
struct KeptLeaf {
  std::uint32_t generation = 0;  ///< one more than that of the node whose leaf this is; 0: nothing is kept
  std::array<float, 4> origin{};
  std::array<float, 4> scale{};
  std::vector<std::uint32_t> objects;
  std::vector<DepthMask> apart;
  std::vector<std::uint8_t> planes;  ///< min of each axis, then max, `stride` bytes each
  std::size_t stride = 0;
  /// Rows one behind the other: an object, the number of its partners, the partners.
  std::vector<std::uint32_t> rows;

  [[nodiscard]] std::uint8_t* plane(std::size_t k) { return planes.data() + k * stride; }
};

/// Takes the entries of a view into an empty or outdated leaf; the rows stay as they are.
template <int D>
void keep_entries(const LeafView<D>& view, KeptLeaf<D>& leaf);
/// Takes out entry `k`; the last one takes its place.
template <int D>
void drop_entry(KeptLeaf<D>& leaf, std::size_t k);
/// Adds an entry, and a row with all those that its fat box overlaps. `boxes` has the fat boxes by object.
template <int D>
void add_entry(KeptLeaf<D>& leaf, std::uint32_t object, DepthMask apart, std::span<const PackedBox<D>> boxes);
/// Appends the candidates of `rows` whose boxes overlap, as canonical pairs. `boxes` by object.
template <int D>
void filter_rows(std::span<const std::uint32_t> rows, std::span<const PackedBox<D>> boxes, PairBuffer& pairs);

}  // namespace kerf
