#include "core/kernels/search_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/search_blocks.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <bit>

#include "core/kernels/block_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// No hierarchy has more: more objects than the width to the power of eight have no ids.
constexpr std::size_t kMostLevels = 8;
static_assert(kBlockWidth == 16);
/// Blocks that wait on a stack. Each inner block replaces itself by a width of them at most.
constexpr std::size_t kMostWaiting = kBlockWidth * (kMostLevels + 1);
/// Blocks that wait in a queue.
constexpr std::size_t kQueue = 256;

/// Where no order is wanted, the block that waits longest is next: it depends on nothing that the processor
/// is still about to find. When the queue is at its end, it is emptied as a stack.
struct Queue {
  HWY_INLINE bool is_empty() const { return head == tail; }
  HWY_INLINE std::uint32_t take() { return HWY_LIKELY(tail < kQueue) ? waiting[head++] : waiting[--tail]; }
  std::uint32_t* const waiting;  ///< elsewhere, so that the compiler keeps the others in registers
  std::size_t head = 0;
  std::size_t tail = 0;
};

HWY_INLINE bool has_blocks(std::uint32_t item) { return (item & 1U) != 0; }

/// Makes room for the findings of a block, if it must; false ends the search.
template <class Finding>
HWY_INLINE bool take_room(FoundRoom<Finding>& room) {
  return static_cast<std::size_t>(room.limit - room.next) >= kBlockWidth || room.make_room(room);
}

/// Lets all items wait that the finder reaches. Returns their lanes.
template <int D, class Finder>
HWY_INLINE std::uint32_t add_reached(const WideBlock<D>& block, const Finder& finder, Queue& queue) {
  std::uint32_t lanes = 0;
  HWY_DEFAULT_UNROLL
  for (std::size_t k = 0; k < kBlockWidth; k += kPart) {
    const Marks reached = finder.reaches(block, k);
    lanes |= bits_of(reached) << k;
    queue.tail += write_items(block, k, reached, queue.waiting + queue.tail);
  }
  return lanes;
}

/// Hands the blocks of objects to the finder that lie in what it reaches.
template <int D, class Finder>
HWY_INLINE void search(const BlockView<D>& view, Finder finder) {
  std::uint32_t waiting[kQueue + kMostWaiting];
  Queue queue{waiting};
  std::uint32_t item = view.root;
  for (;;) {
    const WideBlock<D>& block = view.blocks[item >> 1U];
    if (has_blocks(item)) {
      const bool none_waited = queue.is_empty();
      const std::uint32_t lanes = add_reached(block, finder, queue);
      if (HWY_UNLIKELY(none_waited && lanes != 0)) {  // straight from its lane it is there sooner
        ++queue.head;
        item = block.item[first_bit(lanes)];
        continue;
      }
    } else if (take_room(finder.room)) {
      finder.take(block, (item >> 1U) * kBlockWidth);
    } else {
      return;
    }
    if (queue.is_empty()) return;
    item = queue.take();
  }
}

template <int D>
struct OverlapFinder {
  HWY_INLINE Marks reaches(const WideBlock<D>& block, std::size_t k) const { return test(block, k); }
  HWY_INLINE void take(const WideBlock<D>& block, std::size_t /*first*/) {
    HWY_DEFAULT_UNROLL
    for (std::size_t k = 0; k < kBlockWidth; k += kPart)
      room.next += write_items(block, k, test(block, k), room.next);
  }
  const OverlapTest<D> test;
  FoundRoom<std::uint32_t>& room;
};

template <int D, class Test>
struct PossibleFinder {
  HWY_INLINE Marks reaches(const WideBlock<D>& block, std::size_t k) const { return test(block, k).possible; }
  HWY_INLINE void take(const WideBlock<D>& block, std::size_t first) {
    HWY_DEFAULT_UNROLL
    for (std::size_t k = 0; k < kBlockWidth; k += kPart) {
      const Answer answer = test(block, k);
      const Marks sure = hn::And(answer.possible, test.sure_of(answer));
      room.next += write_items(block, k, sure, room.next);
      for (std::uint32_t bits = bits_of(hn::AndNot(sure, answer.possible)); bits != 0; bits &= bits - 1) {
        const std::size_t lane = k + first_bit(bits);
        if (room.confirm(room, static_cast<std::uint32_t>(first + lane))) *room.next++ = block.item[lane];
      }
    }
  }
  const TestOf<D, Test> test;
  FoundRoom<std::uint32_t>& room;
};

