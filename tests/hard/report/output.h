#pragma once

#include <filesystem>

#include "tests/hard/report/table.h"

namespace kerf::test {

/// To the standard output: ours case by case with the worst figures, then the rivals' signs.
void print(const Table& table);

/// Throws std::runtime_error, with path and reason, when the file cannot be written.
void write_json(const std::filesystem::path& path, const Table& table);

}  // namespace kerf::test
