// A scene that never comes to rest, for very many steps: does the tree stay as good as it was? Height,
// entries and the 99th percentile of the step time of the last quarter stand beside those of the second, and
// the oracle is asked every thousand steps.
// usage: kerf_scene_soak SCENE OBJECTS STEPS tuned|paper CSV-FILE
//        kerf_scene_soak --list      the scenes: those of `kerf bench`, and those of `kerf scenes`
//
// The CSV has a row for each thousandth of the run, written as it passes: tests/soak/scene_soak.gp draws it.
// Exit code 1: it has degraded, or was not exact.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/parse_number.h"
#include "frames/support/progress.h"
#include "tests/soak/endless_run.h"

namespace kerf::test {
namespace {

constexpr std::uint32_t kSlices = 1000;  ///< rows of the CSV
constexpr std::uint32_t kSample = 10;    ///< steps between two looks at the tree
/// Steps between two questions to the oracle. After each the caches are cold, and the next step is slow: with
/// a question in a hundred steps that would be the percentile.
constexpr std::uint32_t kOracleInterval = 1000;
constexpr double kTolerance = 0.05;

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

Stretch run_slice(EndlessRun& run, std::uint32_t steps) {
  Stretch slice;
  slice.step_seconds.reserve(steps);
  for (std::uint32_t i = 0; i < steps; ++i) {
    slice.step_seconds.push_back(static_cast<float>(run.step()));
    if (i % kSample != 0) continue;
    const Statistics statistics = run.statistics();
    slice.height += statistics.height;
    slice.entries += static_cast<double>(statistics.entries);
    ++slice.samples;
  }
  return slice;
}

/// The whole run, slice by slice; each is in the file before the next begins.
std::vector<Stretch> run_slices(EndlessRun& run, std::uint32_t steps, const std::string& path) {
  std::ofstream file(path);
  file << "share,height,entries,median_us,p99_us\n";
  const InterruptGuard interrupt;
  const ProgressLine line;
  std::vector<Stretch> slices;
  const std::uint32_t slices_unasked = std::max(1U, kOracleInterval / (steps / kSlices));
  for (std::uint32_t i = 0; i < kSlices; ++i) {
    if (interrupt.requested()) throw Interrupted("interrupted; what was run is in " + path);
    line.show(std::to_string(i * 100 / kSlices) + " %");
    slices.push_back(run_slice(run, steps / kSlices));
    if ((i + 1) % slices_unasked == 0) run.ask_oracle();
    const Stretch& slice = slices.back();
    file << static_cast<double>(i) / kSlices << ',' << slice.mean_height() << ',' << slice.mean_entries()
         << ',' << slice.quantile_us(0.5) << ',' << slice.quantile_us(0.99) << '\n';
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
  }
  return slices;
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

Config preset(const std::string& name) {
  if (name == "tuned") return tuned_config();
  if (name == "paper") return Config{};
  throw UsageError("'" + name + "' is no preset: tuned or paper");
}

int soak(char** argv) {
  constexpr std::uint32_t kMost = 1'000'000'000;
  const auto objects = parse_whole<std::uint32_t>("OBJECTS", argv[2], 1, kMost);
  const auto steps = parse_whole<std::uint32_t>("STEPS", argv[3], kSample * kSlices, kMost);
  constexpr std::uint32_t kLongestGrowth = 2000;
  const auto run = make_endless_run(argv[1], preset(argv[4]), objects, std::min(steps / 10, kLongestGrowth));
  const std::vector<Stretch> slices = run_slices(*run, steps, argv[5]);
  const Stretch second = quarter(slices, 1);
  const Stretch last = quarter(slices, 3);
  std::printf("%s, %u objects, %u steps, %s\n", argv[1], objects, steps, argv[4]);
  const bool height = compare("height", second.mean_height(), last.mean_height());
  const bool entries = compare("entries", second.mean_entries(), last.mean_entries());
  const bool time = compare("p99 step us", second.quantile_us(0.99), last.quantile_us(0.99));
  return height && entries && time ? 0 : 1;
}

}  // namespace
}  // namespace kerf::test

int main(int argc, char** argv) try {
  if (argc == 2 && std::string_view(argv[1]) == "--list") {
    for (const std::string& name : kerf::test::endless_run_names()) std::puts(name.c_str());
    return 0;
  }
  if (argc != 6)
    throw kerf::UsageError("usage: kerf_scene_soak --list | SCENE OBJECTS STEPS tuned|paper CSV-FILE");
  return kerf::test::soak(argv);
} catch (const kerf::test::NotExact& error) {
  std::fprintf(stderr, "kerf_scene_soak: %s\n", error.what());
  return 1;
} catch (const kerf::Interrupted& error) {
  std::fprintf(stderr, "kerf_scene_soak: %s\n", error.what());
  return kerf::kExitInterrupted;
} catch (const std::exception& error) {
  std::fprintf(stderr, "kerf_scene_soak: %s\n", error.what());
  return 2;
}
