#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "core/query/text.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/debugger/model/figure_table.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

class DebuggerTables : public testing::Test {
 protected:
  DebuggerTables() { run().go(Position::end_of(60)); }
  [[nodiscard]] kerf::Run& run() { return driver_.debugger().model().run(); }
  [[nodiscard]] TimelineDriver& driver() { return driver_; }

 private:
  TimelineDriver driver_;
};

std::size_t column_of(const FigureTable& table, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(table.columns, name) - table.columns.begin());
}

double figure(const FigureTable& table, std::size_t row, const std::string& name) {
  return table.rows[row].figures[column_of(table, name) - 1];
}

TEST_F(DebuggerTables, FiguresOfNodesAreThoseOfTheTree) {
  const FigureTable table = table_of_nodes(run());
  const TreeSnapshot& tree = run().tree();
  double cost = 0;
  std::size_t leaves = 0;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const NodeId id = *node_in(table.rows[k].item);
    EXPECT_EQ(figure(table, k, "population"), tree[id].population);
    EXPECT_EQ(std::isnan(figure(table, k, "balance")), tree[id].is_leaf());
    if (!tree[id].is_leaf()) continue;
    cost += figure(table, k, "cost");
    ++leaves;
  }
  EXPECT_EQ(leaves, tree.leaves());
  EXPECT_EQ(figure(table, find_rows(table, "n0", {})[0], "cost"), cost);
}

/// Figures of a narrow table were cut anywhere: 3676.5 read as 36 or as 3676.
TEST_F(DebuggerTables, WhatIsCutSaysSo) {
  EXPECT_EQ(driver().play("click \"tab Tables\"\ndrag \"divider right\" 1099,300\nwait 2"), "");
  const FigureTable table = table_of_nodes(run());
  std::size_t cut = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (std::size_t column = 1; column < table.columns.size(); ++column)
      for (std::size_t letters = 0; letters < cell_text(table, row, column).size(); ++letters)
        cut += driver().debugger().gui().find(cell_text(table, row, column).substr(0, letters) + "...") ? 1U
                                                                                                        : 0U;
  EXPECT_GT(cut, 0U);
}

TEST_F(DebuggerTables, FiguresOfObjectsAreThoseOfTreeAndPairs) {
  const FigureTable table = table_of_objects(run());
  EXPECT_EQ(table.rows.size(), run().objects());
  double pairs = 0;
  double entries = 0;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    pairs += figure(table, k, "pairs");
    entries += figure(table, k, "leaves");
    const ObjectId object = *object_in(table.rows[k].item);
    EXPECT_EQ(figure(table, k, "leaves"), static_cast<double>(run().leaves_of(object).size()));
    EXPECT_GE(figure(table, k, "size x"), 0);
  }
  EXPECT_EQ(pairs, 2.0 * static_cast<double>(run().pairs().size()));
  EXPECT_GE(entries, static_cast<double>(run().objects()));
  const std::size_t first = find_rows(table, "fixed", {})[0];
  EXPECT_EQ(cell_text(table, first, column_of(table, "moves")), "no");
  EXPECT_EQ(to_texts(table, {first}).rows[0][column_of(table, "moves")], "no");
}

TEST_F(DebuggerTables, AgesAreTheStepsSinceAnOperatorActed) {
  const FigureTable table = table_of_nodes(run());
  const TreeSnapshot& tree = run().tree();
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const NodeId id = *node_in(table.rows[k].item);
    const NodeId of = tree[id].is_leaf() && !tree[id].parent.is_none() ? tree[id].parent : id;
    std::uint32_t last = 0;
    for (const OperatorRow& row : run().operators())
      if (row.kind == OperatorRow::Kind::acted && row.node.node == of) last = row.step;
    EXPECT_EQ(figure(table, k, "age"), 60 - last) << table.rows[k].name;
  }
}

