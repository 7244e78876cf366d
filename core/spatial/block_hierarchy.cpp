#include "core/spatial/block_hierarchy.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/float_mode.h"

namespace kerf {
namespace {

/// How much the bounds may grow before the hierarchy is built anew.
constexpr double kMostCost = 1.5;

template <int D>
Box<D> bounds_of(const WideBlock<D>& block) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    Scalar low = block.min[i][0];
    Scalar high = block.max[i][0];
    for (std::size_t k = 1; k < kBlockWidth; ++k) {
      low = std::min(low, block.min[i][k]);
      high = std::max(high, block.max[i][k]);
    }
    box.min[i] = low;
    box.max[i] = high;
  }
  return box;
}

/// Half the perimeter in 2D, half the surface in 3D; 0 if the box is empty.
template <int D>
double measure(const Box<D>& box) {
  std::array<double, 3> side{};
  for (int i = 0; i < D; ++i)
    side[static_cast<std::size_t>(i)] = static_cast<double>(box.max[i]) - static_cast<double>(box.min[i]);
  if (side[0] < 0) return 0;
  return D == 2 ? side[0] + side[1] : side[0] * (side[1] + side[2]) + side[1] * side[2];
}

}  // namespace

template <int D>
std::size_t BlockHierarchy<D>::bytes() const {
  return blocks_.capacity() * (sizeof(WideBlock<D>) + sizeof(std::uint32_t) + 1);
}

template <int D>
typename BlockHierarchy<D>::Update BlockHierarchy<D>::update(const ObjectTable<D>& objects) {
  const DefaultFloats floats;
  if (built_cost_ > 0 && refit(objects)) return Update::refit;
  built_cost_ = 0;  // if memory ends, the next update builds
  BlockHierarchy built;
  built.build(objects);
  *this = std::move(built);
  return Update::built;
}

/// Copies the boxes of a block's objects; returns how many are placed.
template <int D>
std::size_t BlockHierarchy<D>::take_boxes(const ObjectTable<D>& objects, std::size_t block) {
  WideBlock<D>& wide = blocks_[block];
  std::size_t placed = 0;
  for (std::size_t k = 0; k < kBlockWidth; ++k) {
    const ObjectId object{wide.item[k]};
    const bool is_placed = objects.is_placed(object);
    wide.set(k, is_placed ? objects.box(object) : WideBlock<D>::no_box());
    placed += is_placed ? 1 : 0;
  }
  return placed;
}

/// Makes every block's box in its parent that of its items.
template <int D>
void BlockHierarchy<D>::join_upwards() {
  double sum = 0;
  for (std::size_t block = blocks_.size(); block-- > 1;) {
    const Box<D> box = bounds_of(blocks_[block]);
    blocks_[above_[block] / kBlockWidth].set(above_[block] % kBlockWidth, box);
    sum += measure(box);
  }
  const double whole = blocks_.empty() ? 0 : measure(bounds_of(blocks_[0]));
  cost_ = 1 + (whole > 0 ? sum / whole : 0);
}

/// False if the hierarchy must be built instead.
template <int D>
bool BlockHierarchy<D>::refit(const ObjectTable<D>& objects) {
  std::size_t placed = 0;
  for (std::uint32_t id = 0; id < objects.bound(); ++id) placed += objects.is_placed({id}) ? 1 : 0;
  if (placed > slots_ || placed < slots_ / 2) return false;
  size_ = 0;
  for (std::size_t block = 0; block < blocks_.size(); ++block)
    if (has_objects(block)) size_ += take_boxes(objects, block);
  join_upwards();
  return size_ == placed && cost_ <= kMostCost * built_cost_;
}

template <int D>
void BlockHierarchy<D>::build(const ObjectTable<D>& objects) {
  std::vector<CenteredObject<D>> placed;
  placed.reserve(objects.size());
  for (std::uint32_t id = 0; id < objects.bound(); ++id)
    if (objects.is_placed({id})) placed.push_back({objects.box({id}).center(), id});
  blocks_.clear();
  above_.clear();
  is_inner_.clear();
  size_ = slots_ = placed.size();
  std::size_t room = kBlockWidth;
  std::size_t most_blocks = 1 + placed.size() / (kBlockWidth - 1);
  for (; room < placed.size(); room *= kBlockWidth) ++most_blocks;  // one of each level may not be full
  blocks_.reserve(most_blocks);
  above_.reserve(most_blocks);
  is_inner_.reserve(most_blocks);
  add_block(placed, room, 0);
  for (std::size_t block = 0; block < blocks_.size(); ++block)
    if (has_objects(block)) take_boxes(objects, block);
  join_upwards();
  built_cost_ = cost_;
}

/// Adds a block for these objects, below the slot `above`; full, it holds `room` of them. Returns it as an
/// item.
template <int D>
std::uint32_t BlockHierarchy<D>::add_block(std::span<CenteredObject<D>> objects, std::size_t room,
                                           std::uint32_t above) {
  const auto block = static_cast<std::uint32_t>(blocks_.size());
  const bool is_inner = room > kBlockWidth;
  WideBlock<D>& added = blocks_.emplace_back();
  for (std::size_t k = 0; k < kBlockWidth; ++k) {
    added.set(k, WideBlock<D>::no_box());
    added.item[k] = !is_inner && k < objects.size() ? objects[k].object : WideBlock<D>::kUnused;
  }
  above_.push_back(above);
  is_inner_.push_back(is_inner ? 1 : 0);
  const std::size_t part = room / kBlockWidth;
  if (is_inner) add_children(objects, part, (objects.size() + part - 1) / part, block * kBlockWidth);
  return block * 2 + (is_inner ? 1 : 0);
}

/// Divides the objects between children that hold `room` each, and all but the last of them are full.
template <int D>
void BlockHierarchy<D>::add_children(std::span<CenteredObject<D>> objects, std::size_t room,
                                     std::size_t children, std::uint32_t slot) {
  if (children == 1) {
    const std::uint32_t item = add_block(objects, room, slot);
    blocks_[slot / kBlockWidth].item[slot % kBlockWidth] = item;
    return;
  }
  const std::size_t left = children / 2;
  divide_objects<D>(objects, left * room, longest_axis<D>(objects));
  add_children(objects.first(left * room), room, left, slot);
  add_children(objects.subspan(left * room), room, children - left, slot + static_cast<std::uint32_t>(left));
}

template class BlockHierarchy<2>;
template class BlockHierarchy<3>;

}  // namespace kerf
