#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "core/recording/bound_rounding.h"

namespace kerf {

/// How numbers were written: of what one program wrote in one format.
class DigitStatistics {
 public:
  void note(std::string_view text, double value);

  /// None where the text has all of each number: floats with 9 digits, doubles with 17, binary fractions, and
  /// short decimals, which people write.
  [[nodiscard]] BoundRounding rounding() const;
  /// Of numbers of 4 to 8 or 15 to 16 digits, or all of the same three decimals or more, that are too few to
  /// be sure; also of two digits, or one decimal, of dozens of numbers. None where `rounding()` has one.
  [[nodiscard]] BoundRounding suspected() const;
  /// Whether there are numbers that are no binary fractions, or have zeros that say how they were written.
  [[nodiscard]] bool has_rounded() const { return rounded_ > 0 || has_zeros_ || lacks_room(); }
  /// Whether there are whole numbers of six digits and no number has more: where %g has no room for decimals.
  [[nodiscard]] bool may_lack_room() const { return has_full_whole_ && most_of_all_ <= kDigitsOfG; }

 private:
  static constexpr std::size_t kMostDigits = 17;
  static constexpr std::size_t kMostDecimals = 30;
  static constexpr std::size_t kDigitsOfG = 6;  ///< that %g writes

  /// Numbers that are no binary fractions, and so were rounded or are decimals by intent.
  struct Seen {
    std::uint64_t count = 0;
    std::vector<double> some;  ///< of them, each once
    void note(double value);
  };

  /// Numbers that the shortest text of a float or double seldom leaves in so few digits.
  struct Short {
    std::vector<double> some;  ///< each once
    double surprise = 0;       ///< how unlikely they are as shortest texts: minus the logarithm
    void note(double value, double unit, double spacing);
  };

  void note_float(double value, double unit);
  [[nodiscard]] bool lacks_room() const;
  [[nodiscard]] bool are_floats() const;
  [[nodiscard]] bool are_rounded(std::size_t least_digits) const;
  [[nodiscard]] bool is_whole() const;
  [[nodiscard]] bool are_open() const;
  [[nodiscard]] bool is_fixed() const;
  [[nodiscard]] bool is_trimmed() const;
  [[nodiscard]] bool is_cut() const;
  [[nodiscard]] std::size_t usual_digits() const;

  std::array<Seen, kMostDigits + 1> by_digits_{};
  std::array<Short, kMostDigits + 1> short_{};         ///< by digits
  std::array<Seen, kMostDecimals + 1> by_decimals_{};  ///< those without a large exponent
  Seen with_point_{};                                  ///< all numbers that have one
  std::size_t most_digits_ = 0;                        ///< of all numbers with a point or an exponent
  std::size_t most_of_all_ = 0;                        ///< of all numbers
  std::size_t most_decimals_ = 0;                      ///< of all numbers with a point, and small ones
  std::size_t least_decimals_ = kMostDecimals;
  bool has_more_decimals_ = false;  ///< than are counted
  bool has_zeros_ = false;          ///< at the end behind the point, which no shortest text has
  std::uint64_t rounded_ = 0;
  std::uint64_t open_floats_ = 0;  ///< of them those of which many floats have the text
  std::uint64_t open_doubles_ = 0;
  std::optional<std::size_t> least_room_;  ///< digits that the shortest numbers like 1e+06 may have at most
  bool has_full_whole_ = false;            ///< a whole number of six digits
  bool has_exponent_ = false;
  bool has_large_exponent_ = false;  ///< of a number beyond 1
  bool may_be_floats_ = true;        ///< each is the nearest float, written with as many digits
  double surprise_ = 0;              ///< how unlikely that is of doubles: minus the logarithm
  std::vector<double> tried_{};      ///< numbers that count for it
};

/// Finds out from the bounds of a table how its program rounded them. Huge ones stand for "no bound", often
/// in a writing of their own, and count only where there are no others.
class BoundWriting {
 public:
  /// The bounds of a box along an axis. What is no number is passed over.
  void note(int axis, std::string_view min, std::string_view max);

  [[nodiscard]] BoundRounding rounding() const { return with_planes(counted().rounding()); }
  [[nodiscard]] BoundRounding suspected() const;
  /// From where on bounds are suspected: where only whole numbers of six digits may have been rounded,
  /// smaller ones were written whole.
  [[nodiscard]] double suspected_from() const;

 private:
  [[nodiscard]] bool may_be_whole_only() const;
  /// Whether all boxes are flat at one number along an axis.
  struct Plane {
    std::optional<double> at;
    bool holds = true;
    bool has_room = true;                                    ///< its text has, see lacks_room
    double least = std::numeric_limits<double>::infinity();  ///< extent of a box that is not flat
    void note(double min, double max);
  };

  std::optional<double> note(std::string_view text);
  [[nodiscard]] const DigitStatistics& counted() const { return usual_.has_rounded() ? usual_ : huge_; }
  [[nodiscard]] BoundRounding with_planes(BoundRounding rounding) const;

  DigitStatistics usual_;
  DigitStatistics huge_;
  std::array<Plane, 3> planes_{};
};

}  // namespace kerf
