#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "frames/support/text_source.h"

namespace kerf {

/// A comment of a table.
struct CsvComment {
  std::size_t line = 0;
  std::string text;  ///< without its #
};

/// Reads a table of comma-separated values, line by line: RFC 4180, with quotes, and beyond it ends of lines
/// as LF, CRLF or CR, blanks around fields, empty lines, lines of nothing but commas, and comments from # to
/// the end of their line, which are all passed over. Everything throws UsageError that names file, line and
/// what is wrong.
class CsvReader {
 public:
  /// Throws as TextSource does.
  explicit CsvReader(const std::filesystem::path& path) : source_(path) {}

  /// Goes to the next line that says something; false at the end.
  bool next();
  /// Back to where it was made.
  void rewind();

  [[nodiscard]] std::size_t columns() const { return ends_.size(); }
  [[nodiscard]] std::string_view field(std::size_t column) const;
  /// Where the line begins, counted from 1 as editors do.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// At the end: whether the last line has no end, so that it may be the beginning of a longer one.
  [[nodiscard]] bool is_cut() const { return is_cut_; }
  /// The last comments with a comma before the first line that says something.
  [[nodiscard]] const std::vector<CsvComment>& comments() const { return comments_; }
  /// From now on a line that begins with # and no blank is no comment: its first field is a colour.
  void take_colors() { takes_colors_ = true; }
  /// At the end: a hash of the whole file as this pass has read it.
  [[nodiscard]] std::uint64_t fingerprint() const { return source_.fingerprint(); }
  [[nodiscard]] const std::string& name() const { return source_.name(); }
  [[noreturn]] void reject(const std::string& what) const { reject(line_, what); }
  [[noreturn]] void reject(std::size_t line, const std::string& what) const;

 private:
  bool read_record();
  void read_field();
  void read_quoted();
  void skip_comment();
  bool skip_blanks();
  bool take_line_end();

  TextSource source_;
  std::size_t next_line_ = 1;
  std::size_t line_ = 0;
  bool has_record_ = false;
  bool is_cut_ = false;
  bool takes_colors_ = false;
  std::vector<CsvComment> comments_;
  std::string text_;               ///< the fields, one after another
  std::vector<std::size_t> ends_;  ///< of each in the text
};

}  // namespace kerf
