#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/kernels/found_rows.h"
#include "core/kernels/leaf_view.h"
#include "core/kernels/rank_keys.h"
#include "core/kernels/resting_list.h"

namespace kerf {

/// An entry whose pairs are not kept.
struct RestlessEntry {
  std::uint32_t object = 0;
  DepthMask apart = 0;
};

/// How the two objects of a pair are named.
enum class Names : std::uint8_t {
  objects,
  places,  ///< in the leaf
};

/// The fat boxes of a leaf in bytes, in no order, so that one object can come, go or be looked up at the cost
/// of a scan of bytes; and the pairs of fat boxes found among them, which stay candidates as long as the
/// boxes stay in their fat boxes. Restless objects are listed beside them.
///
/// An object has no fat while its box equals its fat box.
template <int D>
struct KeptLeaf {
  ByteScale<D> bytes;
  std::unique_ptr<RankScale<D>> ranks;  ///< in its place where the boxes lie in clumps
  bool bytes_stale = false;             ///< the boxes moved with the scale since the entries' bytes were made
  std::vector<std::uint32_t> objects;
  std::vector<DepthMask> apart;
  std::vector<std::uint8_t> planes;  ///< min of each axis, then max, `stride` bytes each
  std::size_t stride = 0;
  RestingList resting;           ///< pairs of objects without fat
  std::vector<Pair> candidates;  ///< others, of fat boxes within the slack; `a` is the lower object
  std::vector<Pair> near;        ///< of objects without fat, whose boxes a shift may let touch
  Names names = Names::objects;  ///< of the candidates
  std::vector<RestlessEntry> restless;
  bool swept = false;  ///< nothing is kept, since too many are restless: the leaf is swept in each step
  std::size_t restless_entries = 0;  ///< number of them in the last pass over restless objects

  [[nodiscard]] std::uint8_t* plane(std::size_t k) { return planes.data() + k * stride; }
};

/// Forgets all entries and pairs. From now on the leaf's bytes separate boxes like those of the view well.
template <int D>
void empty_leaf(const LeafView<D>& view, KeptLeaf<D>& leaf);
/// From now on the leaf's bytes are ranks among boxes like those of the view.
template <int D>
void rank_bytes(const LeafView<D>& view, KeptLeaf<D>& leaf);
/// The leaf's bytes are those of boxes that moved by a vector.
template <int D>
void move_bytes(const Vector<D>& by, KeptLeaf<D>& leaf);
/// Adds the entries of a view to those of the leaf; the pairs stay as they are.
template <int D>
void append_entries(const LeafView<D>& view, KeptLeaf<D>& leaf);
/// Makes the bytes of all entries anew if they are stale. `boxes` is by object; `gathered` is room for
/// those of the leaf.
template <int D>
void renew_bytes(KeptLeaf<D>& leaf, std::span<const PackedBox<D>> boxes, std::vector<PackedBox<D>>& gathered);
/// Removes the entries of a few objects, as far as there are any, and their pairs; the last entries take
/// their places.
template <int D>
void drop_objects(KeptLeaf<D>& leaf, std::span<const std::uint32_t> objects);
/// Removes the entries and the pairs of all marked objects. `marks` is by object.
template <int D>
void drop_marked(KeptLeaf<D>& leaf, std::span<const std::uint8_t> marks);
/// Removes the last entries again. The pairs stay.
template <int D>
void drop_last(KeptLeaf<D>& leaf, std::size_t count);

/// Appends the pairs of each of the last entries, which are those of the view, with all entries before it.
/// `boxes`, by object, are those with which these were appended, or boxes inside of those.
template <int D>
void probe_last(KeptLeaf<D>& leaf, const LeafView<D>& last, std::span<const PackedBox<D>> boxes, Names names,
                Findings& found, PairBuffer& pairs);

}  // namespace kerf
