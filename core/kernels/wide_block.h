#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/geometry/box.h"

namespace kerf {

inline constexpr std::size_t kBlockWidth = 16;

/// Boxes side by side, so that one or two vector instructions test all of them, and what each of them bounds:
/// an object, or another block.
template <int D>
struct alignas(64) WideBlock {
  static constexpr std::uint32_t kUnused = UINT32_MAX;

  Scalar min[D][kBlockWidth];
  Scalar max[D][kBlockWidth];
  std::uint32_t
      item[kBlockWidth];  ///< the object's id, or twice the block's index, plus 1 if its items are blocks

  /// The box of an empty slot, from infinity to minus infinity: it overlaps none, of whatever floats.
  static Box<D> no_box() {
    constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
    Box<D> box;
    box.min.value.fill(kInfinity);
    box.max.value.fill(-kInfinity);
    return box;
  }
  [[nodiscard]] Box<D> box(std::size_t k) const {
    Box<D> box;
    for (int i = 0; i < D; ++i) {
      box.min[i] = min[i][k];
      box.max[i] = max[i][k];
    }
    return box;
  }
  [[nodiscard]] bool is_empty(std::size_t k) const { return min[0][k] > max[0][k]; }
  void set(std::size_t k, const Box<D>& box) {
    for (int i = 0; i < D; ++i) {
      min[i][k] = box.min[i];
      max[i][k] = box.max[i];
    }
  }
};

/// A hierarchy of blocks.
template <int D>
struct BlockView {
  const WideBlock<D>* blocks = nullptr;
  std::uint32_t root = 0;  ///< as an item of a block
};

}  // namespace kerf
