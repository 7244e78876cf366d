#include "core/kernels/move_boxes.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/move_boxes.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/packed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

constexpr std::size_t kBlock = 8;

/// Whether the ids of a block are consecutive.
HWY_INLINE bool are_consecutive(const ObjectId* block) {
  const hn::FixedTag<std::uint32_t, 4> four;
  const std::uint32_t* const numbers = &block->value;
  const auto expected = hn::Add(hn::Set(four, *numbers), hn::Iota(four, 0));
  const auto differ = hn::Or(hn::Xor(hn::LoadU(four, numbers), expected),
                             hn::Xor(hn::LoadU(four, numbers + 4), hn::Add(expected, hn::Set(four, 4))));
  return hn::AllTrue(four, hn::Eq(differ, hn::Zero(four)));
}

/// The pending flags of the objects of a block, a byte for each.
HWY_INLINE std::uint64_t flags_of_block(const ObjectFlags* flags) {
  std::uint64_t of_all = 0;
  static_assert(sizeof(of_all) == kBlock);
  std::memcpy(&of_all, flags, kBlock);
  return of_all;
}

/// Marks the lanes in which a is not at most b.
template <int D, int Boxes>
HWY_INLINE void mark_beyond(const Packed<D, Boxes>& a, const Packed<D, Boxes>& b, Packed<D, Boxes>& marked) {
  for (std::size_t k = 0; k < marked.kParts; ++k)
    marked.part[k] = hn::Or(marked.part[k], beyond(a.part[k], b.part[k]));
}

/// Marks the lanes in which a box that filled its fat box no longer does.
template <int D, int Boxes>
HWY_INLINE void mark_shrinking(const Packed<D, Boxes>& before, const Packed<D, Boxes>& now,
                               const Packed<D, Boxes>& fat, Packed<D, Boxes>& marked) {
  for (std::size_t k = 0; k < marked.kParts; ++k) {
    const auto shrinks = hn::AndNot(beyond(before.part[k], fat.part[k]), beyond(now.part[k], fat.part[k]));
    marked.part[k] = hn::Or(marked.part[k], shrinks);
  }
}

template <int D, int Boxes>
HWY_INLINE bool none(const Packed<D, Boxes>& marked) {
  auto any = marked.part[0];
  for (std::size_t k = 1; k < marked.kParts; ++k) any = hn::Or(any, marked.part[k]);
  return nowhere(any);
}

/// Clears the request of an object that has any flag.
template <int D>
HWY_INLINE void mute(ObjectFlags flags, Packed<D>& asks) {
  const typename Packed<D>::Lanes lanes;
  const hn::RebindToSigned<decltype(lanes)> words;
  const auto heard = hn::BitCast(lanes, hn::Set(words, flags == 0 ? -1 : 0));
  for (auto& part : asks.part) part = hn::And(part, heard);
}

/// Takes the boxes of the block of neighbours that begins at the k-th request, if their answers are alike:
/// with fat boxes no object is reported as changed, without them all are. One branch decides. `Unrequested`:
/// some objects may have that flag.
template <bool Fat, bool Unrequested, int D>
HWY_INLINE bool take_alike(const MoveRequest<D>& request, std::size_t k, MoveAnswer& answer) {
  constexpr int kBoxes = D == 2 && !Unrequested ? 2 : 1;
  using Some = Packed<D, kBoxes>;
  const std::size_t first = request.objects[k].index();
  Some boxes[kBlock / kBoxes];
  Some marked = all_lanes<D, kBoxes>(0);
  for (std::size_t i = 0; i < kBlock; i += kBoxes) {
    Some& now = boxes[i / kBoxes];
    now = pack<kBoxes>(request.boxes[k + i]);
    if constexpr (Fat) {
      Some asks = all_lanes<D, kBoxes>(0);
      const Some fat = load<kBoxes>(request.fat[first + i]);  // finite, so that it holds nothing that is not
      mark_beyond(fat, now, asks);
      mark_shrinking(load<kBoxes>(request.latest[first + i]), now, fat, asks);
      if constexpr (Unrequested) mute<D>(request.flags[first + i], asks);
      for (std::size_t part = 0; part < marked.kParts; ++part)
        marked.part[part] = hn::Or(marked.part[part], asks.part[part]);
    }
    if constexpr (!Fat || Unrequested) mark_beyond(all_lanes<D, kBoxes>(-FLT_MAX), now, marked);
    mark_beyond(now, turned(now), marked);
  }
  if (!none(marked)) return false;
  for (std::size_t i = 0; i < kBlock; i += kBoxes) store(boxes[i / kBoxes], request.latest[first + i]);
  if constexpr (!Fat) {
    std::copy_n(request.objects.data() + k, kBlock, request.changed + answer.changed);
    std::memset(request.flags.data() + first, flag::kChanged, kBlock);
    answer.changed += kBlock;
  }
  return true;
}

