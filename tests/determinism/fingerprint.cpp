// Prints the hashes of a set of seeded runs: of every pair in its order, of every event, and of every
// state. However the program was compiled, the lines must be the same (tests/determinism/compare_builds);
// runs of the policies beyond the paper are done with every kernel, and runs of many objects with several
// numbers of threads, which must agree, too.

#include <xxhash.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/bsp/bsp.h"
#include "core/kernels/machine.h"

namespace {

using namespace kerf;

/// The size and length of a run, and its threads.
struct Crowd {
  std::uint32_t objects = 300;
  std::uint32_t steps = 120;
  unsigned threads = 1;
};

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
std::string run(const char* name, VolumeKind kind, const Config& config, const Crowd& crowd = {}) {
  Random random(42);
  std::vector<Flyer<D>> flyers;
  std::vector<ObjectId> moving;
  std::vector<Box<D>> boxes;
  Bsp<D, EventLog> bsp(config, kind);
  bsp.set_threads(crowd.threads, Sharing::always);
  Stream pairs;
  Stream events;
  Stream states;
  for (std::uint32_t i = 0; i < crowd.objects; ++i) {
    flyers.emplace_back(random);
    (void)bsp.insert({i}, flyers[i].box(), i % 10 == 0 ? Mobility::fixed : Mobility::moving);
    if (i % 10 != 0) moving.push_back({i});
  }
  for (std::uint32_t step = 0; step < crowd.steps; ++step) {
    boxes.clear();
    for (const ObjectId object : moving) {
      flyers[object.index()].fly(random);
      boxes.push_back(flyers[object.index()].box());
    }
    (void)bsp.move_many(moving, boxes);
    bsp.step();
    pairs.add(bsp.pairs().data(), bsp.pairs().size_bytes());
    for (const Event& event : bsp.trace().take()) {
      const std::string text = describe(event, {});
      events.add(text.data(), text.size());
    }
    states.add(bsp.state_hash());
  }
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), "%dD %-12s %-10s pairs %016llx events %016llx states %016llx", D,
                to_string(kind).data(), name, pairs.value(), events.value(), states.value());
  return line.data();
}

/// The same run with every kernel that this machine has; throws if they differ.
template <int D>
std::string run_with_each_kernel(const char* name, VolumeKind kind, const Config& config) {
  std::string first;
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    const std::string line = run<D>(name, kind, config);
    if (first.empty()) first = line;
    if (line != first) throw std::runtime_error(kernel + " differs:\n" + first + "\n" + line);
  }
  use_kernel("");
  return first;
}

/// The same run, long enough for threads to share it, by several numbers of them; throws if they differ.
template <int D>
std::string run_with_threads(const char* name, const Config& config) {
  std::string first;
  for (const unsigned threads : {1U, 2U, 3U, 7U}) {
    const std::string line = run<D>(name, VolumeKind::box, config, {3000, 20, threads});
    if (first.empty()) first = line;
    if (line != first)
      throw std::runtime_error(std::to_string(threads) + " threads differ:\n" + first + "\n" + line);
  }
  return first;
}

template <int D>
void run_all() {
  Config busy;  // all five operators act
  busy.max_redundancy = 0.4F;
  busy.schedule_interval = 1;
  busy.budget_divisor = 1;
  Config axes = busy;
  axes.free_directions = false;
  Config swept = axes;
  swept.byte_sweep = true;
  swept.bulk_factor = 2;
  Config kept = swept;
  kept.skin = 8;
  for (const VolumeKind kind : volume_kinds<D>()) {
    std::puts(run<D>("paper", kind, Config{}).c_str());
    std::puts(run<D>("busy", kind, busy).c_str());
    std::puts(run<D>("busy-axes", kind, axes).c_str());
    if (kind != VolumeKind::box) std::puts(run<D>("swept", kind, swept).c_str());
  }
  std::puts(run_with_each_kernel<D>("swept", VolumeKind::box, swept).c_str());
  std::puts(run_with_each_kernel<D>("kept", VolumeKind::box, kept).c_str());
  std::puts(run_with_threads<D>("many-paper", Config{}).c_str());
  std::puts(run_with_threads<D>("many-swept", swept).c_str());
  std::puts(run_with_threads<D>("many-kept", kept).c_str());
}

}  // namespace

int main() try {
  run_all<2>();
  run_all<3>();
} catch (const std::exception& error) {
  std::fprintf(stderr, "kerf_fingerprint: %s\n", error.what());
  return 1;
}