/// The t of boxes that are met, as `entry_of` has it.
template <int D>
HWY_INLINE void store_times(const CastTest<D>& cast, const WideBlock<D>& block, std::size_t k, float* times) {
  const hn::FixedTag<double, kPart / 2> wide;
  const hn::FixedTag<float, kPart / 2> narrow;
  for (std::size_t half = 0; half < kPart; half += kPart / 2) {
    auto latest = hn::Zero(wide);
    for (std::size_t i = 0; i < D; ++i) {
      if (cast.direction[i] == 0) continue;
      const float* const ends = cast.direction[i] < 0 ? block.max[i] : block.min[i];
      const auto end = hn::PromoteTo(wide, hn::LoadU(narrow, ends + k + half));
      const auto ahead = hn::Sub(end, hn::Set(wide, static_cast<double>(cast.start[i])));
      latest = hn::Max(latest, hn::Div(ahead, hn::Set(wide, cast.direction[i])));
    }
    latest = hn::Add(hn::Min(latest, hn::Set(wide, FLT_MAX)), hn::Zero(wide));  // no zero is negative
    hn::StoreU(hn::DemoteTo(narrow, latest), narrow, times + half);
  }
}

template <int D>
struct HitFinder {
  HWY_INLINE Marks reaches(const WideBlock<D>& block, std::size_t k) const { return test(block, k).possible; }
  HWY_INLINE void take(const WideBlock<D>& block, std::size_t first) {
    HWY_DEFAULT_UNROLL
    for (std::size_t k = 0; k < kBlockWidth; k += kPart) {
      const Answer answer = test(block, k);
      std::uint32_t bits = bits_of(answer.possible);
      if (bits == 0) continue;
      const std::uint32_t sure = bits_of(test.sure_of(answer));
      float times[kPart];
      store_times(test.given, block, k, times);
      for (; bits != 0; bits &= bits - 1) {
        const std::uint32_t lane = first_bit(bits);
        if ((sure >> lane & 1U) == 0 && !room.confirm(room, static_cast<std::uint32_t>(first + k) + lane))
          continue;
        *room.next++ = HitNumber{std::bit_cast<std::uint32_t>(times[lane])} << 32U | block.item[k + lane];
      }
    }
  }
  const TestOf<D, CastTest<D>> test;
  FoundRoom<HitNumber>& room;
};

/// How near the items of a block are at least, as numbers that are ordered as the keys are and end in the
/// lanes: their minimum is the nearest item, and no branch has to guess it.
class Order {
 public:
  Order() = default;
  /// Of all items that are possible; `sure` are those whose boxes need no look.
  template <int D, class Test>
  HWY_INLINE Order(const WideBlock<D>& block, const Test& test, std::uint32_t& sure) {
    sure = 0;
    HWY_DEFAULT_UNROLL
    for (std::size_t k = 0; k < kBlockWidth; k += kPart) {
      const Answer answer = test(block, k);
      sure |= bits_of(test.sure_of(answer)) << k;
      const auto key = hn::And(hn::BitCast(RankTag(), answer.key), hn::Set(RankTag(), kKeyBits));
      const auto rank = hn::Or(key, hn::Iota(RankTag(), static_cast<std::int32_t>(k)));
      part_[k / kPart] = hn::IfThenElse(hn::RebindMask(RankTag(), answer.possible), rank, none());
    }
  }
  /// The rank of the nearest one; if there is none, greater than any that is within a bound.
  [[nodiscard]] HWY_INLINE std::int32_t nearest() const {
    Ranks least = part_[0];
    for (const Ranks& part : part_) least = hn::Min(least, part);
    return hn::GetLane(hn::MinOfLanes(RankTag(), least));
  }
  HWY_INLINE void remove(std::int32_t rank) {
    for (Ranks& part : part_) part = hn::IfThenElse(hn::Eq(part, hn::Set(RankTag(), rank)), none(), part);
  }
  static HWY_INLINE std::uint32_t lane_of(std::int32_t rank) {
    return static_cast<std::uint32_t>(rank) % kBlockWidth;
  }
  static HWY_INLINE std::int32_t last_within(float bound) {
    return std::bit_cast<std::int32_t>(bound + 0.0F) | kLaneBits;  // the sum is no negative zero
  }

