#include "frames/bench/step_block.h"

#include <algorithm>
#include <utility>

namespace kerf {
namespace {

/// Places one array after the other, each on a cache line of its own.
class Layout {
 public:
  template <class T>
  std::size_t place(std::size_t count) {
    constexpr std::size_t kLine = 64;
    return std::exchange(end_, (end_ + count * sizeof(T) + kLine - 1) / kLine * kLine);
  }
  [[nodiscard]] std::size_t size() const { return end_; }

 private:
  std::size_t end_ = 0;
};

/// SplitMix64's finaliser: a sum of well mixed numbers distinguishes sets.
std::uint64_t mixed(const Pair& pair) {
  std::uint64_t z = (std::uint64_t{pair.a.value} << 32U) | pair.b.value;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

}  // namespace

Truth truth_of(std::span<const Pair> pairs) {
  Truth truth{pairs.size(), 0};
  for (const Pair& pair : pairs) truth.checksum += mixed(make_pair(pair.a, pair.b));
  return truth;
}

template <int D>
StepBlock<D>::StepBlock(const Motion<D>& motion, std::uint32_t capacity)
    : capacity_(capacity),
      objects_(static_cast<std::uint32_t>(motion.boxes().size())),
      moving_(motion.moving()),
      most_changes_(motion.most_changes()),
      all_move_(motion.all_move()),
      memory_([&] {
        // A fixed object may be given another box, too.
        const std::size_t ids = all_move_ ? moving_ : std::size_t{capacity_} * objects_;
        Layout layout;
        layout.place<Header>(1);
        truths_at_ = layout.place<Truth>(capacity_);
        counts_at_ = layout.place<Counts>(capacity_);
        ids_at_ = layout.place<ObjectId>(ids);
        boxes_at_ = layout.place<Box<D>>(std::size_t{capacity_} * objects_);
        moved_at_ = layout.place<Box<D>>(all_move_ ? 0 : ids);
        changes_at_ = layout.place<ObjectId>(std::size_t{capacity_} * most_changes_);
        return layout.size();
      }()) {
  if (!all_move_) return;
  for (std::uint32_t k = 0; k < moving_; ++k) ids(0)[k] = {k};
}

template <int D>
Box<D>* StepBlock<D>::slot(std::uint32_t step) const {
  return at<Box<D>>(boxes_at_) + std::size_t{step} * objects_;
}

template <int D>
Box<D>* StepBlock<D>::moved_slot(std::uint32_t step) const {
  return at<Box<D>>(moved_at_) + std::size_t{step} * objects_;
}

template <int D>
ObjectId* StepBlock<D>::ids(std::uint32_t step) const {
  return at<ObjectId>(ids_at_) + (all_move_ ? 0 : std::size_t{step} * objects_);
}

template <int D>
ObjectId* StepBlock<D>::changes(std::uint32_t step) const {
  return at<ObjectId>(changes_at_) + std::size_t{step} * most_changes_;
}

template <int D>
void StepBlock<D>::add(const Motion<D>& motion) {
  const std::uint32_t step = header().steps++;
  std::copy(motion.boxes().begin(), motion.boxes().end(), slot(step));
  if (all_move_) return;
  const auto size = [](std::span<const ObjectId> list) { return static_cast<std::uint32_t>(list.size()); };
  counts(step) = {size(motion.moved()), size(motion.removed()), size(motion.inserted())};
  ObjectId* const came = std::copy(motion.removed().begin(), motion.removed().end(), changes(step));
  std::copy(motion.inserted().begin(), motion.inserted().end(), came);
  std::copy(motion.moved().begin(), motion.moved().end(), ids(step));
  Box<D>* out = moved_slot(step);
  for (const ObjectId object : motion.moved()) *out++ = motion.boxes()[object.index()];
}

template <int D>
std::span<const Box<D>> StepBlock<D>::boxes(std::uint32_t step) const {
  return {slot(step), objects_};
}

template <int D>
std::span<const ObjectId> StepBlock<D>::moved(std::uint32_t step) const {
  return {ids(step), all_move_ ? moving_ : counts(step).moved};
}

template <int D>
std::span<const Box<D>> StepBlock<D>::moved_boxes(std::uint32_t step) const {
  return all_move_ ? boxes(step).first(moving_)
                   : std::span<const Box<D>>(moved_slot(step), counts(step).moved);
}

template <int D>
std::span<const ObjectId> StepBlock<D>::removed(std::uint32_t step) const {
  return {changes(step), counts(step).removed};
}

template <int D>
std::span<const ObjectId> StepBlock<D>::inserted(std::uint32_t step) const {
  return {changes(step) + counts(step).removed, counts(step).inserted};
}

template class StepBlock<2>;
template class StepBlock<3>;

}  // namespace kerf
