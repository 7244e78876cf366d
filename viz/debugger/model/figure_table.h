#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viz/debugger/model/run.h"
#include "viz/debugger/model/text_table.h"

namespace kerf {

/// What a table lists.
enum class TableOf : std::uint8_t { nodes, pairs, objects, errors };
inline constexpr std::array<std::string_view, 4> kTableNames{"nodes", "pairs", "objects", "errors"};

/// Nodes, pairs or objects of a moment, or the wrong pairs of a run, in rows of figures.
struct FigureTable {
  struct Row {
    Selection item;
    std::string name;                         ///< "n17" or "12,77": what the first column shows
    std::vector<std::string> words;           ///< other texts by which it is found
    std::vector<double> figures;              ///< one for each further column; not a number: there is none
    std::optional<std::size_t> wrong_pair{};  ///< its number among the run's, in a table of errors
    std::string step{};                       ///< as it was given, in a table of errors
  };
  std::vector<std::string> columns;
  std::vector<Row> rows;  ///< by id, then by step
};

/// The living nodes: depth, population, balance, straddlers in percent, cost, age (see NodeFigures).
FigureTable table_of_nodes(Run& run);
/// The pairs: leaf in which they are compared, its population, the least overlap of the boxes, steps since
/// they became one (see PairFigures).
FigureTable table_of_pairs(Run& run);
/// The objects: their leaves, pairs, whether they move, centre and size of the box on each axis (see
/// ObjectFigures).
FigureTable table_of_objects(Run& run);

/// At most so many errors have a row: each takes some memory.
inline constexpr std::size_t kMostErrorRows = 100'000;
/// The wrong pairs of an import, of its first steps if they are more than `kMostErrorRows`: step and verdict.
FigureTable table_of_errors(Run& run);
FigureTable make_table(Run& run, TableOf of);

/// By which column rows are ordered.
struct TableOrder {
  std::size_t column = 0;
  bool falling = false;
  friend bool operator==(const TableOrder&, const TableOrder&) = default;
};

/// The rows that are found by a text, in an order: those with a word that is the text, or, if there is none,
/// those with a word that begins with it; all for an empty text. Rows without a figure come last.
std::vector<std::size_t> find_rows(const FigureTable& table, const std::string& text,
                                   const TableOrder& order);

/// What a cell shows.
std::string cell_text(const FigureTable& table, std::size_t row, std::size_t column);
/// The rows as texts, with all digits.
TextTable to_texts(const FigureTable& table, const std::vector<std::size_t>& rows);

/// What a table lists, and in which order.
struct TableWish {
  TableOf of = TableOf::nodes;
  std::string text;
  TableOrder order;
  friend bool operator==(const TableWish&, const TableWish&) = default;
};

/// Keeps a table until the run or, unless it is of the whole run, its moment changes, and its rows until
/// something else is wished.
class TableKeeper {
 public:
  void update(Run& run, const TableWish& wish);
  [[nodiscard]] const FigureTable& table() const { return table_; }
  [[nodiscard]] const std::vector<std::size_t>& rows() const { return rows_; }

 private:
  const Run* run_ = nullptr;
  Position position_;
  TableWish wish_;
  FigureTable table_;
  std::vector<std::size_t> rows_;
};

}  // namespace kerf
