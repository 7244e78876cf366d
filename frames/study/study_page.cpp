#include "frames/study/study_page.h"

#include <set>

#include "core/recording/recording_info.h"
#include "frames/page/page.h"
#include "frames/study/study_plot.h"
#include "frames/study/summary.h"

namespace kerf {
namespace {

constexpr PlottedFigure kPlots[] = {
    {"total_ms", "Total", "milliseconds a step", "Overhead and collision together."},
    {"overhead_ms", "Overhead", "milliseconds a step",
     "Taking over the boxes and bringing the structure up to date, where the broad phase measures it."},
    {"collision_ms", "Collision", "milliseconds a step", "Finding the pairs, likewise."},
    {"candidates", "Candidates", "candidates a step",
     "Pairs that the structure left to be tested, where the broad phase counts them."}};

const std::vector<TableColumn>& columns() {
  constexpr int kDigits = kShortestDigits;
  static const std::vector<TableColumn> kColumns{{"broad phase", "broad_phase"},
                                                 {"objects", "objects"},
                                                 {"cells", "cells"},
                                                 {"samples", "samples"},
                                                 {"total ms", "total_ms", kDigits},
                                                 {"±", "total_ms_half", kDigits},
                                                 {"overhead ms", "overhead_ms", kDigits},
                                                 {"±", "overhead_ms_half", kDigits},
                                                 {"collision ms", "collision_ms", kDigits},
                                                 {"±", "collision_ms_half", kDigits},
                                                 {"pairs a step", "pairs", 1},
                                                 {"candidates a step", "candidates", 1},
                                                 {"leaves", "leaves", 1},
                                                 {"height", "height", 1},
                                                 {"missed a step", "missed", kDigits},
                                                 {"extra a step", "extra", kDigits},
                                                 {"machine", "machine"}};
  return kColumns;
}

Json row_of(const Group& group) {
  Json row{{"broad_phase", group.broad_phase},
           {"objects", group.objects},
           {"cells", group.cells()},
           {"machine", group.machine}};
  for (const TableColumn& column : columns()) {
    const auto estimate = group.estimate(column.key);
    if (!estimate) continue;
    row[column.key] = estimate->mean;
    row["samples"] = estimate->samples;
    if (estimate->samples > 1) row[column.key + "_half"] = estimate->half;
  }
  return row;
}

/// Only the columns in which some row has a value.
std::vector<TableColumn> filled_columns(const Json& rows) {
  std::vector<TableColumn> filled;
  for (const TableColumn& column : columns())
    for (const Json& row : rows)
      if (row.contains(column.key)) {
        filled.push_back(column);
        break;
      }
  return filled;
}

void write_comparison(const StudyComparison& comparison, const std::string& id, Page& page) {
  page.section(id, comparison.title);
  for (const PlottedFigure& figure : kPlots) {
    const std::string svg = plot_figure(comparison, figure, id + "-" + figure.key);
    if (!svg.empty()) page.figure(svg, figure.caption);
  }
  Json rows = Json::array();
  for (const Group& group : comparison.groups) rows.push_back(row_of(group));
  page.table("Figures", filled_columns(rows), rows, {}, true);
}

std::string machines_of(const JoinedStudy& joined) {
  std::set<std::string> machines;
  for (const JoinedStudy::Cell& cell : joined.cells) machines.insert(cell.file.machine);
  std::string text;
  for (const std::string& machine : machines) text += (text.empty() ? "" : "; ") + machine;
  return text;
}

}  // namespace

std::string study_page(const Study& study, const JoinedStudy& joined, const std::string& command) {
  Page page("Study " + study.name, std::to_string(joined.cells.size()) + " of " +
                                       std::to_string(study.cells.size()) + " cells, measured on " +
                                       machines_of(joined));
  const std::string missing = describe_missing(study, joined);
  if (!missing.empty()) page.paragraph(missing);
  page.paragraph(
      "Bars are 95 % confidence intervals of the mean (Student's t). With several seeds each seed's mean "
      "over its repeats is one sample; with one seed each repeat is. Without a bar there is one sample. "
      "Curves stand a little aside of each other, so that their bars are seen.");
  page.paragraph("All settings and counts have the hash " + to_hex(counts_hash(joined)) +
                 "; it does not depend on who measured them.");
  std::size_t number = 0;
  for (const StudyComparison& comparison : comparisons(joined))
    write_comparison(comparison, "s" + std::to_string(++number), page);
  page.command(command);
  return page.html();
}

}  // namespace kerf
