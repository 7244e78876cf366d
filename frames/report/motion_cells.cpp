#include "frames/report/motion_cells.h"

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

std::vector<SceneCell> motion_cells(const ReportSizes& sizes) {
  std::vector<SceneCell> motions;
  for (const char* const motion : {"settled", "falling", "attractors"})
    for (const int dimension : {2, 3}) {
      const auto run = [=](const Poll& poll) {
        return dimension == 2 ? measure<2>(motion, sizes, poll) : measure<3>(motion, sizes, poll);
      };
      motions.push_back(make_scene_cell("motion", motion, dimension, sizes.objects, sizes, 5, run));
    }
  return motions;
}

void write_motions(const std::vector<SceneCell>& motions, const CellStore& store, const MotionView& view,
                   Page& page) {
  for (const SceneCell& motion : motions) {
    const Json& rows = store.at(motion.cell.key);
    page.heading(motion.title());
    page.figure(draw(plot_of(rows, view.trade, motion.title() + ": time against " + view.against),
                     std::string(view.section) + "-" + motion.id()),
                motion.cell.key + ". " + view.caption);
    page.table("all settings of this plot", view.columns, rows, front_of(rows, view.trade));
  }
}

}  // namespace kerf
