#include "frames/study/study_table.h"

#include <algorithm>

#include "core/recording/database.h"

namespace kerf {
namespace {

/// The keys of the objects, in the order of their first appearance.
template <class Part>
std::vector<std::string> keys_of(const JoinedStudy& joined, Part part) {
  std::vector<std::string> keys;
  for (const JoinedStudy::Cell& cell : joined.cells)
    for (const auto& [key, value] : part(cell.file).items())
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  return keys;
}

const Json& settings(const CellFile& file) { return file.settings; }
const Json& counts(const CellFile& file) { return file.figures.counts; }
const Json& times(const CellFile& file) { return file.figures.times; }

void add_values(const Json& object, const std::vector<std::string>& keys, std::vector<Json>& row) {
  for (const std::string& key : keys) row.push_back(object.value(key, Json()));
}

std::string csv_field(const Json& value) {
  if (value.is_null()) return "";
  if (!value.is_string()) return value.dump();
  std::string text = value.get<std::string>();
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

template <class Row, class Field>
std::string csv_line(const Row& row, Field field) {
  std::string line;
  for (std::size_t k = 0; k < row.size(); ++k) line += (k == 0 ? "" : ",") + field(row[k]);
  return line + "\n";
}

void bind(Statement& statement, int place, const Json& value) {
  if (value.is_number_float())
    statement.bind(place, value.get<double>());
  else if (value.is_number())
    statement.bind(place, value.get<std::int64_t>());
  else if (value.is_string())
    statement.bind(place, std::string_view(value.get_ref<const std::string&>()));
}

}  // namespace

StudyTable table_of(const JoinedStudy& joined) {
  const auto of_settings = keys_of(joined, settings);
  const auto of_counts = keys_of(joined, counts);
  const auto of_times = keys_of(joined, times);
  StudyTable table;
  table.columns = {"id"};
  for (const auto* keys : {&of_settings, &of_counts})
    table.columns.insert(table.columns.end(), keys->begin(), keys->end());
  for (const std::string& key : of_times) table.columns.push_back("time_" + key);
  table.columns.emplace_back("machine");
  for (const JoinedStudy::Cell& cell : joined.cells) {
    std::vector<Json>& row = table.rows.emplace_back();
    row.emplace_back(cell.file.id);
    add_values(settings(cell.file), of_settings, row);
    add_values(counts(cell.file), of_counts, row);
    add_values(times(cell.file), of_times, row);
    row.emplace_back(cell.file.machine);
  }
  return table;
}

std::string to_csv(const StudyTable& table) {
  std::string text = csv_line(table.columns, [](const std::string& name) { return name; });
  for (const auto& row : table.rows) text += csv_line(row, csv_field);
  return text;
}

void write_sqlite(const StudyTable& table, const std::filesystem::path& file) {
  Database database = Database::create(file);
  std::string names;
  std::string places;
  for (const std::string& column : table.columns) {
    names += (names.empty() ? "\"" : ", \"") + column + "\"";
    places += places.empty() ? "?" : ", ?";
  }
  database.execute("BEGIN; CREATE TABLE cells (" + names + ")");
  {
    Statement insert = database.prepare("INSERT INTO cells VALUES (" + places + ")");
    for (const auto& row : table.rows) {
      insert.clear();
      for (std::size_t k = 0; k < row.size(); ++k) bind(insert, static_cast<int>(k) + 1, row[k]);
      insert.run();
    }
  }
  database.execute("COMMIT");
  database.keep();
  database.close();
}

}  // namespace kerf
