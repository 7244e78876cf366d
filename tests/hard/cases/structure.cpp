// S1 to S12: arrangements that leave a tree nothing to divide, or too much.

#include <array>
#include <cmath>
#include <limits>

#include "tests/hard/cases/cases.h"
#include "tests/hard/cases/crowd.h"
#include "tests/support/boxes.h"

namespace kerf::test {
namespace {

/// All boxes given by `box(k)`, still for a few steps, then each moved by `distance` along every axis.
template <int D, class MakeBox>
Script<D> still_then_moved(std::uint32_t n, Scalar distance, std::uint32_t still, std::uint32_t moved,
                           MakeBox box) {
  ScriptWriter<D> out;
  for (std::uint32_t k = 0; k < n; ++k) out.insert(k, box(k));
  out.step(still);
  for (std::uint32_t round = 1; round <= moved; ++round) {
    const Vector<D> by = all<D>(distance * static_cast<Scalar>(round));
    for (std::uint32_t k = 0; k < n; ++k) {
      const Box<D> now = box(k);
      out.move(k, {now.min + by, now.max + by});
    }
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> all_coincide(Size size) {
  return still_then_moved<D>(pick(size, 150, 1000), 0.25F, 12, 12, [](std::uint32_t) {
    return Box<D>{all<D>(-1), all<D>(1)};
  });
}

template <int D>
Script<D> nested_boxes(Size size) {
  return still_then_moved<D>(pick(size, 150, 1000), 0.25F, 12, 12, [](std::uint32_t k) {
    return box_at<D>(all<D>(3), static_cast<Scalar>(k) * 0.125F);
  });
}

template <int D>
Script<D> crossing_rods(Size size) {
  const std::uint32_t n = pick(size, 180, 1200);
  Random random(3);
  std::vector<Vector<D>> places;
  for (std::uint32_t k = 0; k < n; ++k) places.push_back(random_point<D>(random, -100, 100));
  return still_then_moved<D>(n, 0.01F, 12, 12, [&places](std::uint32_t k) {
    Box<D> rod = box_at<D>(places[k], 0.3F);
    rod.min[static_cast<int>(k % D)] = -110;
    rod.max[static_cast<int>(k % D)] = 110;
    return rod;
  });
}

template <int D>
Script<D> half_share_a_centre(Size size) {
  const std::uint32_t n = pick(size, 180, 1000);
  return still_then_moved<D>(n, 0.125F, 16, 16, [n](std::uint32_t k) {
    const std::uint32_t half = n / 2;
    if (k < half) return box_at<D>(all<D>(0), 0.5F + 0.0625F * static_cast<Scalar>(k % 7));
    return box_at<D>(lattice_cell<D>(k - half, lattice_side<D>(half)) + all<D>(4), 0.4F);
  });
}

template <int D>
Script<D> neighbouring_floats(Size size) {
  const std::uint32_t n = pick(size, 180, 1000);
  const std::uint32_t side = lattice_side<D>(n);
  const Scalar ulp = std::numeric_limits<Scalar>::epsilon();
  return still_then_moved<D>(n, ulp, 12, 12, [=](std::uint32_t k) {
    const Vector<D> low = all<D>(1) + lattice_cell<D>(k, side) * ulp;
    return Box<D>{low, k % 3 == 0 ? low + all<D>(ulp) : low};
  });
}

template <int D>
Script<D> sorted_and_collinear(Size size) {
  return still_then_moved<D>(pick(size, 400, 20000), 0.25F, 6, 6, [](std::uint32_t k) {
    Box<D> box{all<D>(0), all<D>(1)};
    box.min[D - 1] = static_cast<Scalar>(k);
    box.max[D - 1] = static_cast<Scalar>(k) + 1;
    return box;
  });
}

template <int D>
Script<D> exponential_spacing(Size size) {
  ScriptWriter<D> out;
  const std::uint32_t n = pick(size, 240, 960);
  const auto box = [n](std::uint32_t k, Scalar shift) {
    // From 2^-120 to 2^120, several in each octave, a few of them reaching back to the origin.
    const auto octave = static_cast<int>(static_cast<std::uint64_t>(k) * 240 / n) - 120;
    const Scalar at = std::ldexp(1 + shift + static_cast<Scalar>(k % 4) * 0.25F, octave);
    Box<D> result{all<D>(at), all<D>(at * 1.125F)};
    if (k % 16 == 0) result.min = all<D>(0);
    result.min[static_cast<int>(k % D)] = k % 5 == 0 ? at * 0.5F : result.min[static_cast<int>(k % D)];
    return result;
  };
  for (std::uint32_t k = 0; k < n; ++k) out.insert(k, box(k, 0));
  out.step(20);
  for (std::uint32_t round = 1; round <= 10; ++round) {
    for (std::uint32_t k = 0; k < n; ++k) out.move(k, box(k, 0.015625F * static_cast<Scalar>(round)));
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> many_objects(Size size) {
  ScriptWriter<D> out;
  const std::uint32_t n = pick(size, 2500, 70000);
  const std::uint32_t side = lattice_side<D>(n);
  const auto box = [&](std::uint32_t k, Scalar shift) {
    const Vector<D> low = lattice_cell<D>(k, side) + all<D>(shift);
    return Box<D>{low, low + all<D>(0.75F + 0.25F * static_cast<Scalar>(k % 2))};
  };
  for (std::uint32_t k = 0; k < n; ++k) out.insert(k, box(k, 0));
  out.step(2);
  for (std::uint32_t round = 0; round < 3; ++round) {
    for (std::uint32_t k = round; k < n; k += 3) out.move(k, box(k, 0.5F));
    out.step();
  }
  for (std::uint32_t k = 0; k < n; k += 2) out.remove(k);
  out.step();
  return out.take();
}

template <int D>
Script<D> few_objects(Size /*size*/) {
  ScriptWriter<D> out;
  const Box<D> box{all<D>(0), all<D>(1)};
  out.step(2);
  for (std::uint32_t round = 0; round < 4; ++round) {
    out.insert(0, box);
    out.step(1);
    out.insert(1, round % 2 == 0 ? box : Box<D>{all<D>(1), all<D>(2)});
    out.step(1);
    out.move(0, {all<D>(3), all<D>(4)});
    out.step();
    out.remove(round % 2);
    out.step(1);
    out.remove(1 - round % 2);
    out.step(12);
  }
  for (std::uint32_t k = 0; k < 100; ++k) out.insert(k, box_at<D>(all<D>(static_cast<Scalar>(k)), 0.6F));
  out.step(12);
  for (std::uint32_t k = 0; k < 100; ++k) out.remove(k);
  out.step(12);
  out.insert(5, box);
  out.step();
  return out.take();
}

template <int D>
Script<D> touching_lattice(Size size) {
  const std::uint32_t n = pick(size, 216, 2744);
  const std::uint32_t side = lattice_side<D>(n);
  // Whole cells that share faces, edges and corners; every good partitioner lies on faces.
  return still_then_moved<D>(n, 1, 15, 10, [side](std::uint32_t k) {
    const Vector<D> low = lattice_cell<D>(k, side);
    return Box<D>{low, low + all<D>(1)};
  });
}

template <int D>
Script<D> slanted_needles(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 150, 600), 13, 0.8);
  // Long and thin: a partitioner that is only nearly along an axis is straddled by many of them.
  const auto needle = [&](std::uint32_t k) {
    Box<D> box = crowd.box(k);
    const int axis = static_cast<int>(k % D);
    box.min[axis] -= 20;
    box.max[axis] += 20;
    for (int other = 0; other < D; ++other)
      if (other != axis) box.max[other] = box.min[other] + (box.max[other] - box.min[other]) * 0.01F;
    return box;
  };
  for (std::uint32_t k = 0; k < crowd.size(); ++k) out.insert(k, needle(k));
  out.step();
  for (std::uint32_t round = 0; round < 24; ++round) {
    for (std::uint32_t k = round % 2; k < crowd.size(); k += 2) {
      Box<D> box = needle(k);
      const Vector<D> by = random_point<D>(crowd.random(), -0.5, 0.5);
      out.move(k, {box.min + by, box.max + by});
    }
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> overflowing_projections(Size size) {
  ScriptWriter<D> out;
  Random random(14);
  constexpr Scalar kLargest = std::numeric_limits<Scalar>::max();
  const std::uint32_t n = pick(size, 150, 600);
  // In the corners of the range of floats: along a slanted direction most projections are infinite.
  const auto box = [&] {
    Box<D> result;
    for (int axis = 0; axis < D; ++axis) {
      const Scalar sign = random.below(2) == 0 ? 1.0F : -1.0F;
      const auto depth = static_cast<Scalar>(random.uniform(0, 0.25));
      const auto width = static_cast<Scalar>(random.uniform(0, 0.125));
      const Scalar near = sign * kLargest * (1 - depth - width);
      const Scalar far = sign * kLargest * (1 - depth);
      result.min[axis] = std::min(near, far);
      result.max[axis] = std::max(near, far);
    }
    return result;
  };
  for (std::uint32_t k = 0; k < n; ++k) out.insert(k, box());
  out.step();
  for (std::uint32_t round = 0; round < 20; ++round) {
    for (std::uint32_t k = round % 3; k < n; k += 3) out.move(k, box());
    out.step();
  }
  return out.take();
}

constexpr std::array kStructure{
    HardCase{"S1", "AllCoincide", "all boxes the same", all_coincide<2>, all_coincide<3>},
    HardCase{"S2", "Nested", "each box in the next", nested_boxes<2>, nested_boxes<3>},
    HardCase{"S3", "CrossingRods", "every plane straddled", crossing_rods<2>, crossing_rods<3>},
    HardCase{"S4", "HalfShareACentre", "half on one spot, half aside", half_share_a_centre<2>,
             half_share_a_centre<3>},
    HardCase{"S5", "NeighbouringFloats", "no float between objects", neighbouring_floats<2>,
             neighbouring_floats<3>},
    HardCase{"S6", "SortedAndCollinear", "one long row, in order", sorted_and_collinear<2>,
             sorted_and_collinear<3>},
    HardCase{"S7", "ExponentialSpacing", "2^-120 to 2^120 on a line", exponential_spacing<2>,
             exponential_spacing<3>},
    HardCase{"S8", "ManyObjects", "more than 65,535 objects", many_objects<2>, many_objects<3>},
    HardCase{"S9", "FewObjects", "0, 1, 2 objects; all removed", few_objects<2>, few_objects<3>},
    HardCase{"S10", "TouchingLattice", "faces, edges, corners meet", touching_lattice<2>,
             touching_lattice<3>},
    HardCase{"S11", "SlantedNeedles", "dense set of directions", slanted_needles<2>, slanted_needles<3>,
             "directions=400,candidate_factor=100,max_redundancy=0.4,schedule_interval=1,budget_divisor=1,"
             "min_threshold=8,max_threshold=16"},
    HardCase{"S12", "OverflowingProjections", "n * p beyond FLT_MAX", overflowing_projections<2>,
             overflowing_projections<3>},
};

}  // namespace

std::span<const HardCase> structure_cases() { return kStructure; }

}  // namespace kerf::test
