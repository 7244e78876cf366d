#include "core/kernels/lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/kernels/write_pairs-inl.h"

#ifndef KERF_CORE_BROAD_PHASE_LANES_ONCE
#define KERF_CORE_BROAD_PHASE_LANES_ONCE
namespace kerf {

/// Lanes as bare pointers: code compiled for several targets must not contain the library's own.
struct LaneView {
  const Scalar* min[3];
  const Scalar* max[3];
  const std::uint32_t* object;
  const std::uint32_t* apart;
  std::size_t size;
  std::size_t last;  ///< the boxes before it are tested against those after them
};

/// Where pairs go. A kernel stops when the room before `limit` may not suffice for the next box.
struct PairRange {
  Pair* next;
  Pair* limit;
};

}  // namespace kerf
#endif

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

using Floats = hn::ScalableTag<Scalar>;

/// A box in every lane.
template <int D>
struct Probe {
  hn::Vec<Floats> min[D];
  hn::Vec<Floats> max[D];
  hn::Vec<Words> object;
  hn::Vec<Words> apart;
};

template <int D>
HWY_INLINE Probe<D> probe_at(const LaneView& lanes, std::size_t i) {
  const Floats f;
  const Words w;
  Probe<D> probe;
  for (int axis = 0; axis < D; ++axis) {
    probe.min[axis] = hn::Set(f, lanes.min[axis][i]);
    probe.max[axis] = hn::Set(f, lanes.max[axis][i]);
  }
  probe.object = hn::Set(w, lanes.object[i]);
  probe.apart = hn::Set(w, lanes.apart[i]);
  return probe;
}

/// Writes the pairs with the boxes from `j` on; returns the new end. The caller may know that on axis 0 every
/// box from `j` on begins after the probe does.
template <int D, bool Sorted>
HWY_INLINE Pair* test_vector(const LaneView& lanes, std::size_t j, const Probe<D>& probe, Pair* out) {
  const Floats f;
  const Words w;
  auto hit = hn::Le(hn::LoadU(f, lanes.min[0] + j), probe.max[0]);
  if (!Sorted) hit = hn::And(hit, hn::Ge(hn::LoadU(f, lanes.max[0] + j), probe.min[0]));
  for (int axis = 1; axis < D; ++axis) {
    hit = hn::And(hit, hn::Le(hn::LoadU(f, lanes.min[axis] + j), probe.max[axis]));
    hit = hn::And(hit, hn::Ge(hn::LoadU(f, lanes.max[axis] + j), probe.min[axis]));
  }
  const auto common = hn::And(hn::LoadU(w, lanes.apart + j), probe.apart);
  const auto reported = hn::And(hn::RebindMask(w, hit), hn::Eq(common, hn::Zero(w)));
  // No branch in a sweep: a hit is so hard to predict that the stores cost less.
  if (!Sorted && hn::AllFalse(w, reported)) return out;
  return write_pairs(probe.object, hn::LoadU(w, lanes.object + j), reported, out);
}

/// Two vectors at a time: most boxes need no more, so that the end of the loop can be predicted.
template <int D>
std::size_t sweep(const LaneView& lanes, std::size_t i, PairRange& pairs) {
  const std::size_t width = hn::Lanes(Floats());
  Pair* out = pairs.next;
  for (; i < lanes.last; ++i) {
    if (static_cast<std::size_t>(pairs.limit - out) < lanes.size - i) break;
    const Probe<D> probe = probe_at<D>(lanes, i);
    const Scalar end = lanes.max[0][i];
    std::size_t j = i + 1;
    do {
      out = test_vector<D, true>(lanes, j, probe, out);
      out = test_vector<D, true>(lanes, j + width, probe, out);
      j += 2 * width;
    } while (lanes.min[0][j - 1] <= end);
  }
  pairs.next = out;
  return i;
}

