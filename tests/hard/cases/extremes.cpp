// V6 to V11: the ends of the range of floats, and both in one scene.

#include <array>
#include <cmath>
#include <limits>

#include "tests/hard/cases/cases.h"
#include "tests/hard/cases/crowd.h"
#include "tests/support/boxes.h"

namespace kerf::test {
namespace {

constexpr Scalar kMax = std::numeric_limits<Scalar>::max();

Scalar power(int exponent) { return std::ldexp(1.0F, exponent); }

/// The smallest box that holds both points.
template <int D>
Box<D> spanned(const Vector<D>& a, const Vector<D>& b) {
  Box<D> box{a, a};
  return join(box, {b, b});
}

/// n boxes given by `box(k)`, a share of which is given anew in each of `rounds` steps.
template <int D, class MakeBox>
Script<D> renewed(std::uint32_t n, std::uint32_t rounds, MakeBox box) {
  ScriptWriter<D> out;
  for (std::uint32_t k = 0; k < n; ++k) out.insert(k, box(k));
  out.step();
  for (std::uint32_t round = 0; round < rounds; ++round) {
    for (std::uint32_t k = round % 4; k < n; k += 4) out.move(k, box(k));
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> denormals(Size size) {
  Random random(6);
  const Scalar unit = std::numeric_limits<Scalar>::denorm_min();
  const std::uint32_t n = pick(size, 120, 800);
  const std::uint32_t range = 4 * lattice_side<D>(n);
  const auto point = [&] {
    Vector<D> p;
    for (int axis = 0; axis < D; ++axis) {
      const double cell = static_cast<double>(random.below(range)) - range / 2.0;
      p[axis] = static_cast<Scalar>(cell) * unit;
    }
    return p;
  };
  return renewed<D>(n, 20, [&](std::uint32_t) {
    const Vector<D> low = point();
    Vector<D> reach;
    for (int axis = 0; axis < D; ++axis) reach[axis] = static_cast<Scalar>(random.below(5)) * unit;
    return Box<D>{low, low + reach};
  });
}

/// Couples on both sides of zero, where a partitioner comes to lie, that all part and meet there together.
template <int D>
Script<D> touch_at_zero(Size size) {
  const std::uint32_t n = pick(size, 64, 800);
  const auto place = [](std::uint32_t k, Scalar gap) {
    Vector<D> low{};
    low[0] = k % 2 == 0 ? gap : -gap - 1;
    low[1] = static_cast<Scalar>(4 * (k / 2));
    Vector<D> high = low;
    for (int axis = 0; axis < D; ++axis) high[axis] += 1;
    return Box<D>{low, high};
  };
  ScriptWriter<D> script;
  for (std::uint32_t k = 0; k < n; ++k) script.insert(k, place(k, 1));
  for (std::uint32_t step = 0; step < 12; ++step) {
    script.step();
    for (std::uint32_t k = 0; k < n; ++k) script.move(k, place(k, step % 3 == 2 ? 0 : 1));
  }
  return script.take();
}

template <int D>
Script<D> largest_floats(Size size) {
  Random random(7);
  const auto coordinate = [&] {
    const std::uint32_t way = random.below(6);
    const Scalar sign = random.below(2) == 0 ? 1.0F : -1.0F;
    const auto exponent = static_cast<int>(110 + random.below(18));
    const auto mantissa = static_cast<Scalar>(random.uniform(1, 2));
    if (way == 0) return sign * kMax;
    if (way == 1) return sign * std::nextafter(kMax, 0.0F);
    if (way == 2) return sign * static_cast<Scalar>(random.below(3));
    return sign * std::ldexp(mantissa, exponent - 1);
  };
  return renewed<D>(pick(size, 120, 800), 20, [&](std::uint32_t k) {
    Vector<D> a;
    Vector<D> b;
    for (int axis = 0; axis < D; ++axis) {
      a[axis] = coordinate();
      b[axis] = k % 3 == 0 ? coordinate() : a[axis] * 0.75F;
    }
    return spanned<D>(a, b);
  });
}

template <int D>
Script<D> far_offsets(Size size) {
  constexpr std::array kOffsets{1e5, 1e6, 1e7, -1e7};
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 150, 1000), 8);
  for (const double offset : kOffsets) {
    crowd.set_offset(offset);
    if (offset == kOffsets.front()) crowd.insert(9);
    for (int round = 0; round < 7; ++round) {
      crowd.walk(0.7);
      out.step();
    }
  }
  return out.take();
}

template <int D>
Script<D> exact_touch(Size size) {
  Random random(9);
  const std::uint32_t n = pick(size, 160, 1000);
  // Cells of a lattice whose faces are pulled apart or pushed together by an ulp, at scales far apart.
  const std::uint32_t cells = n / 4;
  const std::uint32_t side = lattice_side<D>(cells);
  const auto nudge = [&](Scalar x) {
    const std::uint32_t way = random.below(3);
    return way == 0 ? x : std::nextafter(x, way == 1 ? kMax : -kMax);
  };
  return renewed<D>(n, 25, [&](std::uint32_t k) {
    const Scalar scale = power(static_cast<int>(k / cells) * 12 - 24);
    const Vector<D> cell = lattice_cell<D>(k % cells, side) * scale;
    Box<D> box;
    for (int axis = 0; axis < D; ++axis) {
      box.min[axis] = nudge(cell[axis] + scale);
      box.max[axis] = nudge(cell[axis] + 2 * scale);
    }
    return box;
  });
}

template <int D>
Script<D> mixed_scales(Size size) {
  Random random(10);
  const std::uint32_t n = pick(size, 160, 1000);
  return renewed<D>(n, 25, [&](std::uint32_t k) {
    if (k == 0) {  // the ground
      Box<D> ground{all<D>(-power(60)), all<D>(power(60))};
      ground.max[D - 1] = static_cast<Scalar>(random.uniform(-1, 1));
      return ground;
    }
    const Scalar scale = power(static_cast<int>(k % 81) - 40);
    const Vector<D> center = random_point<D>(random, -4, 4) * scale;
    const Vector<D> half = random_point<D>(random, 0, 1) * scale;
    return Box<D>{center - half, center + half};
  });
}

template <int D>
Script<D> tiny_box_far_out(Size size) {
  constexpr std::array kDistances{1e3F, 1e6F, 1e9F, 1e18F, 1e30F};
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 120, 600), 11);
  crowd.insert(8);
  const std::uint32_t outsider = crowd.size();
  out.insert(outsider, {all<D>(0), all<D>(0.01F)});
  out.step();
  for (std::uint32_t round = 0; round < 25; ++round) {
    crowd.walk(0.3);
    const Scalar far = kDistances[round / 4 % kDistances.size()];
    out.move(outsider, round % 4 == 3 ? crowd.box(0) : box_at<D>(all<D>(far), 0.01F));
    out.step();
  }
  return out.take();
}

