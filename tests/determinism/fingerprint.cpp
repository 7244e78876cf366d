// Prints what a set of seeded runs comes to: a hash of every pair in its order, of every event, and of every
// state. However the program was compiled, the lines must be the same (tests/determinism/compare_builds).

#include <xxhash.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "core/broad_phase/bsp.h"
#include "core/random.h"

namespace {

using namespace kerf;

constexpr std::uint32_t kObjects = 300;
constexpr std::uint32_t kSteps = 120;

/// A hash over a stream of values.
class Stream {
 public:
  void add(const void* data, std::size_t size) { hash_ = XXH3_64bits_withSeed(data, size, hash_); }
  void add(std::uint64_t word) { add(&word, sizeof(word)); }
  [[nodiscard]] unsigned long long value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0;
};

/// A box that flies about, turns back at the walls, and now and then jumps.
template <int D>
struct Flyer {
  Vector<D> position;
  Vector<D> velocity;
  Vector<D> half;

  explicit Flyer(Random& random) {
    for (int i = 0; i < D; ++i) {
      position[i] = static_cast<Scalar>(random.uniform(0, 20));
      velocity[i] = static_cast<Scalar>(random.uniform(-0.3, 0.3));
      half[i] = static_cast<Scalar>(random.uniform(0.1, 0.8));
    }
  }

  void fly(Random& random) {
    const bool jumps = random.below(200) == 0;
    for (int i = 0; i < D; ++i) {
      if (jumps) position[i] = static_cast<Scalar>(random.uniform(0, 20));
      position[i] += velocity[i];
      if (position[i] < 0 || position[i] > 20) velocity[i] = -velocity[i];
    }
  }

  [[nodiscard]] Box<D> box() const { return {position - half, position + half}; }
};

template <int D>
void run(const char* name, VolumeKind kind, const Config& config) {
  Random random(42);
  std::vector<Flyer<D>> flyers;
  Bsp<D, EventLog> bsp(config, kind);
  Stream pairs;
  Stream events;
  Stream states;
  for (std::uint32_t i = 0; i < kObjects; ++i) {
    flyers.emplace_back(random);
    (void)bsp.insert({i}, flyers[i].box(), i % 10 == 0 ? Mobility::fixed : Mobility::moving);
  }
  for (std::uint32_t step = 0; step < kSteps; ++step) {
    for (std::uint32_t i = 0; i < kObjects; ++i) {
      if (i % 10 == 0) continue;
      flyers[i].fly(random);
      (void)bsp.move({i}, flyers[i].box());
    }
    bsp.step();
    pairs.add(bsp.pairs().data(), bsp.pairs().size_bytes());
    for (const Event& event : bsp.trace().take()) {
      const std::string text = describe(event);
      events.add(text.data(), text.size());
    }
    states.add(bsp.state_hash());
  }
  std::printf("%dD %-12s %-10s pairs %016llx events %016llx states %016llx\n", D, to_string(kind).data(),
              name, pairs.value(), events.value(), states.value());
}

template <int D>
void run_all() {
  Config busy;  // all five operators act
  busy.max_redundancy = 0.4F;
  busy.schedule_interval = 1;
  busy.budget_divisor = 1;
  Config axes = busy;
  axes.free_directions = false;
  for (const VolumeKind kind : volume_kinds<D>()) {
    run<D>("paper", kind, Config{});
    run<D>("busy", kind, busy);
    run<D>("busy-axes", kind, axes);
  }
}

}  // namespace

int main() {
  run_all<2>();
  run_all<3>();
}