TEST_F(DebuggerTables, RowsAreFoundByAnIdOrALeadingText) {
  const FigureTable table = table_of_nodes(run());
  EXPECT_EQ(find_rows(table, "", {}).size(), table.rows.size());
  EXPECT_EQ(find_rows(table, "leaf", {}).size(), run().tree().leaves());
  EXPECT_EQ(find_rows(table, "le", {}).size(), run().tree().leaves());
  ASSERT_EQ(find_rows(table, "n1", {}).size(), 1U);  // not n10
  EXPECT_EQ(find_rows(table, "1", {}), find_rows(table, "n1", {}));
  EXPECT_TRUE(find_rows(table, "x", {}).empty());
}

TEST_F(DebuggerTables, RowsAreOrderedByAColumn) {
  const FigureTable table = table_of_nodes(run());
  for (const std::string& name : table.columns)
    for (const bool falling : {false, true}) {
      const std::size_t column = column_of(table, name);
      const auto rows = find_rows(table, "", {column, falling});
      ASSERT_EQ(rows.size(), table.rows.size());
      for (std::size_t k = 1; column > 0 && k < rows.size(); ++k) {
        const double a = figure(table, rows[k - 1], name);
        const double b = figure(table, rows[k], name);
        EXPECT_TRUE(std::isnan(b) || (falling ? a >= b : a <= b)) << name;
      }
    }
  EXPECT_EQ(table.rows[find_rows(table, "", {0, true}).back()].name, table.rows[0].name);
}

TEST_F(DebuggerTables, PairsHaveTheirLeafAndTheirAge) {
  const FigureTable table = table_of_pairs(run());
  ASSERT_EQ(table.rows.size(), run().pairs().size());
  ASSERT_GT(table.rows.size(), 10U);
  double youngest = 1e9;
  double oldest = 0;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const Pair pair = std::visit(Overloaded{[](const Pair& item) { return item; },
                                            NothingFor<Pair, std::monostate, NodeId, ObjectId>()},
                                 table.rows[k].item);
    const NodeId leaf{static_cast<std::uint32_t>(figure(table, k, "leaf"))};
    EXPECT_THAT(run().leaves_of(pair.a), testing::Contains(leaf));
    EXPECT_THAT(run().leaves_of(pair.b), testing::Contains(leaf));
    EXPECT_GE(figure(table, k, "overlap"), 0);
    EXPECT_EQ(figure(table, k, "age"), 60 - run().history(pair).back().step) << table.rows[k].name;
    youngest = std::min(youngest, figure(table, k, "age"));
    oldest = std::max(oldest, figure(table, k, "age"));
  }
  EXPECT_LT(youngest, oldest);
}

/// Within a step the boxes have moved, and the pairs are those of the step before.
TEST_F(DebuggerTables, WithinAStepPairsAreSaidToBeOfTheStepBefore) {
  run().go(run().search(Expression::parse("op==split && kind==acted && step>40"), {}, true, {}).value());
  const std::uint32_t step = run().position().step;
  const std::string note = "pairs of step " + std::to_string(step - 1);
  const FigureTable table = table_of_pairs(run());
  for (std::size_t k = 0; k < table.rows.size(); ++k)
    EXPECT_FALSE(figure(table, k, "overlap") < 0) << table.rows[k].name;
  EXPECT_EQ(driver().play("key shift+T\nwait 2"), "");
  EXPECT_TRUE(driver().debugger().gui().find(note + ", boxes of this moment").has_value());
  EXPECT_EQ(driver().debugger().view().counts().pairs_note, note.substr(5));
  run().go(Position::end_of(step));
  EXPECT_EQ(driver().play("wait 2"), "");
  EXPECT_FALSE(driver().debugger().gui().find(note + ", boxes of this moment").has_value());
  EXPECT_EQ(driver().debugger().view().counts().pairs_note, "");
}