 private:
  static constexpr std::int32_t kLaneBits = kBlockWidth - 1;
  static constexpr std::int32_t kKeyBits = ~kLaneBits;
  using RankTag = hn::FixedTag<std::int32_t, kPart>;
  using Ranks = hn::Vec<RankTag>;
  static HWY_INLINE Ranks none() { return hn::Set(RankTag(), INT32_MAX); }

  Ranks part_[kBlockWidth / kPart];
};

/// Offers the objects of a block, the nearest first.
template <int D, class Test>
HWY_INLINE void consider_all(const BlockView<D>& view, std::uint32_t item, const Test& test, NearRoom& room) {
  std::uint32_t sure = 0;
  Order order(view.blocks[item >> 1U], test, sure);
  const std::uint32_t first = (item >> 1U) * kBlockWidth;
  for (;;) {
    const std::int32_t rank = order.nearest();
    if (rank > Order::last_within(room.bound)) return;
    order.remove(rank);
    const std::uint32_t lane = Order::lane_of(rank);
    room.bound = room.consider(room, (first + lane) * 2 + ((sure >> lane & 1U) ^ 1U));
  }
}

/// Inner blocks on the way to the present one, with what is left of them.
template <int D>
class Path {
 public:
  /// Adds a block; returns its nearest item, or if none is within the bound, the next one of the others.
  template <class Test>
  HWY_INLINE std::uint32_t enter(const WideBlock<D>& block, const Test& test, const NearRoom& room) {
    std::uint32_t unused = 0;
    Order left(block, test, unused);
    const std::int32_t rank = left.nearest();  // straight from registers it is there sooner
    if (rank > Order::last_within(room.bound)) return next(room);
    left.remove(rank);
    levels_[size_++] = {left, block.item};
    const std::uint32_t item = block.item[Order::lane_of(rank)];
    return HWY_LIKELY(item != WideBlock<D>::kUnused) ? item : next(room);
  }
  /// The next item that may be within the bound, or kUnused at the end.
  HWY_INLINE std::uint32_t next(const NearRoom& room) {
    while (size_ > 0) {
      Level& level = levels_[size_ - 1];
      const std::int32_t rank = level.left.nearest();
      if (rank > Order::last_within(room.bound)) {
        --size_;
        continue;
      }
      level.left.remove(rank);
      const std::uint32_t item = level.items[Order::lane_of(rank)];
      if (HWY_LIKELY(item != WideBlock<D>::kUnused)) return item;  // its box is as far as anything can be
    }
    return WideBlock<D>::kUnused;
  }

 private:
  struct Level {
    Order left;
    const std::uint32_t* items;
  };
  Level levels_[kMostLevels];
  std::size_t size_ = 0;
};

template <int D, class Test>
HWY_INLINE void near_all(const BlockView<D>& view, const Test& given, NearRoom& room) {
  const TestOf<D, Test> test(given);
  Path<D> path;
  for (std::uint32_t item = view.root; item != WideBlock<D>::kUnused;) {
    if (has_blocks(item)) {
      item = path.enter(view.blocks[item >> 1U], test, room);
    } else {
      consider_all(view, item, test, room);
      item = path.next(room);
    }
  }
}

