#include "core/kernels/stay_in_cell.h"

#include <algorithm>

#include "core/base/tuning.h"
#include "core/kernels/prefetch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/stay_in_cell.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/packed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// No branch depends on which objects stay. By value: a write through the job's pointers cannot be to the
/// job.
template <bool Boxes, int D>
HWY_INLINE Stayed stay(const StayJob<D> job) {
  Stayed at;
  const Packed<D> cell = load(job.cell);
  for (std::size_t k = 0; k < job.count; ++k) {
    prefetch(job.boxes + job.entries[std::min(k + tuning::kPrefetchAhead, job.count - 1)].object.index());
    const Entry& entry = job.entries[k];
    const ObjectId object = entry.object;
    const DepthMask straddle = entry.straddle;
    const PackedBox<D>& box = job.boxes[object.index()];
    const Packed<D> lanes = load(box);
    const bool stays =
        static_cast<bool>(static_cast<int>(straddle == 0) & static_cast<int>(at_most<D>(cell, lanes)));
    const bool is_leftmost = (straddle & job.right_of) == 0;
    Entry& kept = job.entries[at.stayed];
    kept.key = {box.lane[job.axis], -box.lane[PackedBox<D>::kHalf + job.axis]};
    kept.object = object;
    kept.straddle = 0;
    job.leavers[at.left] = object.value;
    if constexpr (Boxes) {
      store<D>(lanes, job.stayer_boxes[at.stayed]);
      store<D>(lanes, job.leaver_boxes[at.left]);
    }
    at.stayed += static_cast<std::size_t>(stays);
    at.left += static_cast<std::size_t>(static_cast<int>(is_leftmost) & static_cast<int>(!stays));
  }
  return at;
}

template <int D>
HWY_INLINE Stayed stay_any(const StayJob<D>& job) {
  return job.leaver_boxes == nullptr ? stay<false>(job) : stay<true>(job);
}

Stayed stay_2(const StayJob<2>& job) { return stay_any(job); }
Stayed stay_3(const StayJob<3>& job) { return stay_any(job); }

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {

HWY_EXPORT(stay_2);
HWY_EXPORT(stay_3);

template <>
Stayed stay_in_cell<2>(const StayJob<2>& job) {
  return HWY_DYNAMIC_DISPATCH(stay_2)(job);
}
template <>
Stayed stay_in_cell<3>(const StayJob<3>& job) {
  return HWY_DYNAMIC_DISPATCH(stay_3)(job);
}

}  // namespace kerf
#endif
