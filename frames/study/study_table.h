#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frames/study/join.h"

namespace kerf {

/// All cells in one table, a row each, in the order of the study: its id, its settings, its counts, its times
/// ("time_total_ms") and its machine. So all columns before the first that begins with "time_" are the same,
/// byte for byte, on each machine. A value that a cell does not have is null.
struct StudyTable {
  std::vector<std::string> columns;
  std::vector<std::vector<Json>> rows;
};
StudyTable table_of(const JoinedStudy& joined);

std::string to_csv(const StudyTable& table);
/// Writes an SQLite database with the table "cells" into a file that is there and empty. Throws
/// std::runtime_error.
void write_sqlite(const StudyTable& table, const std::filesystem::path& file);

}  // namespace kerf
