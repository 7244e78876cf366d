#pragma once

#include <string>
#include <vector>

#include "frames/bench/bench_request.h"
#include "frames/bench/queries/query_cell.h"

namespace kerf {

/// The line above the rows.
std::string query_heading();
/// One row, as a line.
std::string as_text(const QueryRow& row);

/// {"machine": {...}, "settings": {...}, "queries": [rows], "complete": bool}; a row has the figures of each
/// structure.
std::string as_json(const BenchRequest& request, const std::vector<QueryRow>& rows, bool complete);

}  // namespace kerf