template <int D>
std::size_t test_all(const LaneView& lanes, std::size_t i, PairRange& pairs) {
  const std::size_t width = hn::Lanes(Floats());
  Pair* out = pairs.next;
  for (; i < lanes.last; ++i) {
    if (static_cast<std::size_t>(pairs.limit - out) < lanes.size - i) break;
    const Probe<D> probe = probe_at<D>(lanes, i);
    for (std::size_t j = i + 1; j < lanes.size; j += width) out = test_vector<D, false>(lanes, j, probe, out);
  }
  pairs.next = out;
  return i;
}

std::size_t sweep_2d(const LaneView& lanes, std::size_t i, PairRange& pairs) {
  return sweep<2>(lanes, i, pairs);
}
std::size_t sweep_3d(const LaneView& lanes, std::size_t i, PairRange& pairs) {
  return sweep<3>(lanes, i, pairs);
}
std::size_t test_all_2d(const LaneView& lanes, std::size_t i, PairRange& pairs) {
  return test_all<2>(lanes, i, pairs);
}
std::size_t test_all_3d(const LaneView& lanes, std::size_t i, PairRange& pairs) {
  return test_all<3>(lanes, i, pairs);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {
namespace {

HWY_EXPORT(sweep_2d);
HWY_EXPORT(sweep_3d);
HWY_EXPORT(test_all_2d);
HWY_EXPORT(test_all_3d);

template <int D>
LaneView view_of(const Lanes<D>& lanes, std::size_t last) {
  LaneView view{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    view.min[axis] = lanes.min[axis].data();
    view.max[axis] = lanes.max[axis].data();
  }
  view.object = lanes.object.data();
  view.apart = lanes.apart.data();
  view.size = lanes.size;
  view.last = last;
  return view;
}

using Kernel = std::size_t (*)(const LaneView&, std::size_t, PairRange&);

/// Makes room each time the kernel needs it.
template <int D>
void run(Kernel kernel, const Lanes<D>& lanes, std::size_t first, std::size_t last, PairList& pairs) {
  const LaneView view = view_of(lanes, last);
  for (std::size_t i = first; i < last;) {
    const std::size_t room = 2 * (lanes.size - i);
    PairRange range{pairs.reserve(room), nullptr};
    range.limit = range.next + room;
    i = kernel(view, i, range);
    pairs.commit(range.next);
  }
}

}  // namespace

template <int D>
void Lanes<D>::resize(std::size_t count) {
  size = count;
  if (object.size() < count + kPadding) {
    const std::size_t room = 2 * count + kPadding;
    for (auto& bound : min) bound.resize(room);
    for (auto& bound : max) bound.resize(room);
    object.resize(room);
    apart.resize(room);
  }
  constexpr Scalar kBeyond = std::numeric_limits<Scalar>::infinity();
  for (std::size_t k = count; k < count + kPadding; ++k) min[0][k] = kBeyond;
}

template <int D>
void Lanes<D>::set(std::size_t place, const Box<D>& box, ObjectId id, std::uint32_t apart_bits) {
  for (int axis = 0; axis < D; ++axis) {
    min[static_cast<std::size_t>(axis)][place] = box.min[axis];
    max[static_cast<std::size_t>(axis)][place] = box.max[axis];
  }
  object[place] = id.value;
  apart[place] = apart_bits;
}

template <int D>
void sweep_lanes(const Lanes<D>& lanes, PairList& pairs) {
  run(D == 2 ? HWY_DYNAMIC_DISPATCH(sweep_2d) : HWY_DYNAMIC_DISPATCH(sweep_3d), lanes, 0, lanes.size, pairs);
}

template <int D>
void test_lanes(const Lanes<D>& lanes, std::size_t first, std::size_t last, PairList& pairs) {
  run(D == 2 ? HWY_DYNAMIC_DISPATCH(test_all_2d) : HWY_DYNAMIC_DISPATCH(test_all_3d), lanes, first, last,
      pairs);
}

template struct Lanes<2>;
template struct Lanes<3>;
template void sweep_lanes<2>(const Lanes<2>&, PairList&);
template void sweep_lanes<3>(const Lanes<3>&, PairList&);
template void test_lanes<2>(const Lanes<2>&, std::size_t, std::size_t, PairList&);
template void test_lanes<3>(const Lanes<3>&, std::size_t, std::size_t, PairList&);

}  // namespace kerf
#endif
