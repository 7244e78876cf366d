#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "frames/bench/bench_cell.h"
#include "frames/bench/bench_request.h"
#include "frames/bench/loop_cell.h"

namespace kerf {

/// The line above the rows.
std::string bench_heading();
/// One row, as a line.
std::string as_text(const BenchRow& row);
std::string as_text(const BenchGap& gap);

/// A row and a gap as the JSON files have them.
nlohmann::ordered_json as_json(const BenchRow& row);
nlohmann::ordered_json as_json(const BenchGap& gap);

/// All that a run has measured so far.
struct BenchResult {
  CellResult cells;
  std::vector<LoopRow> loops;
};

/// {"machine": {...}, "settings": {...}, "results": [rows], "gaps": [...], "simulations": [rows],
/// "earnings": [...], "complete":
/// bool}
std::string as_json(const BenchRequest& request, const BenchResult& all, bool complete);

}  // namespace kerf
