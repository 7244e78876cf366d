#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/recording/their_digits.h"

namespace kerf {

/// How the numbers of a table were written, as far as one needs it to compare them with those of another.
class TableWriting {
 public:
  void note(std::string_view text);

  [[nodiscard]] const WrittenDigits& digits() const { return digits_; }
  /// Whether the numbers may have been rounded to less than six digits (%.3g) or to no decimals (%.0f): these
  /// are as many as any number has, and some that has as many lacks decimals which others have. Numbers with
  /// the same decimals are of no such table, nor are halves, which are exact.
  [[nodiscard]] bool may_be_coarse() const;
  /// "3 digits", "no decimals"
  [[nodiscard]] std::string text() const;

 private:
  static constexpr std::size_t kLeastDigits = 6;  // that programs write

  [[nodiscard]] bool is_whole() const { return !has_point_ && digits_.decimals == 0; }

  WrittenDigits digits_{};
  bool has_point_ = false;
  std::array<std::int64_t, kLeastDigits> least_decimals_{};  ///< of numbers with so many digits
  std::bitset<kLeastDigits> has_digits_;
};

/// Finds out whether a table that may be coarse was rounded or is short by intent, from the numbers of
/// another one that describes the same boxes: a margin around whole numbers leaves few remainders beyond
/// their last place, numbers of a program leave many.
class Remainders {
 public:
  explicit Remainders(const TableWriting& coarse)
      : digits_(coarse.digits()), may_be_coarse_(coarse.may_be_coarse()) {}

  /// A number of the other table.
  void note(double number);
  [[nodiscard]] bool are_many() const;

 private:
  static constexpr std::size_t kParts = 1000;  // of a place, so that a float's own rounding makes no others

  WrittenDigits digits_;
  bool may_be_coarse_;
  std::bitset<kParts> seen_;
};

}  // namespace kerf
