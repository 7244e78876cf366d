#include "viz/debugger/model/text_table.h"

#include <algorithm>

namespace kerf {

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string to_csv(const TextTable& table) {
  std::string csv;
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t k = 0; k < row.size(); ++k) csv += (k > 0 ? "," : "") + csv_text(row[k]);
    csv += '\n';
  };
  add(table.columns);
  std::ranges::for_each(table.rows, add);
  return csv;
}

std::string to_text(const TextTable& table) {
  std::vector<std::size_t> widths(table.columns.size());
  const auto widen = [&](const std::vector<std::string>& row) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  };
  widen(table.columns);
  std::ranges::for_each(table.rows, widen);
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      line += row[k];
      line.append(widths[k] - row[k].size() + 2, ' ');
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  };
  add(table.columns);
  std::ranges::for_each(table.rows, add);
  return text;
}

}  // namespace kerf
