#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "core/kernels/leaf_view.h"

namespace kerf {

/// A leaf's entries in the order of their beginnings along an axis, and these as bytes.
struct OrderedBytes {
  std::span<const std::uint32_t> order;  ///< places in the leaf
  const std::uint8_t* begins;
  const std::uint8_t* ends;
  int disorder = 0;  ///< a beginning is at most so many bytes less than one before it
};

/// Divides leaves whose boxes lie in clumps far from one another, as islands do: each part is swept by
/// itself, with bytes that fit its own size. Few objects that reach across the gaps, as grounds do, are in
/// each part.
template <int D>
class Clumps {
 public:
  /// No part waits.
  void clear() { count_ = next_ = 0; }
  /// Divides a leaf, or a part of one, at the gaps that only long boxes reach across. Returns false, and adds
  /// no part, if there is no gap or too many boxes are long.
  bool divide(const LeafView<D>& leaf, const OrderedBytes& bytes);
  /// The next part that waits; null if none does.
  [[nodiscard]] const LeafView<D>* next() { return next_ < count_ ? &parts_[next_++] : nullptr; }

 private:
  void list_cuts(const OrderedBytes& bytes);
  [[nodiscard]] bool is_divided() const;
  LeafView<D>& add_part();

  std::deque<LeafView<D>> parts_;  ///< a part is divided while others are added
  std::size_t count_ = 0;
  std::size_t next_ = 0;
  std::vector<std::uint32_t> cuts_;  ///< where parts end in the order
  std::vector<std::uint32_t> long_;  ///< places in the order of entries that reach across
};

}  // namespace kerf
