// M1 to M10: how objects move, come and go.

#include <array>
#include <cmath>

#include "tests/hard/cases/cases.h"
#include "tests/hard/cases/crowd.h"
#include "tests/support/boxes.h"

namespace kerf::test {
namespace {

template <int D>
Script<D> teleports(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 160, 2000), 31);
  crowd.insert(10);
  out.step();
  for (std::uint32_t round = 0; round < 30; ++round) {
    if (round % 3 == 0) crowd.teleport();
    if (round % 3 == 1) crowd.walk(0.2);
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> moves_below_an_ulp(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 150, 1000), 32);
  crowd.set_offset(1e6);  // where an ulp is 1/16
  crowd.insert();
  out.step();
  for (std::uint32_t round = 0; round < 25; ++round) {
    crowd.walk(0.02);  // nearly always less than an ulp, sometimes one
    for (std::uint32_t k = round % 5; k < crowd.size(); k += 5) {
      Box<D> box = crowd.box(k);
      const int axis = static_cast<int>(k % D);
      box.max[axis] = std::nextafter(box.max[axis], 2e6F);
      if (round % 2 == 0) box.min[axis] = std::nextafter(box.min[axis], 0.0F);
      out.move(k, box);
    }
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> last_box_counts(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 150, 1000), 33);
  crowd.insert(6);
  crowd.walk(1);
  out.step();
  for (std::uint32_t round = 0; round < 20; ++round) {
    // Elsewhere and back, elsewhere and on, a fixed object that is put somewhere else after all.
    crowd.teleport();
    if (round % 2 == 0) crowd.walk(0.5);
    for (std::uint32_t k = 0; k < crowd.size(); k += 6)
      if (round % 5 == 4) out.move(k, crowd.box((k + round) % crowd.size()));
    out.step(round % 3);
  }
  return out.take();
}

template <int D>
Script<D> removed_while_pending(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 160, 1000), 34);
  crowd.insert();
  for (std::uint32_t k = 0; k < crowd.size(); k += 9) out.remove(k);  // before their first step
  out.step();
  for (std::uint32_t k = 0; k < crowd.size(); k += 9) out.insert(k, crowd.box(k));
  out.step();
  for (std::uint32_t round = 0; round < 24; ++round) {
    crowd.walk(2);
    for (std::uint32_t k = round; k < crowd.size(); k += 12) {
      out.remove(k);
      if (k % 2 == 0) out.insert(k, crowd.box((k + 7) % crowd.size()));
    }
    out.step();
    for (std::uint32_t k = round; k < crowd.size(); k += 12)
      if (k % 2 == 1) out.insert(k, crowd.box(k));
  }
  return out.take();
}

template <int D>
Script<D> added_and_removed_at_once(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 150, 1000), 35);
  crowd.insert();
  out.step();
  const std::uint32_t n = crowd.size();
  out.remove(n, Status::unknown_id);
  out.move(n + 100, crowd.box(0), Status::unknown_id);
  for (std::uint32_t round = 0; round < 20; ++round) {
    crowd.walk(0.5);
    const Box<D> box = crowd.box(round % n);
    out.insert(n, box);
    out.insert(n, crowd.box((round + 3) % n), Status::duplicate_id);
    out.remove(n);
    out.remove(n, Status::unknown_id);
    out.move(n, box, Status::unknown_id);
    out.insert(round, box, Status::duplicate_id);
    // An id used again at once, another mobility with it.
    const std::uint32_t reused = 20 + round % 10;
    out.remove(reused);
    out.insert(reused, crowd.box(reused), Status::ok, round % 2 == 0 ? Mobility::fixed : Mobility::moving);
    if (round % 4 == 3) out.insert(n + round, box);
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> changed_parameters(Size size) {
  constexpr std::array<std::string_view, 6> kChanges{
      "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=4,max_threshold=8",
      "free_directions=0",
      "min_threshold=64,max_threshold=128",
      "max_height=3",
      "max_height=40,max_entries=1.1,min_threshold=2,max_threshold=4,free_directions=1",
      "min_balance=0.1,max_entries=8,repair_redundancy=0.05"};
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 180, 1000), 36);
  crowd.insert(8);
  for (std::uint32_t round = 0; round < 60; ++round) {
    if (round % 6 == 0) out.configure(kChanges[round / 6 % kChanges.size()]);
    crowd.walk(0.6);
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> fat_and_tight(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 150, 600), 37);
  out.set_margin(0.7);  // volumes reach far beyond the boxes given with them
  crowd.insert(9);
  out.step();
  for (std::uint32_t round = 0; round < 25; ++round) {
    out.set_margin(round % 3 == 2 ? 0 : 0.35 * (1 + round % 5));
    crowd.walk(0.3);
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> oscillation(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 100, 400), 38, 1);
  crowd.insert();
  out.step(20);
  const std::uint32_t rounds = pick(size, 60, 400);
  for (std::uint32_t round = 0; round < rounds; ++round) {
    // To and fro: each object that is near to some partitioner crosses it in every step.
    const Vector<D> by = all<D>(round % 2 == 0 ? 0.9F : 0.0F);
    for (std::uint32_t k = 0; k < crowd.size(); ++k) {
      const Box<D> box = crowd.box(k);
      out.move(k, {box.min + by, box.max + by});
    }
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> collapse_and_explosion(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 160, 1000), 39);
  crowd.insert();
  out.step(15);
  for (std::uint32_t round = 0; round < 40; ++round) {
    crowd.gather(round % 20 < 10 ? 0.35 : -0.54);
    out.step();
  }
  return out.take();
}

template <int D>
Script<D> resizing(Size size) {
  ScriptWriter<D> out;
  Crowd<D> crowd(out, pick(size, 150, 1000), 40);
  crowd.insert(8);
  out.step();
  for (std::uint32_t round = 0; round < 32; ++round) {
    crowd.walk(0.4);
    crowd.scale(round % 16 < 8 ? 1.25 : 0.8);
    out.step();
  }
  return out.take();
}

constexpr std::array kMotion{
    HardCase{"M1", "Teleports", "everything elsewhere at once", teleports<2>, teleports<3>},
    HardCase{"M2", "MovesBelowAnUlp", "moves lost in rounding", moves_below_an_ulp<2>, moves_below_an_ulp<3>},
    HardCase{"M3", "LastBoxCounts", "moved often in one step", last_box_counts<2>, last_box_counts<3>},
    HardCase{"M4", "RemovedWhilePending", "removed before its update", removed_while_pending<2>,
             removed_while_pending<3>},
    HardCase{"M5", "AddedAndRemovedAtOnce", "double remove, reused id", added_and_removed_at_once<2>,
             added_and_removed_at_once<3>},
    HardCase{"M6",
             "ChangedParameters",
             "parameters change in mid-run",
             changed_parameters<2>,
             changed_parameters<3>,
             {},
             std::nullopt,
             true},
    HardCase{"M7", "FatAndTight", "volumes larger than their boxes", fat_and_tight<2>, fat_and_tight<3>},
    HardCase{"M8", "Oscillation", "to and fro across planes", oscillation<2>, oscillation<3>},
    HardCase{"M9", "CollapseAndExplosion", "an attractor, then apart", collapse_and_explosion<2>,
             collapse_and_explosion<3>},
    HardCase{"M10", "Resizing", "grow and shrink while moving", resizing<2>, resizing<3>},
};

}  // namespace

std::span<const HardCase> motion_cases() { return kMotion; }

}  // namespace kerf::test
