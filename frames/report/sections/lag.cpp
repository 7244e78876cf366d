#include "frames/report/motion_cells.h"

namespace kerf {
namespace {

const Trade kTrade{"lag_mean", "mean_ns", 1, "steps until a meeting is detected, mean",
                   "ns an object and step, mean"};

const std::vector<TableColumn> kColumns{
    {"setting", "setting"},  {"mean ns", "mean_ns", 1}, {"lag mean", "lag_mean", 3},
    {"lag p99", "lag_p99"},  {"lag max", "lag_max"},    {"never detected %", "never_share", 2, 100},
    {"meetings", "meetings"}};

std::vector<Cell> cells(const ReportRequest& request) { return cells_of(motion_cells(request.sizes)); }

void write(const ReportRequest& request, const CellStore& store, Page& page) {
  page.paragraph(
      "How many steps pass from the step in which two boxes begin to overlap until the pair is reported: 0 "
      "for an exact broad phase. A meeting that ends unreported counts with all its steps; so does one that "
      "is unreported when the run ends, whose lag is longer then. So all settings have the same meetings.");
  write_motions(
      motion_cells(request.sizes), store,
      {"lag", "lag of detection", "Lower left is better; a ring marks the Pareto front.", kTrade, kColumns},
      page);
  page.command(command_of(request, "lag"));
}

}  // namespace

Section lag_section() { return {"lag", "Lag of detection", cells, write}; }

}  // namespace kerf
