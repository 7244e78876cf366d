// O1 to O5: scenes that make the operators meet the situations in which they could lose an object.

#include <array>
#include <limits>

#include "tests/hard/cases/cases.h"
#include "tests/hard/cases/crowd.h"
#include "tests/support/boxes.h"

namespace kerf::test {
namespace {

template <int D>
Script<D> shifts_onto_ends(Size size) {
  ScriptWriter<D> out;
  const std::uint32_t n = pick(size, 160, 600);
  const std::uint32_t side = lattice_side<D>(n);
  // Points and steps of one ulp: there is no offset that is not some object's end. The crowd drifts to one
  // side of where it was, object after object, so that partitioners follow it.
  const Scalar ulp = std::numeric_limits<Scalar>::epsilon();
  const auto box = [&](std::uint32_t k, std::uint32_t drift) {
    Vector<D> cell = lattice_cell<D>(k, side);
    cell[0] = cell[0] * 4 + static_cast<Scalar>(drift);
    const Vector<D> low = all<D>(1) + cell * ulp;
    Box<D> result{low, low};
    if (k % 6 == 0) result.max[0] += 2 * ulp;
    return result;
  };
  for (std::uint32_t k = 0; k < n; ++k) out.insert(k, box(k, 0));
  out.step(15);
  for (std::uint32_t round = 0; round < 40; ++round) {
    for (std::uint32_t k = 0; k < n; ++k)
      if (k % side < side / 2 || round % 2 == 0) out.move(k, box(k, round * (k % side < side / 2 ? 3 : 1)));
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> swaps_at_the_root(Size size) {
  ScriptWriter<D> out;
  const std::uint32_t n = pick(size, 120, 600);
  Crowd<D> crowd(out, n, 42, 0.6);
  crowd.insert();
  out.step(15);
  for (std::uint32_t round = 0; round < 4; ++round) {
    // On one heap no shift of any partitioner is good: the tree is swapped away from its root on.
    for (std::uint32_t k = 0; k < n; ++k) out.move(k, box_at<D>(all<D>(2), 1));
    out.step(12);
    for (std::uint32_t k = 0; k < n; ++k) crowd.send(k);
    out.step(10);
  }
  return out.take();
}

template <int D>
Script<D> merges_of_straddlers(Size size) {
  ScriptWriter<D> out;
  const std::uint32_t n = pick(size, 140, 600);
  Crowd<D> crowd(out, n, 43, 1.2);
  crowd.insert();
  // Long boxes that stay: they straddle most of what divides the others.
  for (std::uint32_t k = 0; k < 12; ++k) {
    Box<D> rod = crowd.box(k);
    rod.min[static_cast<int>(k % D)] = -5;
    rod.max[static_cast<int>(k % D)] = static_cast<Scalar>(crowd.world()) + 5;
    out.insert(n + k, rod);
  }
  out.step(15);
  for (std::uint32_t round = 0; round < 3; ++round) {
    for (std::uint32_t k = 0; k < n; ++k)
      if (k % 16 != 0) out.remove(k);
    out.step(12);
    for (std::uint32_t k = 0; k < n; ++k)
      if (k % 16 != 0) out.insert(k, crowd.box(k));
    out.step(12);
  }
  return out.take();
}

template <int D>
Script<D> events_for_dead_nodes(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 160, 800), 44);
  crowd.insert();
  out.step(8);
  for (std::uint32_t round = 0; round < 30; ++round) {
    // More is wanted than the budget allows; before it is done, everything is elsewhere or gone.
    if (round % 5 == 0) crowd.teleport();
    if (round % 5 == 2) crowd.gather(0.9);
    if (round % 5 == 4) crowd.gather(-8);
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> full_event_list(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 160, 800), 45);
  out.configure("budget_divisor=0");
  crowd.insert(9);
  out.step(5);
  for (std::uint32_t round = 0; round < 45; ++round) {
    if (round == 5) out.configure("budget_divisor=16,event_capacity=1,schedule_interval=1");
    if (round == 30) out.configure("budget_divisor=0");
    if (round == 38) out.configure("budget_divisor=1,event_capacity=64");
    crowd.walk(0.6);
    out.step();
  }
  return out.take();
}

constexpr std::string_view kEager =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=4,max_threshold=8";
constexpr std::string_view kLate =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=64,min_threshold=4,"
    "max_threshold=8";
constexpr std::string_view kUncapped =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=4,max_threshold=8,"
    "max_entries=1000";
constexpr std::string_view kCoarse =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=24,max_threshold=24";

constexpr std::array kOperators{
    HardCase{"O1", "ShiftsOntoEnds", "balance onto ends of objects", shifts_onto_ends<2>, shifts_onto_ends<3>,
             kEager, Operator::balance, true},
    HardCase{"O2", "SwapsAtTheRoot", "swap down to one leaf", swaps_at_the_root<2>, swaps_at_the_root<3>,
             kUncapped, Operator::swap, true},
    HardCase{"O3", "MergesOfStraddlers", "merge of objects on both sides", merges_of_straddlers<2>,
             merges_of_straddlers<3>, kCoarse, Operator::merge, true},
    HardCase{"O4", "EventsForDeadNodes", "deferred until the node is gone", events_for_dead_nodes<2>,
             events_for_dead_nodes<3>, kLate, std::nullopt, true},
    HardCase{"O5",
             "FullEventList",
             "no budget, no room for events",
             full_event_list<2>,
             full_event_list<3>,
             {},
             std::nullopt,
             true},
};

}  // namespace

std::span<const HardCase> operators_cases() { return kOperators; }

}  // namespace kerf::test