constexpr std::array kExtremes{
    HardCase{"V6", "Denormals", "coordinates below 2^-126", denormals<2>, denormals<3>},
    HardCase{"V6",
             "DenormalsFlushedToZero",
             "the same, taken for zero",
             denormals<2>,
             denormals<3>,
             {},
             std::nullopt,
             false,
             true},
    HardCase{"V6", "TouchAtZeroFlushedToZero", "couples meet at zero, so taken", touch_at_zero<2>,
             touch_at_zero<3>,
             "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=16,max_threshold=16,"
             "free_directions=0,byte_sweep=1,stream_share=0.06,bulk_factor=2",
             std::nullopt, false, true},
    HardCase{"V7", "LargestFloats", "coordinates up to FLT_MAX", largest_floats<2>, largest_floats<3>},
    HardCase{"V8", "FarOffsets", "scene offset by 1e5 to 1e7", far_offsets<2>, far_offsets<3>},
    HardCase{"V9", "ExactTouch", "touch, and one ulp off", exact_touch<2>, exact_touch<3>},
    HardCase{"V10", "MixedScales", "sizes 2^-40 to 2^40, ground", mixed_scales<2>, mixed_scales<3>},
    HardCase{"V11", "TinyBoxFarOut", "one box at 1e3 to 1e30", tiny_box_far_out<2>, tiny_box_far_out<3>},
};

}  // namespace

std::span<const HardCase> extremes_cases() { return kExtremes; }

}  // namespace kerf::test
