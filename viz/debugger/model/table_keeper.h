#pragma once

#include <string>
#include <vector>

#include "viz/debugger/model/figure_table.h"

namespace kerf {

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