/// The same for any block. Most can be taken.
template <bool Fat, int D>
HWY_INLINE bool take_block(const MoveRequest<D>& request, std::size_t k, MoveAnswer& answer) {
  constexpr std::uint64_t kAllUnrequested = flag::kUnrequested * 0x0101010101010101U;
  const std::size_t first = request.objects[k].index();
  if (!are_consecutive(request.objects.data() + k) || first + kBlock > request.flags.size()) return false;
  const std::uint64_t flags = flags_of_block(request.flags.data() + first);
  if (flags == 0) return take_alike<Fat, false>(request, k, answer);
  if constexpr (Fat) {
    if ((flags & ~kAllUnrequested) == 0) return take_alike<Fat, true>(request, k, answer);
  }
  return false;
}

/// One request.
template <bool Fat, int D>
HWY_INLINE void take(const MoveRequest<D>& request, std::size_t k, MoveAnswer& answer) {
  const ObjectId object = request.objects[k];
  const std::size_t id = object.index();
  const Packed<D> box = pack(request.boxes[k]);
  ObjectFlags* const flags = request.flags.data();
  if (id >= request.flags.size() || (flags[id] & ~flag::kUnrequested) != 0 || !is_valid<D>(box)) {
    if (id < request.flags.size()) flags[id] |= flag::kDeferred;
    request.left_over[answer.left_over++] = static_cast<std::uint32_t>(k);
    return;
  }
  bool asks = true;
  if constexpr (Fat) {
    const Packed<D> fat = load(request.fat[id]);
    const bool filled = at_most<D>(load(request.latest[id]), fat);  // held by the fat box, it is as large
    const bool fills = at_most<D>(box, fat);
    asks = flags[id] == 0 && (!at_most<D>(fat, box) || (filled && !fills));
    request.before[answer.changed] = request.latest[id];
  }
  request.changed[answer.changed] = object;
  answer.changed += asks ? 1 : 0;
  flags[id] |= asks ? flag::kChanged : 0;
  store(box, request.latest[id]);
}

/// By value: nothing that is written through its pointers can be the request itself.
template <bool Fat, int D>
HWY_INLINE MoveAnswer move_all(const MoveRequest<D> request) {
  MoveAnswer answer;
  std::size_t k = 0;
  for (; k + kBlock <= request.objects.size(); k += kBlock)
    if (!take_block<Fat>(request, k, answer))
      for (std::size_t i = 0; i < kBlock; ++i) take<Fat>(request, k + i, answer);
  for (; k < request.objects.size(); ++k) take<Fat>(request, k, answer);
  return answer;
}

template <int D>
HWY_INLINE MoveAnswer move_any(const MoveRequest<D>& request) {
  return request.fat == nullptr ? move_all<false>(request) : move_all<true>(request);
}

MoveAnswer move_2(const MoveRequest<2>& request) { return move_any(request); }
MoveAnswer move_3(const MoveRequest<3>& request) { return move_any(request); }

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {

HWY_EXPORT(move_2);
HWY_EXPORT(move_3);

template <>
MoveAnswer move_boxes<2>(const MoveRequest<2>& request) {
  return HWY_DYNAMIC_DISPATCH(move_2)(request);
}
template <>
MoveAnswer move_boxes<3>(const MoveRequest<3>& request) {
  return HWY_DYNAMIC_DISPATCH(move_3)(request);
}

}  // namespace kerf
#endif
