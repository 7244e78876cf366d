#include "viz/debugger/model/figure_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/shortest_text.h"
#include "core/query/text.h"
#include "viz/debugger/model/node_figures.h"

namespace kerf {
namespace {

constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kVerdictColumn = "verdict";  // its figures stand for words
constexpr std::string_view kStepColumn = "step";        // its figures are our numbers, by which it is ordered
constexpr std::string_view kMovesColumn = "moves";      // the same

bool has_word(const FigureTable::Row& row, const std::string& text, bool whole) {
  const auto fits = [&](const std::string& word) { return whole ? word == text : word.starts_with(text); };
  return fits(row.name) || std::ranges::any_of(row.words, fits);
}

/// Numbers by their size, those that are none at the end.
bool is_before(double a, double b, bool falling) {
  if (std::isnan(a) || std::isnan(b)) return !std::isnan(a) && std::isnan(b);
  return falling ? b < a : a < b;
}

std::string verdict_name(double figure) {
  return std::string(to_string(static_cast<PairVerdict>(static_cast<int>(figure))));
}

/// What a figure of some columns stands for; empty: for itself.
std::string word_for(double figure, const std::string& column) {
  if (column == kVerdictColumn) return verdict_name(figure);
  if (column == kMovesColumn) return figure != 0 ? "yes" : "no";
  return "";
}

std::string exact_text(double figure, const std::string& column) {
  if (std::isnan(figure)) return "";
  const std::string word = word_for(figure, column);
  return word.empty() ? shortest_text(figure) : word;
}

FigureTable::Row row_of_pair(Run& run, const Pair& pair, const PairFigures& figures) {
  const TreeSnapshot& tree = run.tree();
  const GivenNames& names = run.names();
  FigureTable::Row row{pair, names.pair(pair), {names.object(pair.a), names.object(pair.b)}, {}};
  const bool has_leaf = tree.is_alive(figures.leaf);
  if (has_leaf) row.words.push_back(node_text(figures.leaf));
  const auto of_leaf = [&](std::uint32_t figure) {
    return has_leaf ? static_cast<double>(figure) : kNoFigure;
  };
  row.figures = {of_leaf(figures.leaf.value), of_leaf(has_leaf ? tree[figures.leaf].population : 0),
                 figures.overlap, static_cast<double>(figures.age)};
  return row;
}

}  // namespace

FigureTable table_of_nodes(Run& run) {
  FigureTable table{{"node", "depth", "population", "balance", "cut %", "cost", "age"}, {}};
  const TreeSnapshot& tree = run.tree();
  const auto changes = last_changes(run.operators(), run.position(), tree.nodes().size());
  const auto figures = find_figures({tree, run.position().step, changes});
  for (std::uint32_t k = 0; k < tree.nodes().size(); ++k) {
    const NodeId id{k};
    if (!tree.is_alive(id)) continue;
    const bool is_leaf = tree[id].is_leaf();
    const NodeFigures& of = figures[k];
    table.rows.push_back(
        {id,
         node_text(id),
         {std::to_string(k), is_leaf ? "leaf" : "partitioner"},
         {static_cast<double>(tree[id].depth), of.population, is_leaf ? kNoFigure : of.balance,
          is_leaf ? kNoFigure : 100 * of.redundancy, of.cost, of.age}});
  }
  return table;
}

FigureTable table_of_pairs(Run& run) {
  FigureTable table{{"pair", "leaf", "population", "overlap", "age"}, {}};
  const std::vector<PairFigures> figures = run.pair_figures();
  const std::span<const Pair> pairs = run.pairs();
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return pairs[k]; });
  for (const std::size_t k : order) table.rows.push_back(row_of_pair(run, pairs[k], figures[k]));
  return table;
}

