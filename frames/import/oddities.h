#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "frames/support/csv_table.h"

namespace kerf {

/// What can be odd about another engine's run, though it can be played.
enum class Oddity : std::uint8_t {
  gap,
  no_boxes,
  half_blank,
  not_a_number,
  inverted,
  infinite,
  mobility,
  united,
  absent_object,
  unknown_ignored,
  unknown_object,
  large_shape,
  no_pairs,
  pairs_end,
  cut_off,
  few_digits,
  coarse_table,
};

/// Counts what is odd, and keeps where the first five of each kind are.
class Oddities {
 public:
  /// `where` is called for the first five only.
  template <class Where>
  void note(Oddity oddity, Where where) {
    Kind& kind = kinds_[static_cast<std::size_t>(oddity)];
    if (kind.count++ < kNamed) kind.places.push_back(where());
  }

  [[nodiscard]] std::size_t count(Oddity oddity) const {
    return kinds_[static_cast<std::size_t>(oddity)].count;
  }
  [[nodiscard]] bool any() const;
  /// A line for each kind that occurred, and below it the first five; empty: nothing is odd.
  [[nodiscard]] std::string text() const;

 private:
  static constexpr std::size_t kNamed = 5;
  static constexpr std::size_t kKinds = static_cast<std::size_t>(Oddity::coarse_table) + 1;
  struct Kind {
    std::size_t count = 0;
    std::vector<std::string> places;
  };
  std::array<Kind, kKinds> kinds_;
};

/// Notes a table, read to its end, that may have been cut within its last line.
void note_cut(const CsvTable& table, Oddities& oddities);

}  // namespace kerf
