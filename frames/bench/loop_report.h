#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "frames/bench/loop_cell.h"

namespace kerf {

/// The line above the rows.
std::string loop_heading();
/// One row, as a line.
std::string as_text(const LoopRow& row);
nlohmann::ordered_json as_json(const LoopRow& row);

}  // namespace kerf
