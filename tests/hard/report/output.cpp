#include "tests/hard/report/output.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "frames/support/atomic_file.h"

namespace kerf::test {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Outcome& outcome) {
  const Trial& t = outcome.trial;
  Json json{{"verdict", to_string(outcome.verdict)},
            {"steps", t.steps},
            {"pairs", t.pairs},
            {"missed", t.missed},
            {"extra", t.extra},
            {"twice", t.twice},
            {"worst_step_ms", t.worst_ms},
            {"all_steps_ms", t.total_ms}};
  if (!outcome.reason.empty()) json["reason"] = outcome.reason;
  if (t.note[0] != 0) json["first"] = t.note.data();
  return json;
}

Json to_json(const Attempt& attempt, bool ours) {
  Json json = to_json(attempt.outcome);
  if (!ours) return json;
  const Trial& t = attempt.outcome.trial;
  json["config"] = attempt.config;
  json["turned_volumes"] = attempt.turned;
  json["wrong_statuses"] = t.statuses;
  json["violations"] = t.violations;
  json["height"] = t.height;
  json["entries_an_object"] = t.entries;
  json["most_operators_a_step"] = t.most_operators;
  return json;
}

Json to_json(const Column& column) {
  return {{"dimension", column.dimension},
          {"who", column.ours ? "kerf" : "rival"},
          {"name", column.name},
          {"flat", column.flat}};
}

void save(const std::filesystem::path& path, const Json& json) {
  constexpr int kIndent = 1;
  write_file_atomically(path, json.dump(kIndent) + "\n");
}

/// The part of a name before its n-th hyphen and behind the one before: "tree" is part 2 of
/// "fcl-interval-tree".
std::string_view part(std::string_view name, int n) {
  for (; n > 0; --n) {
    const std::size_t hyphen = name.find('-');
    if (hyphen == std::string_view::npos) return {};
    name.remove_prefix(hyphen + 1);
  }
  return name.substr(0, name.find('-'));
}

std::vector<std::size_t> columns_of(const Table& table, int dimension, bool ours) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i].dimension == dimension && table.columns[i].ours == ours) columns.push_back(i);
  return columns;
}

/// The names, a part a line, so that columns stay narrow.
void print_heads(const Table& table, std::span<const std::size_t> columns, bool ours) {
  constexpr int kLines = 3;
  for (int line = 0; line < kLines; ++line) {
    std::printf("%-30s", "");
    for (const std::size_t i : columns)
      std::printf(" %-9.9s", std::string(part(table.columns[i].name, line)).c_str());
    std::printf("%s\n", ours && line == kLines - 1 ? "  worst step  entries  height" : "");
  }
}

/// "1k", "=" and so on of all columns of a group, side by side.
void print_group(const Table& table, int dimension, bool ours) {
  const std::vector<std::size_t> columns = columns_of(table, dimension, ours);
  std::printf("\n%dD, %s\n", dimension,
              ours ? "kerf by volume" : "rivals (but for cases about parameters and operators of kerf)");
  print_heads(table, columns, ours);
  for (const Row& row : table.rows) {
    if (!ours && row.hard_case->ours_only) continue;
    std::printf("%-4s %-25.25s", row.hard_case->id.data(), row.hard_case->name.data());
    Outcome worst;
    for (const std::size_t i : columns) {
      std::printf(" %-9s", symbol(row.cells[i].worst).c_str());
      worst = worse(worst, row.cells[i].worst);
    }
    if (ours)
      std::printf(" %9.2f ms %8.2f %7u", worst.trial.worst_ms, worst.trial.entries, worst.trial.height);
    std::printf("\n");
  }
}

}  // namespace

void print(const Table& table) {
  std::printf(
      "= exact   +n extra   2xn reported twice   !n wrong status or unsound   -n missed   X crash\n"
      "T time-out (%u s of processor time in steps)   t not tried: timed out in 2D\n",
      Limits{}.seconds);
  for (const int dimension : {2, 3})
    for (const bool ours : {true, false}) print_group(table, dimension, ours);
}

void write_json(const std::filesystem::path& path, const Table& table) {
  Json columns = Json::array();
  for (const Column& column : table.columns) columns.push_back(to_json(column));
  Json rows = Json::array();
  for (const Row& row : table.rows) {
    Json cells = Json::array();
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      Json cell{{"verdict", to_string(row.cells[i].worst.verdict)}, {"sign", symbol(row.cells[i].worst)}};
      if (row.cells[i].worst.inferred) cell["reason"] = row.cells[i].worst.reason;
      cell["attempts"] = Json::array();
      for (const Attempt& attempt : row.cells[i].attempts)
        cell["attempts"].push_back(to_json(attempt, table.columns[i].ours));
      cells.push_back(std::move(cell));
    }
    rows.push_back({{"id", row.hard_case->id},
                    {"name", row.hard_case->name},
                    {"what", row.hard_case->what},
                    {"cells", std::move(cells)}});
  }
  save(path, {{"columns", std::move(columns)}, {"cases", std::move(rows)}});
}

}  // namespace kerf::test
