#include "frames/import/oddities.h"

#include <algorithm>

#include "core/base/counted.h"

namespace kerf {
namespace {

struct Meaning {
  const char* one;
  const char* many;
  const char* more;  ///< for both
};

/// In the order of the enumeration.
constexpr std::array kMeanings{
    Meaning{"gap", "gaps", " between steps, at least half as long again as most"},
    Meaning{"step", "steps", " with pairs and without a line of boxes: the boxes stay"},
    Meaning{"box that is", "boxes that are", " half blank: the object is in quarantine"},
    Meaning{"box that is", "boxes that are", " not all numbers: the object is in quarantine"},
    Meaning{"box that is", "boxes that are", " inverted, min > max: the object is in quarantine"},
    Meaning{"box that reaches", "boxes that reach", " to infinity"},
    Meaning{"change", "changes", " between fixed and moving"},
    Meaning{
        "step", "steps",
        " in which an object has several boxes, which were united: what overlaps the joined box is a pair"},
    Meaning{"pair", "pairs", " with an object that is not there"},
    Meaning{"pair", "pairs", " to be ignored with an object that the run does not have"},
    Meaning{"line", "lines", " of the table of objects with an object that the run does not have"},
    Meaning{"box that is", "boxes that are", " too small for the object's shape: the box is shown"},
    Meaning{"step", "steps",
            " without a line of pairs, before the first or between: overlaps count as missed"},
    Meaning{"table", "tables", " of pairs that ends before the boxes: later overlaps count as missed"},
    Meaning{"table", "tables", " whose last line does not end: is the file cut off?"},
    Meaning{"pair", "pairs",
            " that may touch only in the digits that were written: write 9 digits, and 17 of doubles"},
    Meaning{"table is", "tables are",
            " so coarse that an object may be outside of its node by its last digit: write 9 digits, and 17 "
            "of doubles"},
};

}  // namespace

bool Oddities::any() const {
  return std::ranges::any_of(kinds_, [](const Kind& kind) { return kind.count > 0; });
}

std::string Oddities::text() const {
  std::string text;
  for (std::size_t k = 0; k < kKinds; ++k) {
    const Kind& kind = kinds_[k];
    if (kind.count == 0) continue;
    const auto& [one, many, more] = kMeanings[k];
    text += "odd: " + counted(kind.count, one, many) + more + "\n";
    for (const std::string& place : kind.places) text += "  " + place + "\n";
    if (kind.count > kind.places.size())
      text += "  and " + std::to_string(kind.count - kind.places.size()) + " more\n";
  }
  return text;
}

void note_cut(const CsvTable& table, Oddities& oddities) {
  if (!table.is_cut()) return;
  oddities.note(Oddity::cut_off, [&] { return table.name() + ", line " + std::to_string(table.line()); });
}

}  // namespace kerf
