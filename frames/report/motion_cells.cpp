#include "frames/report/motion_cells.h"

#include "core/base/counted.h"
#include "frames/bench/bench_scene.h"
#include "frames/report/course.h"
#include "frames/report/setting.h"

namespace kerf {
namespace {

constexpr std::uint32_t kWarmUp = 32;
constexpr std::uint64_t kSeed = 1;

template <int D>
Json measure(const std::string& motion, const ReportSizes& sizes, const Poll& poll) {
  const auto moving = find_bench_scene(motion).make<D>(sizes.objects, kSeed);
  const Course<D> course = record<D>(*moving, kWarmUp, sizes.steps, poll);
  Json rows = Json::array();
  for (const Setting& setting : all_settings()) {
    Json row{{"setting", setting.name}, {"family", setting.family}};
    row.update(run_course<D>(
        course, [&] { return make_broad_phase<D>(setting); }, sizes.rounds, poll));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

std::vector<MotionCell> motion_cells(const ReportSizes& sizes) {
  std::vector<MotionCell> motions;
  for (const char* const motion : {"settled", "falling", "attractors"})
    for (const int dimension : {2, 3}) {
      const std::string name = motion;
      const std::string key = "motion " + name + " " + std::to_string(dimension) + "D, " +
                              std::to_string(sizes.objects) + " objects, " + std::to_string(sizes.steps) +
                              " steps, " + counted(sizes.rounds, "round");
      const auto run = [=](const Poll& poll) {
        return dimension == 2 ? measure<2>(name, sizes, poll) : measure<3>(name, sizes, poll);
      };
      motions.push_back({name, dimension, {key, run, work_of(5, sizes.objects, sizes.steps)}});
    }
  return motions;
}

std::vector<Cell> cells_of(const std::vector<MotionCell>& motions) {
  std::vector<Cell> cells;
  for (const MotionCell& motion : motions) cells.push_back(motion.cell);
  return cells;
}

}  // namespace kerf
