// A scene that never comes to rest, for very many steps: does the tree stay as good as it was? Height,
// entries and the 99th percentile of the step time of the last quarter stand beside those of the second.
// usage: kerf_scene_soak SCENE OBJECTS STEPS CSV-FILE     SCENE is a 3D scene, or a 2D one as NAME-2d
//
// The CSV has a row for each thousandth of the run: tests/bench/scene_soak.gp draws it. Exit code 1: it has
// degraded.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/broad_phase/bsp.h"
#include "sims2d/scenes/scenes.h"
#include "sims3d/scenes/scenes.h"

namespace {

using namespace kerf;

constexpr std::uint32_t kRecycle = 5;    ///< steps between two objects that fall anew
constexpr std::uint32_t kSlices = 1000;  ///< rows of the CSV
constexpr double kTolerance = 0.05;

/// Processor time of this thread: other work on the machine does not count.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What a stretch of the run was like.
struct Stretch {
  std::vector<float> step_seconds;
  double height = 0;
  double entries = 0;
  std::uint64_t samples = 0;

  void add(const Stretch& other) {
    step_seconds.insert(step_seconds.end(), other.step_seconds.begin(), other.step_seconds.end());
    height += other.height;
    entries += other.entries;
    samples += other.samples;
  }
  [[nodiscard]] double mean_height() const { return height / static_cast<double>(samples); }
  [[nodiscard]] double mean_entries() const { return entries / static_cast<double>(samples); }
  [[nodiscard]] double quantile_us(double rank) const {
    std::vector<float> sorted = step_seconds;
    const auto at =
        sorted.begin() + static_cast<std::ptrdiff_t>(rank * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return 1e6 * static_cast<double>(*at);
  }
};

/// The tree as the scene's broad phase, with a clock on all that it does in a step.
template <int D>
class Timed final : public BroadPhase<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return tree.name(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override {
    return tree.insert(object, box, mobility);
  }
  Status move(ObjectId object, const Box<D>& box) override { return tree.move(object, box); }
  Status remove(ObjectId object) override { return tree.remove(object); }
  void step() override {
    const double start = cpu_seconds();
    tree.step();
    seconds = cpu_seconds() - start;
  }
  [[nodiscard]] std::span<const Pair> pairs() const override { return tree.pairs(); }

  Bsp<D> tree;
  double seconds = 0;
};

template <int D>
std::vector<Stretch> run(const SceneEntry<D>& entry, std::uint32_t objects, std::uint32_t steps) {
  Timed<D> timed;
  const std::uint32_t growth = std::min(steps / 10, 2000U);
  const auto scene = entry.make(timed, {objects, growth, kRecycle, 1});
  std::vector<Stretch> slices(kSlices);
  for (std::uint32_t step = 0; step < steps; ++step) {
    scene->advance();
    Stretch& slice = slices[std::size_t{step} * kSlices / steps];
    slice.step_seconds.push_back(static_cast<float>(timed.seconds));
    if (step % 10 != 0) continue;
    const Statistics statistics = timed.tree.statistics();
    slice.height += statistics.height;
    slice.entries += static_cast<double>(statistics.entries);
    ++slice.samples;
  }
  return slices;
}

std::vector<Stretch> run(std::string name, std::uint32_t objects, std::uint32_t steps) {
  constexpr std::string_view kFlat = "-2d";
  const bool flat = name.ends_with(kFlat);
  if (flat) name.resize(name.size() - kFlat.size());
  if (flat) {
    for (const SceneEntry<2>& entry : scenes_2d())
      if (entry.name == name) return run(entry, objects, steps);
  } else {
    for (const SceneEntry<3>& entry : scenes_3d())
      if (entry.name == name) return run(entry, objects, steps);
  }
  throw std::invalid_argument("there is no scene '" + name + "' in " + (flat ? "2D" : "3D"));
}

void write_csv(const std::string& path, const std::vector<Stretch>& slices) {
  std::ofstream file(path);
  file << "share,height,entries,median_us,p99_us\n";
  for (std::size_t i = 0; i < slices.size(); ++i)
    file << static_cast<double>(i) / kSlices << ',' << slices[i].mean_height() << ','
         << slices[i].mean_entries() << ',' << slices[i].quantile_us(0.5) << ','
         << slices[i].quantile_us(0.99) << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

Stretch quarter(const std::vector<Stretch>& slices, std::size_t number) {
  Stretch sum;
  for (std::size_t i = number * kSlices / 4; i < (number + 1) * kSlices / 4; ++i) sum.add(slices[i]);
  return sum;
}

/// Prints one figure of the second and the last quarter; true if the last is not worse by more than the
/// tolerance.
bool compare(const char* what, double second, double last) {
  const double change = second == 0 ? 0 : last / second - 1;
  const bool kept = change <= kTolerance;
  std::printf("%-12s second quarter %10.2f   last quarter %10.2f   %+6.1f %%  %s\n", what, second, last,
              100 * change, kept ? "kept" : "DEGRADED");
  return kept;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 5) throw std::invalid_argument("usage: kerf_scene_soak SCENE OBJECTS STEPS CSV-FILE");
  const auto steps = static_cast<std::uint32_t>(std::stoul(argv[3]));
  if (steps < 10 * kSlices) throw std::invalid_argument("a soak takes 10,000 steps at least");
  const std::vector<Stretch> slices = run(argv[1], static_cast<std::uint32_t>(std::stoul(argv[2])), steps);
  write_csv(argv[4], slices);
  const Stretch second = quarter(slices, 1);
  const Stretch last = quarter(slices, 3);
  std::printf("%s, %s objects, %s steps\n", argv[1], argv[2], argv[3]);
  const bool height = compare("height", second.mean_height(), last.mean_height());
  const bool entries = compare("entries", second.mean_entries(), last.mean_entries());
  const bool time = compare("p99 step us", second.quantile_us(0.99), last.quantile_us(0.99));
  return height && entries && time ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "kerf_scene_soak: %s\n", error.what());
  return 2;
}
