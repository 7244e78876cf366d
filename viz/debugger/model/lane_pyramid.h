#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace kerf {

/// The least and the greatest of some values; absent if there is none.
struct LaneRange {
  float least = std::numeric_limits<float>::infinity();
  float greatest = -std::numeric_limits<float>::infinity();

  [[nodiscard]] bool is_absent() const { return least > greatest; }
  void add(const LaneRange& other) {
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
  }
  friend bool operator==(const LaneRange&, const LaneRange&) = default;
};

/// The least and greatest values of any stretch of a lane, from few blocks: eight values, eight of those
/// blocks, and so on. Values that are not finite are absent.
class LanePyramid {
 public:
  static constexpr std::size_t kBlock = 8;

  LanePyramid() = default;
  explicit LanePyramid(std::span<const float> values);

  /// Of values `first` to `last` - 1.
  [[nodiscard]] LaneRange range(std::size_t first, std::size_t last) const;
  /// Calls `visit` with each block that `range` reads: fewer than 2 * kBlock a level.
  template <class Visit>
  void for_each_block(std::size_t first, std::size_t last, Visit visit) const {
    for (const std::vector<LaneRange>& blocks : levels_) {
      last = std::min(last, blocks.size());
      const bool is_top = blocks.size() == 1;
      // A level's last block of blocks may be shorter, so that it is whole where the level ends.
      const auto is_whole = [&](std::size_t end) {
        return !is_top && (end % kBlock == 0 || end == blocks.size());
      };
      for (; first < last && first % kBlock != 0; ++first) visit(blocks[first]);
      for (; first < last && !is_whole(last); --last) visit(blocks[last - 1]);
      if (first >= last) return;
      first /= kBlock;
      last = (last + kBlock - 1) / kBlock;
    }
  }

 private:
  std::vector<std::vector<LaneRange>> levels_;  ///< the values, then blocks of them, up to a single one
};

}  // namespace kerf
