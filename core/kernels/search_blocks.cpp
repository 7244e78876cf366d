#include "core/kernels/search_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/search_blocks.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <bit>

#include "core/kernels/block_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// Blocks that wait on a stack. Each inner block replaces itself by eight at most, and no hierarchy has more
/// than eleven levels: eight to the power of eleven objects have no ids.
constexpr std::size_t kMostWaiting = 8 * 11 + 8;
/// Blocks that wait in a queue.
constexpr std::size_t kQueue = 256;

/// Where no order is wanted, the block that waits longest is next: it depends on nothing that the processor
/// is still about to find. When the queue is at its end, it is emptied as a stack.
struct Queue {
  HWY_INLINE bool is_empty() const { return head == tail; }
  HWY_INLINE std::uint32_t take() { return HWY_LIKELY(tail < kQueue) ? waiting[head++] : waiting[--tail]; }
  std::size_t head = 0;
  std::size_t tail = 1;
  std::uint32_t waiting[kQueue + kMostWaiting];
};

HWY_INLINE bool has_blocks(std::uint32_t item) { return (item & 1U) != 0; }

/// Makes room for the findings of a block, if it must; false ends the search.
template <class Finding>
HWY_INLINE bool take_room(FoundRoom<Finding>& room) {
  return static_cast<std::size_t>(room.limit - room.next) >= kBlockWidth || room.make_room(room);
}

/// Hands the blocks of objects to the finder that lie in what it reaches.
template <int D, class Finder>
HWY_INLINE void search(const BlockView<D>& view, Finder finder) {
  Queue queue;
  queue.waiting[0] = view.root;
  while (!queue.is_empty()) {
    const std::uint32_t item = queue.take();
    const WideBlock<D>& block = view.blocks[item >> 1U];
    if (has_blocks(item)) {
      for (std::size_t k = 0; k < kBlockWidth; k += kPart)
        queue.tail += write_items(block, k, finder.reaches(block, k), queue.waiting + queue.tail);
    } else if (take_room(finder.room)) {
      finder.take(block, (item >> 1U) * kBlockWidth);
    } else {
      return;
    }
  }
}

template <int D>
struct OverlapFinder {
  HWY_INLINE Marks reaches(const WideBlock<D>& block, std::size_t k) const { return test(block, k); }
  HWY_INLINE void take(const WideBlock<D>& block, std::size_t /*first*/) {
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

/// A block that waits, and how near it is at least.
struct Waiting {
  float key;
  std::uint32_t item;
};

/// Adds what lies in the marked lanes, so that the nearest is last.
template <int D>
HWY_INLINE std::size_t add_sorted(const WideBlock<D>& block, std::uint32_t bits, const float* keys,
                                  Waiting* waiting) {
  std::size_t size = 0;
  for (; bits != 0; bits &= bits - 1) {
    const std::uint32_t lane = first_bit(bits);
    if (block.item[lane] == WideBlock<D>::kUnused) continue;  // as far as anything can be
    const float key = keys[lane];
    std::size_t at = size++;
    for (; at > 0 && waiting[at - 1].key < key; --at) waiting[at] = waiting[at - 1];
    waiting[at] = {key, block.item[lane]};
  }
  return size;
}

template <int D, class Test>
HWY_INLINE void near_all(const BlockView<D>& view, const Test& given, NearRoom& room) {
  const TestOf<D, Test> test(given);
  Waiting waiting[kMostWaiting];
  std::size_t size = 1;
  waiting[0] = {0, view.root};
  while (size > 0) {
    const Waiting top = waiting[--size];
    if (!(top.key <= room.bound)) continue;
    const WideBlock<D>& block = view.blocks[top.item >> 1U];
    const Some bound = hn::Set(FloatTag(), room.bound);
    HWY_ALIGN float keys[kBlockWidth];
    std::uint32_t possible = 0;
    std::uint32_t sure = 0;
    const bool inner = has_blocks(top.item);
    for (std::size_t k = 0; k < kBlockWidth; k += kPart) {
      const Answer answer = test(block, k);
      hn::Store(answer.key, FloatTag(), keys + k);
      possible |= bits_of(hn::And(answer.possible, hn::Le(answer.key, bound))) << k;
      if (!inner) sure |= bits_of(test.sure_of(answer)) << k;
    }
    if (inner) {
      size += add_sorted(block, possible, keys, waiting + size);
      continue;
    }
    const std::uint32_t first = (top.item >> 1U) * kBlockWidth;
    for (; possible != 0; possible &= possible - 1) {
      const std::uint32_t lane = first_bit(possible);
      if (keys[lane] <= room.bound)
        room.bound = room.consider(room, (first + lane) * 2 + ((sure >> lane & 1U) ^ 1U));
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
