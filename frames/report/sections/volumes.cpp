#include "frames/report/volumes.h"

#include "frames/report/section.h"
#include "frames/report/trade.h"

namespace kerf {
namespace {

const Trade kTrade{"candidates_per_contact", "total_ns", 1, "candidates for each true contact",
                   "ns an object and step, mean: bounding and tree"};

const std::vector<TableColumn> kColumns{{"bricks", "family"},
                                        {"volume", "setting"},
                                        {"candidates per contact", "candidates_per_contact", 2},
                                        {"contacts", "contacts"},
                                        {"missed", "missed"},
                                        {"bounding ns", "bound_ns", 1},
                                        {"mean ns", "mean_ns", 1},
                                        {"median ns", "median_ns", 1},
                                        {"p99 ns", "p99_ns", 1},
                                        {"max ns", "max_ns", 1}};

std::string bricks_name(int dimension, double slenderness) {
  if (slenderness == 1) return dimension == 2 ? "squares" : "cubes";
  return "rods " + std::to_string(static_cast<int>(slenderness)) + (dimension == 2 ? ":1" : ":1:1");
}

Json row_of(const VolumeFigure& figure) {
  const auto contacts = static_cast<double>(figure.contacts);
  const double ratio = contacts > 0 ? static_cast<double>(figure.candidates) / contacts : 0;
  return {{"family", bricks_name(figure.dimension, figure.slenderness)},
          {"setting", to_string(figure.kind)},
          {"candidates_per_contact", ratio},
          {"contacts", figure.contacts},
          {"missed", figure.missed},
          {"bound_ns", figure.bound_ns},
          {"total_ns", figure.bound_ns + figure.mean_ns},
          {"total_ns_low", figure.bound_ns + figure.low_ns},
          {"total_ns_high", figure.bound_ns + figure.high_ns},
          {"mean_ns", figure.mean_ns},
          {"median_ns", figure.median_ns},
          {"p99_ns", figure.p99_ns},
          {"max_ns", figure.max_ns}};
}

Cell cell_of(int dimension, double slenderness, std::uint32_t bricks) {
  return {"volumes of " + std::to_string(bricks) + " " + bricks_name(dimension, slenderness) + " in " +
              std::to_string(dimension) + "D",
          [=](const Poll& poll) {
            Json rows = Json::array();
            for (const VolumeFigure& figure : measure_volumes(dimension, slenderness, bricks, poll))
              rows.push_back(row_of(figure));
            return rows;
          },
          work_of(3, bricks, 100)};
}

std::vector<Cell> cells_in(int dimension, const ReportRequest& request) {
  std::vector<Cell> cells;
  for (const double slenderness : slendernesses())
    cells.push_back(cell_of(dimension, slenderness, request.sizes.objects));
  return cells;
}

std::vector<Cell> cells(const ReportRequest& request) {
  std::vector<Cell> all = cells_in(2, request);
  for (Cell& cell : cells_in(3, request)) all.push_back(std::move(cell));
  return all;
}

/// The volumes of each kind of bricks have a Pareto front of their own.
void write_dimension(int dimension, const ReportRequest& request, const CellStore& store, Page& page) {
  Plot plot{"bounding volumes in " + std::to_string(dimension) + "D: time against candidates per contact",
            kTrade.error_label,
            kTrade.time_label,
            true,
            true,
            {}};
  Json rows = Json::array();
  std::vector<bool> marked;
  for (const Cell& cell : cells_in(dimension, request)) {
    const Json& part = store.at(cell.key);
    const Plot own = plot_of(part, kTrade, "");
    plot.series.insert(plot.series.end(), own.series.begin(), own.series.end());
    rows.insert(rows.end(), part.begin(), part.end());
    for (const bool on_front : front_of(part, kTrade)) marked.push_back(on_front);
  }
  page.heading(std::to_string(dimension) + "D");
  page.figure(draw(plot, "volumes" + std::to_string(dimension)),
              std::to_string(request.sizes.objects) +
                  " bricks of unit volume at random poses, as dense as a pile, drifting and turning. A ring "
                  "marks the Pareto front of each kind of bricks.");
  page.table("all volumes of this plot", kColumns, rows, marked, true);
}

void write(const ReportRequest& request, const CellStore& store, Page& page) {
  page.paragraph(
      "A tighter volume leaves fewer candidates to the narrow phase, and costs more to make and to place. "
      "The contacts are ODE's in 3D and those of separating axes in 2D; none may be missed. The tree has the "
      "paper's parameters, with partitioners in free directions; the times of steps are the tree's.");
  write_dimension(2, request, store, page);
  write_dimension(3, request, store, page);
  page.command(command_of(request, "volumes"));
}

}  // namespace

Section volumes_section() { return {"volumes", "Bounding volumes", cells, write}; }

}  // namespace kerf
