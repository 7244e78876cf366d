// kerf_profile_steps SCENE 2|3 OBJECTS STEPS: some steps of a scene of `kerf bench` in this process, for a
// profiler: `./run speed` runs it under callgrind, which counts what Bsp::step and Bsp::move_many do.

#include <cstdint>
#include <cstdio>
#include <exception>
#include <string_view>
#include <vector>

#include "core/broad_phase/bsp.h"
#include "frames/bench/bench_scene.h"
#include "frames/errors.h"
#include "frames/parse_whole.h"

namespace kerf {
namespace {

constexpr std::uint32_t kMost = 1'000'000;

template <int D>
void run_steps(const BenchScene& scene, std::uint32_t objects, std::uint32_t steps) {
  const auto motion = scene.make<D>(objects, 1);
  Bsp<D> tree(tuned_config());
  for (std::uint32_t k = 0; k < objects; ++k)
    (void)tree.insert({k}, motion->boxes()[k], k < motion->moving() ? Mobility::moving : Mobility::fixed);
  std::vector<ObjectId> moved;
  std::vector<Box<D>> boxes;
  for (std::uint32_t step = 0; step < steps; ++step) {
    (void)tree.move_many(moved, boxes);
    tree.step();
    motion->advance();
    moved.assign(motion->moved().begin(), motion->moved().end());
    if (motion->all_move())
      for (std::uint32_t k = 0; k < motion->moving(); ++k) moved.push_back({k});
    boxes.clear();
    for (const ObjectId object : moved) boxes.push_back(motion->boxes()[object.index()]);
  }
  std::printf("%zu pairs in the last step\n", tree.pairs().size());
}

int profile_steps(char** argv) {
  const BenchScene& scene = find_bench_scene(argv[1]);
  const auto objects = parse_whole<std::uint32_t>("OBJECTS", argv[3], 1, kMost);
  const auto steps = parse_whole<std::uint32_t>("STEPS", argv[4], 1, kMost);
  if (parse_whole<int>("dimension", argv[2], 2, 3) == 2) {
    run_steps<2>(scene, objects, steps);
  } else {
    run_steps<3>(scene, objects, steps);
  }
  return kExitDone;
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) try {
  if (argc != 5) throw kerf::UsageError("usage: kerf_profile_steps SCENE 2|3 OBJECTS STEPS");
  return kerf::profile_steps(argv);
} catch (const std::exception& error) {
  std::fprintf(stderr, "kerf_profile_steps: %s\n", error.what());
  return kerf::kExitUsage;
}
