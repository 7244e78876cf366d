#include "frames/support/csv_table.h"

#include <gmock/gmock.h>

#include <fstream>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Rows = std::vector<std::vector<std::string>>;

class CsvTest : public ::testing::Test {
 protected:
  std::string write(const std::string& text) const {
    std::ofstream(path(), std::ios::binary) << text;
    return path();
  }
  /// Fields of all lines, and where each line begins.
  Rows read(const std::string& text) {
    CsvReader reader(write(text));
    Rows rows;
    lines_.clear();
    while (reader.next()) {
      std::vector<std::string>& row = rows.emplace_back();
      for (std::size_t k = 0; k < reader.columns(); ++k) row.emplace_back(reader.field(k));
      lines_.push_back(reader.line());
    }
    return rows;
  }
  std::string refusal(const std::string& text) {
    try {
      (void)read(text);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }
  [[nodiscard]] std::string path() const { return folder_.path() / "table.csv"; }

  test::TemporaryFolder folder_;
  std::vector<std::size_t> lines_;
};

TEST_F(CsvTest, FieldsAreCutAsRfc4180Says) {
  EXPECT_EQ(read("1,2\n"), (Rows{{"1", "2"}}));
  EXPECT_EQ(read("\"1\",\"a,b\",\"say \"\"so\"\"\",\"\",x"), (Rows{{"1", "a,b", "say \"so\"", "", "x"}}));
  EXPECT_EQ(read(" 1\t, \"2\" ,3 \n"), (Rows{{"1", "2", "3"}}));
  EXPECT_EQ(read("1,,\n"), (Rows{{"1", "", ""}}));
  EXPECT_EQ(read("\"1\n2\",3\n4,5\n"), (Rows{{"1\n2", "3"}, {"4", "5"}}));
  EXPECT_THAT(lines_, ElementsAre(1, 3));
}

TEST_F(CsvTest, LinesEndInEveryWayAndMaySayNothing) {
  const Rows expected{{"1", "2"}, {"3", "4"}};
  EXPECT_EQ(read("1,2\n3,4"), expected);
  EXPECT_EQ(read("1,2\r\n3,4\r\n"), expected);
  EXPECT_EQ(read("1,2\r3,4\r"), expected);
  EXPECT_EQ(read("\xEF\xBB\xBF# \"\n \t\n1,2\r\r\n,\n #3,3\n3,4\n#"), expected);
  EXPECT_THAT(lines_, ElementsAre(3, 7));
  EXPECT_EQ(read(""), Rows());
  EXPECT_EQ(read("\xEF\xBB\xBF"), Rows());
}

/// Buffers end anywhere in a line.
TEST_F(CsvTest, LongFilesAreReadWhole) {
  std::string text;
  for (int k = 0; k < 20'000; ++k) text += std::to_string(k) + ",\"" + std::to_string(7 * k) + "\"\r\n";
  const Rows rows = read(text);
  ASSERT_EQ(rows.size(), 20'000U);
  for (std::size_t k = 0; k < rows.size(); ++k)
    ASSERT_EQ(rows[k], (std::vector<std::string>{std::to_string(k), std::to_string(7 * k)}));
}

TEST_F(CsvTest, WhatIsNoTableIsRefusedByName) {
  EXPECT_THAT(refusal("1,2\n3,\"4\n5\n"), HasSubstr("line 2: a quote is never closed"));
  EXPECT_THAT(refusal("1,\"2\"3\n"), HasSubstr("between a closing quote and the next comma"));
  EXPECT_THAT(refusal("1,2\"3\n"), HasSubstr("in the middle of a field"));
  EXPECT_THAT(refusal(std::string("\xFF\xFE\x31\0", 4)), HasSubstr("UTF-16"));
  EXPECT_THAT(refusal("\xFE\xFF\x01"), HasSubstr("UTF-16"));
  EXPECT_THAT(refusal(std::string("\xFF\xFE\0\0", 4)), HasSubstr("UTF-32"));
  EXPECT_THAT(refusal("\x1F\x8B\x08"), HasSubstr("gzip"));
  EXPECT_THAT(refusal(std::string(70'000, ' ') + std::string("1\0,", 3)), HasSubstr("value 0"));
  EXPECT_THROW(CsvReader(folder_.path() / "none.csv"), std::runtime_error);
  EXPECT_THROW(CsvReader(folder_.path()), std::runtime_error);
}

/// As numpy writes it.
TEST_F(CsvTest, AHeadingMayStandInAComment) {
  const auto first_of = [&](const std::string& text) {
    CsvTable table(write(text), {{"a", {}}, {"b", {"bee"}}});
    if (!table.has_heading()) table.set_order({0, 1}, 2);
    EXPECT_TRUE(table.next());
    return std::string(table.text(0)) + "," + std::string(table.text(1));
  };
  EXPECT_EQ(first_of("# a table, made today\n# bee, a\n1,2\n"), "2,1");
  EXPECT_EQ(first_of("#b,a\n1,2\n# a,b\n3,4\n"), "2,1");
  EXPECT_EQ(first_of("# b, a\n# units: m, s\n1,2\n"), "2,1") << "the last that is one";
  EXPECT_EQ(first_of("# b, a, step\n# b, a\n#\n1,2\n"), "2,1");
  for (const char* const comment : {"# b, c\n", "# made by a, of it\n", "# b\n"})
    EXPECT_EQ(first_of(comment + std::string("1,2\n")), "1,2") << comment;
  EXPECT_EQ(first_of("# b,a\na,b\n1,2\n"), "1,2") << "the line itself is one";
  EXPECT_TRUE(CsvTable(write("# b,a\n"), {{"a", {}}, {"b", {}}}).has_heading());
}

/// The columns were read in another order than the comment says.
TEST_F(CsvTest, ACommentThatIsNearlyAHeadingIsRefused) {
  const auto complaint = [&](const std::string& text) -> std::string {
    try {
      const CsvTable table(write(text), {{"a", {}}, {"b", {}}, {"c", {}}});
      return "";
    } catch (const UsageError& error) {
      return error.what();
    }
  };
  EXPECT_THAT(complaint("#\n# b, a, awake\n1,2,1\n"),
              HasSubstr("line 2: column 'awake' of the heading is not"));
  EXPECT_THAT(complaint("# b, a, b\n1,2,1\n"), HasSubstr("line 1: column 3, 'b', is b, as column 1 is"));
  EXPECT_THAT(complaint("# b, a\n1,2,1\n"),
              HasSubstr("line 1: the heading has 2 columns, the first line has 3"));
  EXPECT_THAT(complaint("# b, a, left, right, top\n1,2,1,2,3\n"), HasSubstr("column 'left'"));
  EXPECT_EQ(complaint("# seen by b, of it, today\n1,2,1\n"), "");
}

TEST_F(CsvTest, AColourBeginsALineOnlyWhereItIsTheFirstColumn) {
  const std::vector<CsvColumn> columns{{"color", {}, true}, {"b", {}}};
  const auto count = [&](const std::string& text) {
    CsvTable table(write(text), columns);
    int lines = 0;
    while (table.next()) lines += table.text(0) == "#1f77b4" || table.text(1) == "#1f77b4" ? 1 : 10;
    return lines;
  };
  EXPECT_EQ(count("# a note\ncolor,b\n#1f77b4,1\n# a note, too\n#\n#1f77b4,2\n"), 2);
  EXPECT_EQ(count("# color,b\n#1f77b4,1\n#1f77b4,1\n"), 2);
  EXPECT_EQ(count("b,color\n1,#1f77b4\n#1f77b4,2\n"), 1);
}

TEST_F(CsvTest, NumbersAreReadAsTheyAre) {
  CsvTable table(write("x,i,b\n+1.5,-7,TRUE\n-1e-400,1.0,0\ninf,+5,no\n1e-40,18446744073709551615,1.0\n0x10,"
                       "1e3,2\n1e999,,\n"),
                 {{"x", {}}, {"i", {}}, {"b", {}}});
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.real(0), 1.5);
  EXPECT_EQ(to_string(table.id(1)), "-7");
  EXPECT_TRUE(table.boolean(2));
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.real(0), -std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(to_string(table.id(1)), "1");
  EXPECT_FALSE(table.boolean(2));
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.real(0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(table.bits(1), 5U);
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.real(0), 1e-40);
  EXPECT_EQ(table.bits(1), UINT64_MAX);
  ASSERT_TRUE(table.next());
  for (const std::size_t column : {0U, 1U, 2U})
    EXPECT_THROW(column == 0   ? (void)table.real(0)
                 : column == 1 ? (void)table.id(1)
                               : (void)table.boolean(2),
                 UsageError);
  ASSERT_TRUE(table.next());
  EXPECT_THROW((void)table.real(0), UsageError);
  EXPECT_TRUE(table.is_blank(1));
  EXPECT_FALSE(table.next());
  table.rewind();
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.line(), 2U);
}

}  // namespace
}  // namespace kerf
