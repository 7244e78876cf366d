#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/ids.h"

namespace kerf {

/// A list of pairs for kernels that write whole vectors past its end and then commit the valid ones.
class PairList {
 public:
  void clear() { size_ = 0; }
  [[nodiscard]] std::span<const Pair> pairs() const { return {room_.data(), size_}; }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Where the next pair is written, with room for at least `count` more and a vector of any width.
  [[nodiscard]] Pair* reserve(std::size_t count) {
    constexpr std::size_t kWidestVector = 64;
    if (room_.size() < size_ + count + kWidestVector) room_.resize(2 * (size_ + count + kWidestVector));
    return room_.data() + size_;
  }
  /// Makes all pairs before `end` valid. `end` lies in the room reserved last.
  void commit(const Pair* end) { size_ = static_cast<std::size_t>(end - room_.data()); }
  void add(const Pair& pair) {
    *reserve(1) = pair;
    ++size_;
  }

 private:
  std::vector<Pair> room_;  ///< its size is the room, so that no step initialises what it will overwrite
  std::size_t size_ = 0;
};

}  // namespace kerf