/// The depth of the overlap of boxes that are apart would be less than 0.
TEST_F(DebuggerTables, BoxesThatHaveComeApartWithinAStepHaveNoOverlap) {
  const auto pairs_after = [&](std::uint32_t step) {
    run().go(Position::end_of(step));
    std::vector<Pair> pairs(run().pairs().begin(), run().pairs().end());
    std::ranges::sort(pairs);
    return pairs;
  };
  std::vector<Pair> ended;
  std::uint32_t step = 10;
  for (; ended.empty() && step < 60; ++step)
    std::ranges::set_difference(pairs_after(step - 1), pairs_after(step), std::back_inserter(ended));
  ASSERT_FALSE(ended.empty());
  run().go(run()
               .search(Expression::parse("kind==phase && phase==sweep"), Position::end_of(step - 2), true, {})
               .value());
  ASSERT_EQ(run().position().step, step - 1);
  const FigureTable table = table_of_pairs(run());
  const auto row = std::ranges::find(table.rows, run().names().pair(ended[0]), &FigureTable::Row::name);
  ASSERT_NE(row, table.rows.end());
  const auto at = static_cast<std::size_t>(row - table.rows.begin());
  EXPECT_TRUE(std::isnan(figure(table, at, "overlap")));
  EXPECT_EQ(cell_text(table, at, column_of(table, "overlap")), "-");
}

TEST(DebuggerTablesOfALongRun, OlderPairsAreAsOldAsCanBeSeen) {
  TimelineDriver driver(test::LongRun{kOldestPair + 40});
  kerf::Run& run = driver.debugger().model().run();
  run.go(Position::end_of(30));
  EXPECT_EQ(figure(table_of_pairs(run), 0, "age"), 29);
  run.go(Position::end_of(kOldestPair + 40));
  const FigureTable table = table_of_pairs(run);
  EXPECT_EQ(figure(table, 0, "age"), kOldestPair);
  EXPECT_EQ(cell_text(table, 0, column_of(table, "age")), "100+");
}

TEST_F(DebuggerTables, CsvHasAllRowsAndQuotedPairs) {
  const FigureTable table = table_of_pairs(run());
  const std::string csv = to_csv(to_texts(table, {0}));
  EXPECT_THAT(csv, HasSubstr("pair,leaf,population,overlap,age\n\"" + table.rows[0].name + "\","));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 2);
  EXPECT_EQ(std::ranges::count(csv, ','), 9);
}

TEST_F(DebuggerTables, KeysAndMouseInTheTab) {
  EXPECT_EQ(driver().play(R"(
key T
expect table == nodes
click "sort population"
expect table_first == n0
click "sort population"
expect table_first != n0
click "sort node"
hover "row n1"
expect hovered_node == n1
click "row n1"
expect selection == n1
click "find in table"
type n1
wait 2
expect table_rows == 1
click "copy table"
expect copied ~ "node,depth,population,balance,cut %,cost,age"
expect copied ~ "n1,"
expect message == "copied 1 row as CSV"
key escape
key shift+T
expect table == pairs
click "table nodes"
expect table == nodes
)"),
            "");
  const auto copied = driver().debugger().take_copied();
  ASSERT_TRUE(copied.has_value());
  EXPECT_THAT(*copied, HasSubstr("n1,"));
  EXPECT_FALSE(driver().debugger().take_copied().has_value());
}

TEST_F(DebuggerTables, ARowOfWhatIsSelectedElsewhereIsSeen) {
  const FigureTable table = table_of_nodes(run());
  const std::string last = table.rows.back().name;
  EXPECT_EQ(driver().play("key T\nwait 2"), "");
  EXPECT_FALSE(driver().debugger().gui().find("row " + last).has_value());
  driver().debugger().model().select(table.rows.back().item);
  EXPECT_EQ(driver().play("wait 3"), "");
  EXPECT_TRUE(driver().debugger().gui().find("row " + last).has_value());
}

}  // namespace
}  // namespace kerf::test
