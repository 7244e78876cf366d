// What a World costs over the tree below it: 16,000 objects that all move a little in each step. Three ways
// do the same in turn: the tree alone, the tree with the changes of its pairs, and a world. usage:
// kerf_world_overhead [DIMENSION [OBJECTS [STEPS [bare|changes|world]]]]    one way alone: for callgrind

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/broad_phase/pair_changes.h"
#include "core/world/world.h"

namespace {

using kerf::Box;
using kerf::Handle;
using kerf::ObjectId;
using kerf::Random;
using kerf::Scalar;
using kerf::Vector;

/// Of this thread: what others do at the same time counts as little as can be.
double processor_microseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

/// Boxes that move by up to a twentieth of their size, in a region in which each meets a few others.
template <int D>
class Motion {
 public:
  explicit Motion(std::size_t count) : boxes(count), speeds_(count) {
    const double side = std::pow(static_cast<double>(count), 1.0 / D) * 1.2;
    for (std::size_t k = 0; k < count; ++k)
      for (int axis = 0; axis < D; ++axis) {
        boxes[k].min[axis] = static_cast<Scalar>(random_.uniform(0, side));
        boxes[k].max[axis] = boxes[k].min[axis] + static_cast<Scalar>(random_.uniform(0.5, 1.5));
        speeds_[k][axis] = static_cast<Scalar>(random_.uniform(-0.01, 0.01));
      }
  }
  void step() {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      boxes[k].min = boxes[k].min + speeds_[k];
      boxes[k].max = boxes[k].max + speeds_[k];
      if (random_.below(50) == 0) speeds_[k] = speeds_[k] * Scalar{-1};
    }
  }

  std::vector<Box<D>> boxes;

 private:
  Random random_{1};
  std::vector<Vector<D>> speeds_;
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <int D>
int measure(std::size_t count, int steps, const std::string& way) {
  Motion<D> motion(count);
  kerf::Bsp<D> bare(kerf::tuned_config());
  kerf::Bsp<D> tree(kerf::tuned_config());
  kerf::PairChanges changes;
  kerf::World<D> world;
  std::vector<ObjectId> ids(count);
  std::vector<Handle> handles(count);
  const kerf::ObjectDef def;
  if (world.insert(motion.boxes, {&def, 1}, handles) != kerf::WorldStatus::ok) return 1;
  for (std::uint32_t k = 0; k < count; ++k) {
    ids[k] = {k};
    if (bare.insert(ids[k], motion.boxes[k], kerf::Mobility::moving) != kerf::Status::ok) return 1;
    if (tree.insert(ids[k], motion.boxes[k], kerf::Mobility::moving) != kerf::Status::ok) return 1;
  }
  std::vector<double> times_bare;
  std::vector<double> with_changes;
  std::vector<double> with_world;
  const auto timed = [&](std::vector<double>& times, const char* name, auto work) {
    if (!way.empty() && way != name) return;
    const double begin = processor_microseconds();
    work();
    times.push_back(processor_microseconds() - begin);
  };
  for (int step = 0; step < steps; ++step) {
    motion.step();
    timed(times_bare, "bare", [&] {
      (void)bare.move_many(ids, motion.boxes);
      bare.step();
    });
    timed(with_changes, "changes", [&] {
      (void)tree.move_many(ids, motion.boxes);
      tree.step();
      changes.update(tree.pairs());
    });
    timed(with_world, "world", [&] {
      (void)world.move(handles, motion.boxes);
      world.step();
    });
  }
  const double first = median(times_bare);
  const double second = median(with_changes);
  const double third = median(with_world);
  std::printf("%dD, %zu objects, %zu pairs, %d steps\n", D, count, world.pairs().size(), steps);
  std::printf("tree %.0f us, with changes %.0f us, world %.0f us\n", first, second, third);
  if (way.empty()) std::printf("world over tree with changes: %.3f\n", third / second);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  const auto number = [&](int k, int otherwise) { return count > k ? std::atoi(arguments[k]) : otherwise; };
  const auto objects = static_cast<std::size_t>(number(2, 16000));
  const std::string way = count > 4 ? arguments[4] : "";
  return number(1, 3) == 2 ? measure<2>(objects, number(3, 600), way)
                           : measure<3>(objects, number(3, 600), way);
}