FigureTable table_of_objects(Run& run) {
  constexpr std::string_view kAxes = "xyz";
  FigureTable table{{"object", "leaves", "pairs", std::string(kMovesColumn)}, {}};
  const auto axes = static_cast<std::size_t>(run.info().dimension);
  for (const char axis : kAxes.substr(0, axes)) table.columns.emplace_back(1, axis);
  for (const char axis : kAxes.substr(0, axes)) table.columns.push_back(std::string("size ") + axis);
  for (const ObjectFigures& of : run.object_figures()) {
    FigureTable::Row row{of.object,
                         run.info().marks.title(of.object, run.names().object(of.object)),
                         {of.is_fixed ? "fixed" : "moving"},
                         {}};
    row.figures = {static_cast<double>(of.leaves), static_cast<double>(of.pairs), of.is_fixed ? 0.0 : 1.0};
    row.figures.insert(row.figures.end(), of.centre.begin(), of.centre.end());
    row.figures.insert(row.figures.end(), of.size.begin(), of.size.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

FigureTable table_of_errors(Run& run) {
  FigureTable table{{"pair", "step", "verdict"}, {}};
  const GivenNames& names = run.names();
  const std::vector<WrongPair>& wrong = run.wrong_pairs();
  std::vector<std::size_t> order(std::min(kMostErrorRows, wrong.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return wrong[k].pair; });
  for (const std::size_t k : order) {
    const auto& [step, pair, verdict] = wrong[k];
    table.rows.push_back({pair,
                          names.pair(pair),
                          {names.object(pair.a), names.object(pair.b), std::string(to_string(verdict))},
                          {static_cast<double>(step), static_cast<double>(verdict)},
                          k,
                          names.step(step)});
  }
  return table;
}

FigureTable make_table(Run& run, TableOf of) {
  switch (of) {
    case TableOf::nodes:
      return table_of_nodes(run);
    case TableOf::pairs:
      return table_of_pairs(run);
    case TableOf::objects:
      return table_of_objects(run);
    case TableOf::errors:
      break;
  }
  return table_of_errors(run);
}

std::vector<std::size_t> find_rows(const FigureTable& table, const std::string& text,
                                   const TableOrder& order) {
  const auto has = [&](bool whole) {
    return [&text, whole](const FigureTable::Row& row) { return has_word(row, text, whole); };
  };
  const bool whole = std::ranges::any_of(table.rows, has(true));
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < table.rows.size(); ++k)
    if (text.empty() || has_word(table.rows[k], text, whole)) rows.push_back(k);
  if (order.column == 0) {
    if (order.falling) std::ranges::reverse(rows);
    return rows;
  }
  const auto figure = [&](std::size_t row) { return table.rows[row].figures[order.column - 1]; };
  std::ranges::stable_sort(
      rows, [&](std::size_t a, std::size_t b) { return is_before(figure(a), figure(b), order.falling); });
  return rows;
}

std::string cell_text(const FigureTable& table, std::size_t row, std::size_t column) {
  const FigureTable::Row& of = table.rows[row];
  if (column == 0) return of.name;
  const double figure = of.figures[column - 1];
  if (std::isnan(figure)) return "-";
  if (table.columns[column] == kStepColumn) return of.step;
  if (table.columns[column] == "leaf") return node_text(NodeId{static_cast<std::uint32_t>(figure)});
  if (std::string word = word_for(figure, table.columns[column]); !word.empty()) return word;
  const bool is_of_pair = table.columns[0] == "pair";
  if (is_of_pair && table.columns[column] == "age" && figure >= kOldestPair) return number_text(figure) + "+";
  return number_text(std::round(figure * 1000) / 1000);
}

TextTable to_texts(const FigureTable& table, const std::vector<std::size_t>& rows) {
  TextTable texts{table.columns, {}};
  for (const std::size_t row : rows) {
    std::vector<std::string> cells{table.rows[row].name};
    for (std::size_t k = 1; k < table.columns.size(); ++k)
      cells.push_back(exact_text(table.rows[row].figures[k - 1], table.columns[k]));
    texts.rows.push_back(std::move(cells));
  }
  return texts;
}

void TableKeeper::update(Run& run, const TableWish& wish) {
  const bool is_now = wish.of == TableOf::errors || position_ == run.position();
  const bool is_kept = run_ == &run && is_now && wish_.of == wish.of;
  if (is_kept && wish_ == wish) return;
  if (!is_kept) table_ = make_table(run, wish.of);
  rows_ = find_rows(table_, wish.text, wish.order);
  run_ = &run;
  position_ = run.position();
  wish_ = wish;
}

}  // namespace kerf
