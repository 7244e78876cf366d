#include "core/kernels/move_boxes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/move_boxes.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/packed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

template <bool Fat, int D>
HWY_INLINE MoveAnswer move_all(const MoveRequest<D>& request) {
  MoveAnswer answer;
  const ObjectId* const objects = request.objects.data();
  const Box<D>* const boxes = request.boxes.data();
  PackedBox<D>* const latest = request.latest.data();
  std::uint8_t* const attention = request.attention.data();
  for (std::size_t k = 0; k < request.objects.size(); ++k) {
    const std::size_t id = objects[k].index();
    const Packed<D> box = pack(boxes[k]);
    if (id >= request.attention.size() || (attention[id] & ~kSilent) != 0 || !is_valid<D>(box)) {
      if (id < request.attention.size()) attention[id] |= kWaiting;
      request.left_over[answer.left_over++] = static_cast<std::uint32_t>(k);
      continue;
    }
    bool asks = true;
    if constexpr (Fat) {
      const Packed<D> fat = load(request.fat[id]);
      const bool filled = at_most<D>(load(latest[id]), fat);  // held by the fat box, it is as large
      const bool fills = at_most<D>(box, fat);
      asks = attention[id] == 0 && (!at_most<D>(fat, box) || (filled && !fills));
      request.before[answer.changed] = latest[id];
    }
    request.changed[answer.changed] = objects[k];
    answer.changed += asks ? 1 : 0;
    attention[id] |= asks ? 1 : 0;
    store<D>(box, latest[id]);
  }
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
