// V1 to V5: boxes that are none, and boxes without extent.

#include <array>
#include <cmath>
#include <limits>

#include "tests/hard/cases/cases.h"
#include "tests/hard/cases/crowd.h"
#include "tests/support/boxes.h"

namespace kerf::test {
namespace {

constexpr Scalar kNan = std::numeric_limits<Scalar>::quiet_NaN();
constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();

/// Lets `spoil(box, round)` spoil the boxes of some objects of a walking crowd. A few are bad from the
/// beginning, others become so; all heal, some while they have moved on, and one is removed while bad.
template <int D, class Spoil>
Script<D> spoiled_crowd(Size size, Status expected, Spoil spoil) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 120, 600), 21);
  crowd.insert(7);
  const std::uint32_t n = crowd.size();
  for (std::uint32_t k = 0; k < 3; ++k) out.insert(n + k, spoil(crowd.box(k), k), expected);
  out.step();
  for (std::uint32_t round = 0; round < 24; ++round) {
    crowd.walk(0.4);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t offender = (round * 5 + k * 11) % n;
      out.move(offender, spoil(crowd.box(offender), round + k), expected);
    }
    if (round == 8) out.move(n, crowd.box(0));
    if (round == 12) out.remove(n + 1);
    if (round == 16) out.insert(n + 1, crowd.box(1));
    out.step();
    if (round % 4 == 3)  // all say again where they are: what is still bad heals
      for (std::uint32_t k = 0; k < n; ++k) crowd.send(k);
  }
  return out.take();
}

template <int D>
Script<D> not_a_number(Size size) {
  return spoiled_crowd<D>(size, Status::quarantined, [](Box<D> box, std::uint32_t round) {
    const int axis = static_cast<int>(round % D);
    if (round % 4 == 0) return Box<D>{all<D>(kNan), all<D>(kNan)};
    if (round % 4 != 1) box.min[axis] = kNan;
    if (round % 4 != 2) box.max[axis] = kNan;
    return box;
  });
}

template <int D>
Script<D> infinite_bounds(Size size) {
  return spoiled_crowd<D>(size, Status::clamped, [](Box<D> box, std::uint32_t round) {
    const int axis = static_cast<int>(round % D);
    switch (round % 5) {
      case 0:  // all space
        return Box<D>{all<D>(-kInfinity), all<D>(kInfinity)};
      case 1:  // the half space below a plane
        box.min = all<D>(-kInfinity);
        for (int other = 0; other < D; ++other)
          if (other != axis) box.max[other] = kInfinity;
        return box;
      case 2:  // an unbounded plane
        for (int other = 0; other < D; ++other) {
          if (other == axis) continue;
          box.min[other] = -kInfinity;
          box.max[other] = kInfinity;
        }
        return box;
      case 3:  // a point at infinity
        return Box<D>{all<D>(kInfinity), all<D>(kInfinity)};
      default:
        box.max[axis] = kInfinity;
        return box;
    }
  });
}

template <int D>
Script<D> inverted_boxes(Size size) {
  return spoiled_crowd<D>(size, Status::quarantined, [](Box<D> box, std::uint32_t round) {
    const int axis = static_cast<int>(round % D);
    switch (round % 4) {
      case 0:
        return Box<D>{box.max + all<D>(1), box.min};
      case 1:
        box.min[axis] = std::nextafter(box.max[axis], kInfinity);
        return box;
      case 2:
        box.max[axis] = -kInfinity;
        return box;
      default:
        box.min[axis] = box.max[axis] + 100;
        return box;
    }
  });
}

template <int D>
Script<D> points_and_plates(Size size) {
  ScriptWriter<D> out;
  Random random(4);
  const std::uint32_t n = pick(size, 150, 1000);
  const std::uint32_t side = lattice_side<D>(n);
  // On whole numbers, so that corners meet corners and plates lie in each other's planes.
  const auto box = [&](std::uint32_t k) {
    Box<D> result;
    for (int axis = 0; axis < D; ++axis) {
      const auto low = static_cast<Scalar>(random.below(side));
      const std::uint32_t extent = random.below(3);
      const bool flat = (k >> static_cast<unsigned>(axis) & 1U) == 0;  // k % 2^D == 0: a point
      result.min[axis] = low;
      result.max[axis] = flat ? low : low + static_cast<Scalar>(extent);
    }
    return result;
  };
  for (std::uint32_t k = 0; k < n; ++k) out.insert(k, box(k));
  out.step();
  for (std::uint32_t round = 0; round < 25; ++round) {
    for (std::uint32_t k = round % 3; k < n; k += 3) out.move(k, box(k));
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> signed_zeros(Size size) {
  ScriptWriter<D> out;
  Random random(5);
  const std::uint32_t n = pick(size, 120, 600);
  const auto zero = [&] { return random.below(2) == 0 ? 0.0F : -0.0F; };
  // Ends at a zero, begins at one, or is one, on each axis: all of them touch at the origin.
  const auto box = [&] {
    Box<D> result;
    for (int axis = 0; axis < D; ++axis) {
      const std::uint32_t way = random.below(3);
      const auto far = static_cast<Scalar>(1 + random.below(4));
      const Scalar low_zero = zero();
      const Scalar high_zero = zero();
      result.min[axis] = way == 0 ? -far : low_zero;
      result.max[axis] = way == 1 ? far : high_zero;
    }
    return result;
  };
  for (std::uint32_t k = 0; k < n; ++k) out.insert(k, box());
  out.step();
  for (std::uint32_t round = 0; round < 20; ++round) {
    for (std::uint32_t k = 0; k < n; ++k)
      if (random.below(2) == 0) out.move(k, box());
    out.step();
  }
  return out.take();
}

constexpr std::array kValues{
    HardCase{"V1", "NotANumber", "NaN in one bound or all", not_a_number<2>, not_a_number<3>},
    HardCase{"V2", "InfiniteBounds", "unbounded planes, half spaces", infinite_bounds<2>, infinite_bounds<3>},
    HardCase{"V3", "Inverted", "min > max", inverted_boxes<2>, inverted_boxes<3>},
    HardCase{"V4", "PointsAndFlatPlates", "zero extent", points_and_plates<2>, points_and_plates<3>},
    HardCase{"V5", "SignedZeros", "+0 touches -0", signed_zeros<2>, signed_zeros<3>},
};

}  // namespace

std::span<const HardCase> values_cases() { return kValues; }

}  // namespace kerf::test
