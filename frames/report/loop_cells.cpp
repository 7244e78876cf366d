#include "frames/report/loop_cells.h"

#include "frames/report/closed_loop.h"

namespace kerf {
namespace {

Cell cell_of(const std::string& scene, int dimension, const ReportSizes& sizes, std::uint64_t seed) {
  const std::uint32_t grow = sizes.loop_steps * 2 / 5;
  const SceneLength length{sizes.loop_objects, grow, sizes.loop_steps - grow};
  const std::string key = "loop " + scene + " " + std::to_string(dimension) + "D, " +
                          std::to_string(length.objects) + " objects, " + std::to_string(sizes.loop_steps) +
                          " steps, seed " + std::to_string(seed);
  const auto run = [=](const Poll& poll) {
    return dimension == 2 ? run_closed_loops<2>(scene, length, seed, poll)
                          : run_closed_loops<3>(scene, length, seed, poll);
  };
  return {key, run, work_of(dimension == 2 ? 3 : 6, length.objects, sizes.loop_steps)};
}

LoopScene loop_scene(const std::string& scene, int dimension, const ReportSizes& sizes) {
  LoopScene loop{scene, dimension, {}};
  for (std::uint64_t seed = 1; seed <= sizes.seeds; ++seed)
    loop.seeds.push_back(cell_of(scene, dimension, sizes, seed));
  return loop;
}

}  // namespace

std::vector<LoopScene> loop_scenes(const ReportSizes& sizes) {
  return {loop_scene("pile", 2, sizes), loop_scene("buckets", 2, sizes), loop_scene("terrain", 3, sizes),
          loop_scene("buckets", 3, sizes)};
}

std::vector<Cell> cells_of(const std::vector<LoopScene>& scenes) {
  std::vector<Cell> cells;
  for (const LoopScene& scene : scenes) cells.insert(cells.end(), scene.seeds.begin(), scene.seeds.end());
  return cells;
}

std::vector<LoopRuns> runs_by_setting(const LoopScene& scene, const CellStore& store) {
  std::vector<LoopRuns> settings;
  for (const Cell& cell : scene.seeds) {
    const Json& result = store.at(cell.key);
    const Json& runs = result.at("runs");
    settings.resize(runs.size());
    for (std::size_t k = 0; k < runs.size(); ++k) {
      settings[k].setting = runs[k].at("setting").get<std::string>();
      settings[k].family = runs[k].at("family").get<std::string>();
      settings[k].steps = result.at("steps").get<std::vector<double>>();
      settings[k].seeds.push_back(runs[k]);
    }
  }
  return settings;
}

}  // namespace kerf
