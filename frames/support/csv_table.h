#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/given_id.h"
#include "frames/support/csv_reader.h"

namespace kerf {

/// A column of a table: its name, and what else people call it. Names are compared without regard to capitals
/// and to everything but letters and digits.
struct CsvColumn {
  std::string name;
  std::vector<std::string> aliases;
  bool is_color = false;  ///< fields such as #1f77b4, also where a line begins
};

/// A table whose columns are found by the names in its heading, in any order. Without a heading they stand in
/// an order that the reader of the table knows. Everything throws UsageError that names file, line and
/// column.
class CsvTable {
 public:
  /// Reads the heading, if there is one: a first line without any number, or the last comment before it that
  /// has a known name for each column, as numpy writes it. Throws as TextSource does; throws UsageError for a
  /// name that is unknown, with the known ones, that stands twice, or is none, also in a comment of which
  /// most names are known.
  CsvTable(const std::filesystem::path& path, std::vector<CsvColumn> columns);

  [[nodiscard]] bool has_heading() const { return has_heading_; }
  /// Whether the file has neither a heading nor another line.
  [[nodiscard]] bool is_empty() const { return first_width_ == 0; }
  /// How many columns the first line that is no heading has; 0: there is none.
  [[nodiscard]] std::size_t first_width() const { return first_width_; }
  /// The order of columns without a heading. A line may end after any column from `least` on.
  void set_order(const std::vector<std::size_t>& columns, std::size_t least);
  [[nodiscard]] bool has(std::size_t column) const { return place_[column].has_value(); }
  /// The names of the columns as they stand in the file: "step, object, min_x".
  [[nodiscard]] std::string names() const;

  /// Goes to the next line, back to before the first one.
  bool next();
  void rewind();

  /// Also of a column that the table, or this line, does not have.
  [[nodiscard]] bool is_blank(std::size_t column) const { return text(column).empty(); }
  [[nodiscard]] std::string_view text(std::size_t column) const;
  /// A double, also inf and nan. What is nearer to 0 than any double is the double next to 0 of its sign.
  [[nodiscard]] double real(std::size_t column) const;
  [[nodiscard]] GivenId id(std::size_t column) const;
  [[nodiscard]] std::uint64_t bits(std::size_t column) const;
  [[nodiscard]] bool boolean(std::size_t column) const;

  /// At the end: a hash of the whole file as this pass has read it.
  [[nodiscard]] std::uint64_t fingerprint() const { return reader_.fingerprint(); }
  /// At the end: whether the last line has no end, so that it may be the beginning of a longer one.
  [[nodiscard]] bool is_cut() const { return reader_.is_cut(); }
  [[nodiscard]] std::size_t line() const { return reader_.line(); }
  [[nodiscard]] const std::string& name() const { return reader_.name(); }
  [[noreturn]] void reject(const std::string& what) const { reader_.reject(what); }
  /// "'text' in column 4, max_x, WHAT"
  [[noreturn]] void reject(std::size_t column, const std::string& what) const;

 private:
  [[nodiscard]] bool is_heading() const;
  void check_separator() const;
  void read_heading(const std::vector<std::string_view>& names, std::size_t line);
  void read_heading_of_comment();
  [[nodiscard]] std::optional<std::size_t> find_column(std::string_view called) const;
  [[nodiscard]] std::size_t column_called(std::string_view name, std::size_t place, std::size_t line) const;
  void check_width() const;

  CsvReader reader_;
  std::vector<CsvColumn> columns_;
  std::vector<std::optional<std::size_t>> place_;  ///< of each column in a line
  std::vector<std::size_t> order_;                 ///< the column at each place
  std::size_t least_ = 0;
  bool has_heading_ = false;
  bool is_heading_comment_ = false;
  std::size_t first_width_ = 0;
};

}  // namespace kerf
