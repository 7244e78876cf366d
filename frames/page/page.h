#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frames/page/cell.h"

namespace kerf {

/// Instead of a number of digits: three that count, as few characters as that takes.
inline constexpr int kShortestDigits = -1;

/// How a figure of a row is shown.
struct TableColumn {
  std::string title;
  std::string key;     ///< in the row; a row without it shows nothing
  int digits = 0;      ///< behind the point
  double scale = 1;    ///< the number is multiplied by it first
  bool wraps = false;  ///< long text, on the left, in several lines
};

/// The key of a row's address: links to "#address" lead to the row.
inline constexpr const char* kRowId = "#";

struct LegendEntry {
  std::string svg;  ///< how it looks
  std::string name;
};

/// Text escaped for an HTML page.
std::string escaped(std::string_view text);

/// A self-contained HTML page: nothing is loaded from anywhere, no script runs.
class Page {
 public:
  Page(std::string title, std::string subtitle);

  void section(std::string_view id, std::string_view title);
  void heading(std::string_view title);
  void paragraph(std::string_view text);
  /// An SVG element with a line below it.
  void figure(const std::string& svg, std::string_view caption);
  /// A figure of SVG elements in two columns, a row after the other, below a legend that remains in sight.
  void figure_of_panels(const std::vector<LegendEntry>& legend, const std::vector<std::string>& svgs,
                        std::string_view caption);
  /// Rows are objects. Marked rows (`marked` is empty or as long as the rows) stand out with a ring. A click
  /// on the summary of a closed table opens it.
  void table(std::string_view summary, const std::vector<TableColumn>& columns, const Json& rows,
             const std::vector<bool>& marked = {}, bool open = false);
  /// The command that makes the page again.
  void command(std::string_view command);

  [[nodiscard]] std::string html() const;

 private:
  void row(const std::vector<TableColumn>& columns, const Json& row, bool marked);

  std::string title_;
  std::string subtitle_;
  std::string contents_;
  std::string body_;
};

}  // namespace kerf
