// kerf_profile_steps SCENE 2|3 OBJECTS STEPS [THREADS]: steps of a scene of `kerf bench` in this process.
// Prints as a line of JSON how long each phase takes; and callgrind counts what Bsp::step and Bsp::move_many
// (`./run speed`) or later_step (frames/bench/work_span) do.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/bsp/bsp.h"
#include "frames/bench/bench_scene.h"
#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

constexpr std::uint32_t kMost = 1'000'000;

struct Run {
  std::string_view scene;
  std::uint32_t objects;
  std::uint32_t steps;
  std::uint32_t threads;
};

/// Seconds for the requests, then for each phase of the step.
using Times = std::array<double, 1 + kPhaseCount>;

/// Of each phase, the median over the scheduler's intervals, the first half of them left out: what it does
/// once in an interval counts as what it takes in the mean.
Times typical(const std::vector<Times>& steps, std::size_t interval) {
  Times result{};
  for (std::size_t phase = 0; phase < result.size(); ++phase) {
    std::vector<double> means;
    for (std::size_t first = steps.size() / 2; first + interval <= steps.size(); first += interval) {
      double sum = 0;
      for (std::size_t k = first; k < first + interval; ++k) sum += steps[k][phase];
      means.push_back(sum / static_cast<double>(interval));
    }
    if (means.empty()) continue;
    std::ranges::nth_element(means, means.begin() + static_cast<std::ptrdiff_t>(means.size() / 2));
    result[phase] = means[means.size() / 2];
  }
  return result;
}

/// What moved in the last step of the motion, as requests.
template <int D>
void collect(const Motion<D>& motion, std::vector<ObjectId>& moved, std::vector<Box<D>>& boxes) {
  moved.assign(motion.moved().begin(), motion.moved().end());
  if (motion.all_move())
    for (std::uint32_t k = 0; k < motion.moving(); ++k) moved.push_back({k});
  boxes.clear();
  for (const ObjectId object : moved) boxes.push_back(motion.boxes()[object.index()]);
}

/// Steps in which the tree learns the motion, by one thread.
constexpr std::uint32_t kFirstSteps = 30;

/// Returns the seconds of the requests.
template <int D>
double take_step(Bsp<D>& tree, std::span<const ObjectId> moved, std::span<const Box<D>> boxes) {
  const auto start = std::chrono::steady_clock::now();
  (void)tree.move_many(moved, boxes);
  const std::chrono::duration<double> requests = std::chrono::steady_clock::now() - start;
  tree.step();
  return requests.count();
}

/// The same, under a name by which callgrind leaves out the first steps.
template <int D>
[[gnu::noinline]] double later_step(Bsp<D>& tree, std::span<const ObjectId> moved,
                                    std::span<const Box<D>> boxes) {
  return take_step<D>(tree, moved, boxes);
}

template <int D>
nlohmann::json run_steps(const Run& run) {
  const auto motion = find_bench_scene(run.scene).make<D>(run.objects, 1);
  Bsp<D> tree(tuned_config());
  tree.time_phases(true);
  for (std::uint32_t k = 0; k < run.objects; ++k)
    (void)tree.insert({k}, motion->boxes()[k], k < motion->moving() ? Mobility::moving : Mobility::fixed);
  std::vector<ObjectId> moved;
  std::vector<Box<D>> boxes;
  std::vector<Times> steps;
  for (std::uint32_t step = 0; step < run.steps; ++step) {
    if (step == kFirstSteps) tree.set_threads(run.threads, Sharing::always);
    Times times{step < kFirstSteps ? take_step<D>(tree, moved, boxes) : later_step<D>(tree, moved, boxes)};
    std::ranges::copy(tree.statistics().phase_seconds, times.begin() + 1);
    steps.push_back(times);
    motion->advance();
    collect(*motion, moved, boxes);
  }
  nlohmann::json line = {{"scene", run.scene},
                         {"dim", D},
                         {"objects", run.objects},
                         {"threads", run.threads},
                         {"pairs", tree.pairs().size()}};
  const Times times = typical(steps, tree.config().schedule_interval);
  const auto nanoseconds = [&](std::size_t at) { return times[at] * 1e9 / run.objects; };
  line["requests_ns"] = nanoseconds(0);
  for (int phase = 0; phase < kPhaseCount; ++phase) {
    const auto at = static_cast<std::size_t>(phase);
    line[std::string(to_string(static_cast<Phase>(phase))) + "_ns"] = nanoseconds(at + 1);
  }
  return line;
}

int profile_steps(int argc, char** argv) {
  const Run run{argv[1], parse_whole<std::uint32_t>("OBJECTS", argv[3], 1, kMost),
                parse_whole<std::uint32_t>("STEPS", argv[4], 1, kMost),
                argc < 6 ? 1 : parse_whole<std::uint32_t>("THREADS", argv[5], 1, 64)};
  if (run.threads > 1 && run.steps < 2 * kFirstSteps)
    throw UsageError("STEPS: at least " + std::to_string(2 * kFirstSteps) +
                     " with threads, which do not share the first " + std::to_string(kFirstSteps));
  const bool flat = parse_whole<int>("dimension", argv[2], 2, 3) == 2;
  std::puts((flat ? run_steps<2>(run) : run_steps<3>(run)).dump().c_str());
  return kExitHolds;
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) try {
  if (argc != 5 && argc != 6)
    throw kerf::UsageError("usage: kerf_profile_steps SCENE 2|3 OBJECTS STEPS [THREADS]");
  return kerf::profile_steps(argc, argv);
} catch (const std::exception& error) {
  std::fprintf(stderr, "kerf_profile_steps: %s\n", error.what());
  return kerf::kExitUnusable;
}
