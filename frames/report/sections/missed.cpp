#include "frames/report/motion_cells.h"

namespace kerf {
namespace {

const Trade kTrade{"missed_share", "mean_ns", 100, "missed pairs, % of the true ones",
                   "ns an object and step, mean"};

const std::vector<TableColumn> kColumns{{"setting", "setting"},
                                        {"mean ns", "mean_ns", 1},
                                        {"median ns", "median_ns", 1},
                                        {"p99 ns", "p99_ns", 1},
                                        {"max ns", "max_ns", 1},
                                        {"missed", "missed"},
                                        {"missed %", "missed_share", 3, 100},
                                        {"extra", "extra"},
                                        {"extra %", "extra_share", 1, 100},
                                        {"true pairs", "true_pairs"}};

/// Recommended settings by scene: the fastest that is never wrong, and the fastest that is nearly never.
Json recommend(const SceneCell& motion, const Json& rows) {
  constexpr double kNearlyNone = 0.1;  // percent
  Json exact = recommended_within(rows, kTrade, 0);
  const Json nearly = recommended_within(rows, kTrade, kNearlyNone);
  return {{"scene", motion.scene + ", " + std::to_string(motion.dimension) + "D"},
          {"exact", exact["setting"]},
          {"exact_ns", exact["mean_ns"]},
          {"exact_extra", exact["extra_share"]},
          {"nearly", nearly["setting"]},
          {"nearly_ns", nearly["mean_ns"]},
          {"nearly_missed", nearly["missed_share"]}};
}

void write_recommendations(const std::vector<SceneCell>& motions, const CellStore& store, Page& page) {
  Json rows = Json::array();
  for (const SceneCell& motion : motions) rows.push_back(recommend(motion, store.at(motion.cell.key)));
  page.heading("Recommended settings");
  page.paragraph(
      "By scene, the fastest setting that missed no pair here, and the fastest that missed at most one in a "
      "thousand; kerf as it is where nothing gains a twentieth. Only kerf, kerf-paper and rounding to a grid "
      "promise to miss nothing whatever moves; a period with a margin misses nothing as long as no object "
      "moves farther than the margin between two placements. Time is that of the broad phase alone: extra "
      "pairs are paid for in the narrow phase (see there).");
  page.table("recommended settings by scene",
             {{"scene", "scene"},
              {"missing none", "exact"},
              {"ns", "exact_ns", 1},
              {"extra %", "exact_extra", 1, 100},
              {"missing <= 0.1 %", "nearly"},
              {"ns", "nearly_ns", 1},
              {"missed %", "nearly_missed", 3, 100}},
             rows, {}, true);
}

std::vector<Cell> cells(const ReportRequest& request) { return cells_of(motion_cells(request.sizes)); }

void write(const ReportRequest& request, const CellStore& store, Page& page) {
  page.paragraph(
      "Motions of kerf bench, every pair of every step held against brute force. Settings of one kind are "
      "joined: k or the grid grows along the line. A ring marks the Pareto front, on which nothing is both "
      "faster and less often wrong. Means, because a period has cheap and dear steps; p99 and max of single "
      "steps are in the tables.");
  const std::vector<SceneCell> motions = motion_cells(request.sizes);
  write_recommendations(motions, store, page);
  write_motions(motions, store, {"missed", "missed pairs", "Lower left is better.", kTrade, kColumns}, page);
  page.command(command_of(request, "missed"));
}

}  // namespace

Section missed_section() { return {"missed", "Time against missed pairs", cells, write}; }

}  // namespace kerf
