#include "core/kernels/clumps.h"

#include <algorithm>
#include <bit>

#include "core/kernels/sweep_tuning.h"

namespace kerf {
namespace {

template <int D>
void append(const LeafView<D>& from, std::uint32_t place, DepthMask apart, LeafView<D>& part) {
  part.boxes.push_back(from.boxes[place]);
  part.objects.push_back(from.objects[place]);
  part.apart.push_back(from.apart[place] | apart);
}

bool is_long(const OrderedBytes& bytes, std::size_t k) {
  return bytes.ends[k] - bytes.begins[k] >= tuning::kLongBox;
}

/// A bit that no mask has; 0 if each is in use.
DepthMask free_bit(std::span<const DepthMask> masks) {
  DepthMask all = 0;
  for (const DepthMask mask : masks) all |= mask;
  return ~all == 0 ? 0 : std::bit_floor(~all);
}

}  // namespace

template <int D>
LeafView<D>& Clumps<D>::add_part() {
  if (count_ == parts_.size()) parts_.emplace_back();
  LeafView<D>& part = parts_[count_++];
  part.boxes.clear();
  part.objects.clear();
  part.apart.clear();
  return part;
}

/// Ends a part behind each gap. Small clumps share one, since each part has a cost of its own.
template <int D>
void Clumps<D>::list_cuts(const OrderedBytes& bytes) {
  const std::size_t n = bytes.order.size();
  cuts_.clear();
  long_.clear();
  std::size_t begin = 0;    // of the clump
  std::size_t size = 0;     // entries of the clump that are not long
  std::size_t waiting = 0;  // those of small clumps before it
  int reach = -1;
  const auto end_clump = [&](std::size_t end) {
    if (size >= tuning::kLeastClump && waiting > 0) cuts_.push_back(static_cast<std::uint32_t>(begin));
    waiting = size >= tuning::kLeastClump ? size : waiting + size;
    if (waiting >= tuning::kLeastClump) {
      cuts_.push_back(static_cast<std::uint32_t>(end));
      waiting = 0;
    }
    begin = end;
    size = 0;
  };
  for (std::size_t k = 0; k < n; ++k) {
    if (is_long(bytes, k)) {
      long_.push_back(static_cast<std::uint32_t>(k));
      if (long_.size() > tuning::kMostLong) return;
      continue;
    }
    if (bytes.begins[k] > reach + bytes.disorder) end_clump(k);
    reach = std::max<int>(reach, bytes.ends[k]);
    ++size;
  }
  end_clump(n);
  if (waiting > 0) cuts_.push_back(static_cast<std::uint32_t>(n));
}

/// Whether the parts are worth a sweep each: not too small in the mean, and none has nearly all entries.
template <int D>
bool Clumps<D>::is_divided() const {
  if (cuts_.size() < 2) return false;
  const std::size_t n = cuts_.back();
  std::uint32_t begin = 0;
  std::uint32_t largest = 0;
  for (const std::uint32_t end : cuts_) {
    largest = std::max(largest, end - begin);
    begin = end;
  }
  return 4 * largest <= 3 * n && cuts_.size() * tuning::kLeastMeanClump <= n;
}

/// Pairs of two entries that are in each part are this part's if it is the first: elsewhere they share a bit.
template <int D>
bool Clumps<D>::divide(const LeafView<D>& leaf, const OrderedBytes& bytes) {
  list_cuts(bytes);
  if (long_.size() > tuning::kMostLong || !is_divided()) return false;
  const DepthMask seen = long_.size() > 1 ? free_bit(leaf.apart) : 1;
  if (seen == 0) return false;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : cuts_) {
    LeafView<D>& part = add_part();
    for (std::uint32_t k = begin; k < end; ++k)
      if (!is_long(bytes, k)) append(leaf, bytes.order[k], 0, part);
    const DepthMask shared = begin == 0 || long_.size() == 1 ? 0 : seen;
    for (const std::uint32_t k : long_) append(leaf, bytes.order[k], shared, part);
    begin = end;
  }
  return true;
}

template class Clumps<2>;
template class Clumps<3>;

}  // namespace kerf
