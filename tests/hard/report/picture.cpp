#include "tests/hard/report/picture.h"

#include <algorithm>
#include <array>

#include "tests/hard/report/canvas.h"
#include "viz/draw/palette.h"

namespace kerf::test {
namespace {

constexpr int kCellWidth = 56;  ///< of five letters, such as -810k, and some room beside them
constexpr int kCellHeight = 24;
constexpr int kMargin = 24;
constexpr int kCaseWidth = 560;   ///< of the column that names the cases
constexpr int kHeadHeight = 280;  ///< of the columns' names
constexpr int kTitleHeight = 60;
constexpr int kGroupGap = 16;  ///< between dimensions, and half of it between ours and the rivals
constexpr int kLegendHeight = 112;

struct Style {
  Color ground;
  Color ink;
  std::string_view meaning;
  std::string_view sign;
};

/// From Okabe and Ito's set; lightness falls as things get worse, so that it works without hue as well.
constexpr std::array<Style, kVerdictCount> kStyles{
    {{{226, 226, 222}, {110, 110, 110}, "not applicable", ""},
     {{205, 232, 247}, {40, 90, 130}, "exact", "="},
     {{240, 228, 66}, {25, 25, 25}, "extra pairs, their number", "+12"},
     {{230, 159, 0}, {25, 25, 25}, "pairs reported twice, their number", "2x5"},
     {{204, 121, 167}, {25, 25, 25}, "wrong status or unsound tree", "!1"},
     {{213, 94, 0}, {255, 255, 255}, "missed pairs, their number", "-1k"},
     {{0, 84, 140}, {255, 255, 255}, "time-out", "T"},
     {{25, 25, 25}, {255, 255, 255}, "crash", "X"}}};

const Style& style_of(Verdict verdict) { return kStyles[static_cast<std::size_t>(verdict)]; }

/// Left edges of the columns; groups stand a little apart.
std::vector<int> column_lefts(const std::vector<Column>& columns) {
  std::vector<int> lefts;
  int left = kMargin + kCaseWidth;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0 && columns[i].dimension != columns[i - 1].dimension) left += kGroupGap;
    if (i > 0 && columns[i].ours != columns[i - 1].ours) left += kGroupGap / 2;
    lefts.push_back(left);
    left += kCellWidth;
  }
  return lefts;
}

std::string title_of(const Column& column) {
  return std::string(column.ours ? "kerf, " : "") + column.name + (column.flat ? " (flat)" : "");
}

class TablePicture {
 public:
  explicit TablePicture(const Table& table)
      : table_(table),
        lefts_(column_lefts(table.columns)),
        top_(kMargin + kTitleHeight + kHeadHeight),
        canvas_(lefts_.back() + kCellWidth + kMargin,
                top_ + static_cast<int>(table.rows.size()) * kCellHeight + kLegendHeight + kMargin,
                palette::kGround) {}

  const Image& draw() {
    canvas_.text(large_, kMargin, kMargin,
                 "Hard cases: which broad phase reports exactly the overlapping pairs?", palette::kInk);
    for (std::size_t i = 0; i < table_.columns.size(); ++i) draw_head(i);
    for (std::size_t i = 0; i < table_.rows.size(); ++i) draw_row(i);
    draw_legend();
    return canvas_.image();
  }

 private:
  void draw_head(std::size_t i) {
    const Column& column = table_.columns[i];
    const bool first = i == 0 || table_.columns[i - 1].dimension != column.dimension;
    if (first)
      canvas_.text(large_, lefts_[i], kMargin + kTitleHeight, std::to_string(column.dimension) + "D",
                   palette::kInk);
    canvas_.text_upwards(small_, lefts_[i] + (kCellWidth - small_.line_height()) / 2, top_ - 10,
                         title_of(column), column.ours ? palette::kPartitioner : palette::kInk);
  }

  void draw_row(std::size_t i) {
    const Row& row = table_.rows[i];
    const int top = top_ + static_cast<int>(i) * kCellHeight;
    const int text_top = top + (kCellHeight - small_.line_height()) / 2;
    canvas_.text(small_, kMargin, text_top, row.hard_case->id, palette::kInk);
    canvas_.text(small_, kMargin + 44, text_top, row.hard_case->name, palette::kInk);
    canvas_.text(small_, kMargin + 262, text_top, row.hard_case->what, palette::kFaintInk);
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
      const Style& style = style_of(row.cells[k].worst.verdict);
      canvas_.fill(lefts_[k], top, kCellWidth - 2, kCellHeight - 2, style.ground);
      canvas_.text_centered(small_, lefts_[k], top, kCellWidth - 2, kCellHeight - 2,
                            symbol(row.cells[k].worst), style.ink);
    }
  }

  void draw_legend() {
    int left = kMargin;
    const int top = top_ + static_cast<int>(table_.rows.size()) * kCellHeight + 22;
    for (const Style& style : kStyles) {
      canvas_.fill(left, top, kCellWidth - 2, kCellHeight - 2, style.ground);
      canvas_.text_centered(small_, left, top, kCellWidth - 2, kCellHeight - 2, style.sign, style.ink);
      canvas_.text(small_, left + kCellWidth + 6, top + (kCellHeight - small_.line_height()) / 2,
                   style.meaning, palette::kInk);
      left += kCellWidth + 6 + small_.width(style.meaning) + 30;
    }
    canvas_.text(
        small_, kMargin, top + kCellHeight + 14,
        "kerf: the worst of its configurations. Rivals see every box as it is. (flat): a 3D library that "
        "is shown 2D boxes as slabs of unit thickness.",
        palette::kFaintInk);
    canvas_.text(small_, kMargin, top + kCellHeight + 14 + small_.line_height(),
                 "T: " + std::to_string(Limits{}.seconds) +
                     " s of processor time in requests and steps. t: not tried, since it timed out in 2D.",
                 palette::kFaintInk);
  }

  const Table& table_;
  std::vector<int> lefts_;
  int top_;
  Canvas canvas_;
  Font small_{15};
  Font large_{26};
};

}  // namespace

Image draw_table(const Table& table) { return TablePicture(table).draw(); }

}  // namespace kerf::test
