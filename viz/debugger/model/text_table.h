#pragma once

#include <string>
#include <vector>

namespace kerf {

/// Rows of texts, one for each column.
struct TextTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// A value as a spreadsheet reads it: in quotes if it has commas, quotes or ends of lines.
std::string csv_text(const std::string& text);
/// Comma-separated values: a line of column names, then a line for each row.
std::string to_csv(const TextTable& table);
/// For people: columns of equal width, two spaces between them.
std::string to_text(const TextTable& table);

}  // namespace kerf
