#include "core/kernels/follow_objects.h"

#include <algorithm>

#include "core/base/tuning.h"
#include "core/kernels/prefetch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/follow_objects.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/packed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// Of the extents in each four lanes: x, y, x, y or x, y, z, 0.
template <int D, class Lanes>
HWY_INLINE Lanes second_largest(Lanes extents) {
  const auto next = hn::Shuffle2301(extents);
  const auto less = hn::Min(extents, next);
  if constexpr (D == 2) return less;
  const auto more = hn::Max(extents, next);
  return hn::Max(hn::Min(more, hn::Shuffle1032(more)), hn::Max(less, hn::Shuffle1032(less)));
}

/// Whether an end moved by more than the thickest skin: the same floats as in `is_fast`.
template <int D>
HWY_INLINE bool outruns_skins(const Packed<D>& now, const Packed<D>& before) {
  const typename Packed<D>::Lanes lanes;
  const Packed<D> other_ends = turned<D>(now);
  bool outruns = false;
  for (std::size_t k = 0; k < Packed<D>::kParts; ++k) {
    const auto extent = hn::Sub(other_ends.part[k], now.part[k]);  // along each axis, in each four lanes
    const auto size = second_largest<D>(extent);
    const auto way = hn::Abs(hn::Sub(now.part[k], before.part[k]));
    outruns |= !nowhere(beyond(way, hn::Mul(size, hn::Set(lanes, Skin::kMost))));
  }
  return outruns;
}

template <int D>
HWY_INLINE std::size_t follow(const FollowJob<D>& job) {
  const Packed<D> cell = load(job.cell);
  std::size_t left_over = 0;
  for (std::size_t k = 0; k < job.count; ++k) {
    const std::uint32_t ahead = job.objects[std::min(k + tuning::kPrefetchAhead, job.count - 1)];
    prefetch(job.latest + ahead);
    prefetch(job.followed + ahead);
    prefetch(job.skins + ahead);
    const std::uint32_t object = job.objects[k];
    const Packed<D> now = load(job.latest[object]);
    const Packed<D> before = load(job.followed[object]);
    if (job.flags[object] == flag::kUnrequested && at_most<D>(cell, now) && at_most<D>(cell, before) &&
        outruns_skins<D>(now, before)) {
      store<D>(now, job.followed[object]);
      std::uint8_t& restless = job.skins[object].restless;  // if written, it leaves other cores' caches
      if (restless != Skin::kRestless) restless = Skin::kRestless;
    } else {
      job.left_over[left_over++] = object;
    }
  }
  return left_over;
}

std::size_t follow_2(const FollowJob<2>& job) { return follow(job); }
std::size_t follow_3(const FollowJob<3>& job) { return follow(job); }

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {

HWY_EXPORT(follow_2);
HWY_EXPORT(follow_3);

template <>
std::size_t follow_objects<2>(const FollowJob<2>& job) {
  return HWY_DYNAMIC_DISPATCH(follow_2)(job);
}
template <>
std::size_t follow_objects<3>(const FollowJob<3>& job) {
  return HWY_DYNAMIC_DISPATCH(follow_3)(job);
}

}  // namespace kerf
#endif
