#include "frames/import/given_pairs.h"

#include <map>
#include <string>

#include "frames/support/errors.h"

namespace kerf {
namespace {

std::vector<CsvColumn> object_columns() {
  std::vector<CsvColumn> columns{{"a", {"i", "first"}}, {"b", {"j", "second"}}};
  const auto add = [&](const std::string& letter, const std::string& digit,
                       std::vector<std::string>& aliases) {
    for (const std::string what : {"object", "id", "body", "proxy", "handle", "entity", "objectid", "bodyid"})
      for (const std::string& name : {what + letter, letter + what, what + digit}) aliases.push_back(name);
  };
  add("a", "1", columns[0].aliases);
  add("b", "2", columns[1].aliases);
  return columns;
}

std::vector<CsvColumn> pair_columns() {
  std::vector<CsvColumn> columns = object_columns();
  columns.push_back(step_column());
  return columns;
}

constexpr std::size_t kStepOfPair = 2;

/// Without a heading the columns stand in this order, all of them.
void settle_columns(CsvTable& table, const std::vector<std::size_t>& order, const std::string& form) {
  if (table.is_empty() && !table.has_heading())
    throw UsageError(table.name() + " is empty; a table without pairs has at least its heading, " + form);
  if (!table.has_heading()) {
    if (table.first_width() != order.size()) {
      (void)table.next();
      table.reject("its columns are " + form + ", and this line has " + std::to_string(table.first_width()));
    }
    table.set_order(order, order.size());
  }
  for (const std::size_t column : order)
    if (!table.has(column))
      throw UsageError(table.name() + ": the heading must be " + form + " in any order; it has " +
                       table.names());
}

GivenPair read_pair(const CsvTable& table) {
  const GivenPair pair{table.id(0), table.id(1), table.line()};
  if (pair.a == pair.b) table.reject("object " + to_string(pair.a) + " makes no pair with itself");
  return pair;
}

}  // namespace

std::vector<GivenPairs> read_given_pairs(const std::filesystem::path& path, Oddities& oddities) {
  CsvTable table(path, pair_columns());
  settle_columns(table, {kStepOfPair, 0, 1}, "step,a,b");
  std::map<long double, GivenPairs> by_time;
  while (table.next()) {
    GivenStep step = read_step(table, kStepOfPair);
    const auto [found, is_new] = by_time.try_emplace(step.time);
    if (is_new) {
      found->second.step = std::move(step);
    } else if (const std::string conflict = conflict_of(step, found->second.step); !conflict.empty()) {
      table.reject(conflict);
    }
    found->second.pairs.push_back(read_pair(table));
  }
  note_cut(table, oddities);
  std::vector<GivenPairs> steps;
  for (auto& [time, pairs] : by_time) steps.push_back(std::move(pairs));
  return steps;
}

std::vector<GivenPair> read_ignored_pairs(const std::filesystem::path& path, Oddities& oddities) {
  CsvTable table(path, object_columns());
  settle_columns(table, {0, 1}, "a,b");
  std::vector<GivenPair> pairs;
  while (table.next()) pairs.push_back(read_pair(table));
  note_cut(table, oddities);
  return pairs;
}

}  // namespace kerf