#define KERF_KERNELS(D)                                                                                      \
  void overlaps_##D(const BlockView<D>& view, const Box<D>& box, FoundRoom<std::uint32_t>& room) {           \
    search(view, OverlapFinder<D>{OverlapTest<D>(box), room});                                               \
  }                                                                                                          \
  void casts_##D(const BlockView<D>& view, const CastTest<D>& test, FoundRoom<std::uint32_t>& room) {        \
    search(view, PossibleFinder<D, CastTest<D>>{TestOf<D, CastTest<D>>(test), room});                        \
  }                                                                                                          \
  void balls_##D(const BlockView<D>& view, const BallTest<D>& test, FoundRoom<std::uint32_t>& room) {        \
    search(view, PossibleFinder<D, BallTest<D>>{TestOf<D, BallTest<D>>(test), room});                        \
  }                                                                                                          \
  void spaces_##D(const BlockView<D>& view, const HalfSpacesTest<D>& test, FoundRoom<std::uint32_t>& room) { \
    search(view, PossibleFinder<D, HalfSpacesTest<D>>{TestOf<D, HalfSpacesTest<D>>(test), room});            \
  }                                                                                                          \
  void hits_##D(const BlockView<D>& view, const CastTest<D>& test, FoundRoom<HitNumber>& room) {             \
    search(view, HitFinder<D>{TestOf<D, CastTest<D>>(test), room});                                          \
  }                                                                                                          \
  void near_casts_##D(const BlockView<D>& view, const CastTest<D>& test, NearRoom& room) {                   \
    near_all<D>(view, test, room);                                                                           \
  }                                                                                                          \
  void near_balls_##D(const BlockView<D>& view, const BallTest<D>& test, NearRoom& room) {                   \
    near_all<D>(view, test, room);                                                                           \
  }
KERF_KERNELS(2)
KERF_KERNELS(3)
#undef KERF_KERNELS

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {

#define KERF_EXPORT(D)                                                                                    \
  HWY_EXPORT(overlaps_##D);                                                                               \
  HWY_EXPORT(casts_##D);                                                                                  \
  HWY_EXPORT(balls_##D);                                                                                  \
  HWY_EXPORT(spaces_##D);                                                                                 \
  HWY_EXPORT(hits_##D);                                                                                   \
  HWY_EXPORT(near_casts_##D);                                                                             \
  HWY_EXPORT(near_balls_##D);                                                                             \
  template <>                                                                                             \
  void find_overlaps<D>(const BlockView<D>& view, const Box<D>& region, FoundRoom<std::uint32_t>& room) { \
    HWY_DYNAMIC_DISPATCH(overlaps_##D)(view, region, room);                                               \
  }                                                                                                       \
  template <>                                                                                             \
  void find_possible<D, CastTest<D>>(const BlockView<D>& view, const CastTest<D>& test,                   \
                                     FoundRoom<std::uint32_t>& room) {                                    \
    HWY_DYNAMIC_DISPATCH(casts_##D)(view, test, room);                                                    \
  }                                                                                                       \
  template <>                                                                                             \
  void find_possible<D, BallTest<D>>(const BlockView<D>& view, const BallTest<D>& test,                   \
                                     FoundRoom<std::uint32_t>& room) {                                    \
    HWY_DYNAMIC_DISPATCH(balls_##D)(view, test, room);                                                    \
  }                                                                                                       \
  template <>                                                                                             \
  void find_possible<D, HalfSpacesTest<D>>(const BlockView<D>& view, const HalfSpacesTest<D>& test,       \
                                           FoundRoom<std::uint32_t>& room) {                              \
    HWY_DYNAMIC_DISPATCH(spaces_##D)(view, test, room);                                                   \
  }                                                                                                       \
  template <>                                                                                             \
  void find_hits<D>(const BlockView<D>& view, const CastTest<D>& test, FoundRoom<HitNumber>& room) {      \
    HWY_DYNAMIC_DISPATCH(hits_##D)(view, test, room);                                                     \
  }                                                                                                       \
  template <>                                                                                             \
  void find_near<D, CastTest<D>>(const BlockView<D>& view, const CastTest<D>& test, NearRoom& room) {     \
    HWY_DYNAMIC_DISPATCH(near_casts_##D)(view, test, room);                                               \
  }                                                                                                       \
  template <>                                                                                             \
  void find_near<D, BallTest<D>>(const BlockView<D>& view, const BallTest<D>& test, NearRoom& room) {     \
    HWY_DYNAMIC_DISPATCH(near_balls_##D)(view, test, room);                                               \
  }
KERF_EXPORT(2)
KERF_EXPORT(3)
#undef KERF_EXPORT

}  // namespace kerf
#endif
