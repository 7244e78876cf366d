#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/hard/cases.h"
#include "tests/hard/report/children.h"
#include "tests/hard/report/verdict.h"

namespace kerf::test {

/// A column: our tree with one kind of volume, or a rival, in one dimension.
struct Column {
  int dimension = 2;
  bool ours = true;
  bool flat = false;  ///< a 3D rival that is shown 2D boxes as slabs
  std::string name;   ///< the volume or the rival
};

/// One of the ways in which our tree was tried for a cell.
struct Attempt {
  std::string config;
  bool turned = false;  ///< with turned volumes instead of boxes
  Outcome outcome;
};

/// Our attempts, of which the worst counts; a rival has one.
struct TableCell {
  Outcome worst;
  std::vector<Attempt> attempts;
};

struct Row {
  const HardCase* hard_case = nullptr;
  std::vector<TableCell> cells;  ///< one a column
};

struct Table {
  std::vector<Column> columns;
  std::vector<Row> rows;
};

/// The columns of both dimensions: our volumes, then the rivals.
std::vector<Column> all_columns();

/// Tries all columns on the cases whose id or name contains `only` (all if it is empty). Our boxes and the
/// rivals play the cases in the report's size, our other volumes in the tests' size. `progress` is called
/// with each case.
Table make_table(std::string_view only, const Limits& limits, unsigned at_once,
                 const std::function<void(const HardCase&)>& progress);

}  // namespace kerf::test
