#pragma once

#include <string>
#include <vector>

#include "frames/bench/bench_cell.h"
#include "frames/bench/bench_request.h"

namespace kerf {

/// The line above the rows.
std::string bench_heading();
/// One row, as a line.
std::string as_text(const BenchRow& row);
std::string as_text(const BenchGap& gap);

/// {"machine": {...}, "settings": {...}, "results": [rows], "gaps": [...], "complete": bool}
std::string as_json(const BenchRequest& request, const CellResult& all, bool complete);

}  // namespace kerf
