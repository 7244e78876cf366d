#include "core/kernels/move_boxes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/move_boxes.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/bytes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// Both halves of a packed box, from a box as callers give it.
template <int D>
HWY_INLINE Ends pack_ends(const Box<D>& box) {
  const Four four;
  const float* const first = box.min.value.data();
  if constexpr (D == 2) {
    const Floats both = hn::LoadU(four, first);
    return {both, hn::Neg(hn::Shuffle1032(both))};  // lanes 2 and 3 have the other ends, not turned
  } else {
    const auto three = hn::FirstN(four, 3);
    const Floats min = hn::IfThenElseZero(three, hn::LoadU(four, first));
    const Floats max = hn::Shuffle0321(hn::LoadU(four, first + 2));  // z of min goes last
    return {min, hn::IfThenElseZero(three, hn::Neg(max))};
  }
}

/// Ordered and finite: false for NaN.
template <int D>
HWY_INLINE bool is_valid(const Ends& ends) {
  const Four four;
  const Floats least = hn::Set(four, -FLT_MAX);
  const auto ordered = hn::Le(ends.min, hn::Neg(ends.minus_max));
  const auto finite = hn::And(hn::Ge(ends.min, least), hn::Ge(ends.minus_max, least));
  auto valid = hn::And(ordered, finite);
  if constexpr (D == 2) valid = hn::Or(valid, hn::Not(hn::FirstN(four, 2)));
  return hn::AllTrue(four, valid);
}

template <int D>
HWY_INLINE void store_ends(const Ends& ends, PackedBox<D>& box) {
  const Four four;
  if constexpr (D == 2) {
    hn::Store(hn::ConcatLowerLower(four, ends.minus_max, ends.min), four, box.lane.data());
  } else {
    hn::Store(ends.min, four, box.lane.data());
    hn::Store(ends.minus_max, four, box.lane.data() + 4);
  }
}

template <int D>
HWY_INLINE bool holds(const PackedBox<D>& outer, const Ends& ends) {
  const Four four;
  const Ends out = load_ends(outer);
  auto inside = hn::And(hn::Le(out.min, ends.min), hn::Le(out.minus_max, ends.minus_max));
  if constexpr (D == 2) inside = hn::Or(inside, hn::Not(hn::FirstN(four, 2)));
  return hn::AllTrue(four, inside);
}

template <int D>
HWY_INLINE bool equals(const PackedBox<D>& box, const Ends& ends) {
  const Four four;
  const Ends own = load_ends(box);
  auto same = hn::And(hn::Eq(own.min, ends.min), hn::Eq(own.minus_max, ends.minus_max));
  if constexpr (D == 2) same = hn::Or(same, hn::Not(hn::FirstN(four, 2)));
  return hn::AllTrue(four, same);
}

template <bool Fat, int D>
HWY_INLINE MoveAnswer move_all(const MoveRequest<D>& request) {
  MoveAnswer answer;
  const ObjectId* const objects = request.objects.data();
  const Box<D>* const boxes = request.boxes.data();
  PackedBox<D>* const latest = request.latest.data();
  std::uint8_t* const attention = request.attention.data();
  for (std::size_t k = 0; k < request.objects.size(); ++k) {
    const std::size_t id = objects[k].index();
    const Ends ends = pack_ends(boxes[k]);
    if (id >= request.attention.size() || attention[id] != 0 || !is_valid<D>(ends)) {
      if (id < request.attention.size()) attention[id] |= kWaiting;
      request.left_over[answer.left_over++] = static_cast<std::uint32_t>(k);
      continue;
    }
    bool asks = true;
    if constexpr (Fat) {
      const PackedBox<D>& fat = request.fat[id];
      const bool shrinks = equals(fat, load_ends(latest[id])) & !equals(fat, ends);
      asks = !holds(fat, ends) | shrinks;
      request.before[answer.changed] = latest[id];
    }
    request.changed[answer.changed] = objects[k];
    answer.changed += asks ? 1 : 0;
    attention[id] = asks ? 1 : 0;
    store_ends(ends, latest[id]);
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
