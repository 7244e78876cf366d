#include "core/kernels/move_boxes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/move_boxes.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/packed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

constexpr std::size_t kBlock = 8;

/// Whether the objects of a block ascend: then the last one tells whether all are known.
HWY_INLINE bool ascend(const ObjectId* block) {
  const hn::FixedTag<std::uint32_t, 4> four;
  const auto* const numbers = &block->value;
  const auto ascend_from = [&](std::size_t k) HWY_ATTR {
    return hn::Lt(hn::LoadU(four, numbers + k), hn::LoadU(four, numbers + k + 1));
  };
  return hn::AllTrue(four, hn::And(ascend_from(0), ascend_from(kBlock - 5)));
}

/// Marks the lanes in which a is not at most b.
template <int D>
HWY_INLINE void mark_beyond(const Packed<D>& a, const Packed<D>& b, Packed<D>& marked) {
  for (std::size_t k = 0; k < Packed<D>::kParts; ++k)
    marked.part[k] = hn::Or(marked.part[k], beyond(a.part[k], b.part[k]));
}

/// Marks the lanes in which a box that filled its fat box no longer does.
template <int D>
HWY_INLINE void mark_shrinking(const Packed<D>& before, const Packed<D>& now, const Packed<D>& fat,
                               Packed<D>& marked) {
  for (std::size_t k = 0; k < Packed<D>::kParts; ++k) {
    const auto shrinks = hn::AndNot(beyond(before.part[k], fat.part[k]), beyond(now.part[k], fat.part[k]));
    marked.part[k] = hn::Or(marked.part[k], shrinks);
  }
}

template <int D>
HWY_INLINE bool none(const Packed<D>& marked) {
  auto any = marked.part[0];
  for (std::size_t k = 1; k < Packed<D>::kParts; ++k) any = hn::Or(any, marked.part[k]);
  return nowhere(any);
}

/// Takes the boxes of the block that begins at the k-th request, if nobody in it asks for more: most blocks
/// are like that, and one branch for eight objects tells.
template <int D>
HWY_INLINE bool take_quietly(const MoveRequest<D>& request, std::size_t k) {
  const ObjectId* const objects = request.objects.data() + k;
  if (!ascend(objects) || objects[kBlock - 1].index() >= request.attention.size()) return false;
  PackedBox<D> everywhere;  // holds every finite box, as fat boxes hold no others
  everywhere.lane.fill(-FLT_MAX);
  unsigned attention = 0;
  Packed<D> boxes[kBlock];
  Packed<D> marked{};
  for (auto& part : marked.part) part = hn::Zero(typename Packed<D>::Lanes());
  for (std::size_t i = 0; i < kBlock; ++i) {
    const std::size_t id = objects[i].index();
    const unsigned of_object = request.attention[id];
    attention |= of_object;
    boxes[i] = pack(request.boxes[k + i]);
    const Packed<D> fat = load(of_object == 0 ? request.fat[id] : everywhere);
    mark_beyond<D>(boxes[i], turned<D>(boxes[i]), marked);
    mark_beyond<D>(fat, boxes[i], marked);
    mark_shrinking<D>(load(request.latest[id]), boxes[i], fat, marked);
  }
  if ((attention & ~unsigned{kSilent}) != 0 || !none<D>(marked)) return false;
  for (std::size_t i = 0; i < kBlock; ++i) store<D>(boxes[i], request.latest[objects[i].index()]);
  return true;
}

/// One request.
template <bool Fat, int D>
HWY_INLINE void take(const MoveRequest<D>& request, std::size_t k, MoveAnswer& answer) {
  const ObjectId object = request.objects[k];
  const std::size_t id = object.index();
  const Packed<D> box = pack(request.boxes[k]);
  std::uint8_t* const attention = request.attention.data();
  if (id >= request.attention.size() || (attention[id] & ~kSilent) != 0 || !is_valid<D>(box)) {
    if (id < request.attention.size()) attention[id] |= kWaiting;
    request.left_over[answer.left_over++] = static_cast<std::uint32_t>(k);
    return;
  }
  bool asks = true;
  if constexpr (Fat) {
    const Packed<D> fat = load(request.fat[id]);
    const bool filled = at_most<D>(load(request.latest[id]), fat);  // held by the fat box, it is as large
    const bool fills = at_most<D>(box, fat);
    asks = attention[id] == 0 && (!at_most<D>(fat, box) || (filled && !fills));
    request.before[answer.changed] = request.latest[id];
  }
  request.changed[answer.changed] = object;
  answer.changed += asks ? 1 : 0;
  attention[id] |= asks ? 1 : 0;
  store<D>(box, request.latest[id]);
}

/// By value: nothing that is written through its pointers can be the request itself.
template <bool Fat, int D>
HWY_INLINE MoveAnswer move_all(const MoveRequest<D> request) {
  MoveAnswer answer;
  std::size_t k = 0;
  if constexpr (Fat)
    for (; k + kBlock <= request.objects.size(); k += kBlock)
      if (!take_quietly(request, k))
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
