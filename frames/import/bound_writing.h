#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/recording/bound_rounding.h"

namespace kerf {

/// Finds out from the bounds of a table how its program rounded them.
class BoundWriting {
 public:
  /// The bounds of a box along an axis. What is no number is passed over.
  void note(int axis, std::string_view min, std::string_view max);

  /// None where the text has all of each number: floats with 9 digits, doubles with 17, binary fractions, and
  /// short decimals, which people write.
  [[nodiscard]] BoundRounding rounding() const;
  /// Of a table whose numbers, of 4 to 8 digits or all of the same three decimals or more, are too few to be
  /// sure; none where `rounding()` has one.
  [[nodiscard]] BoundRounding suspected() const;

 private:
  static constexpr std::size_t kMostDigits = 17;
  static constexpr std::size_t kMostDecimals = 30;

  /// Numbers that are no binary fractions, and so were rounded or are decimals by intent.
  struct Seen {
    std::uint64_t count = 0;
    std::vector<double> some;  ///< of them, each once
    void note(double value);
  };

  /// Whether all boxes are flat at one number along an axis.
  struct Plane {
    std::optional<double> at;
    bool holds = true;
    void note(double min, double max);
  };

  void note(std::string_view text);
  void note_float(double value, double unit);
  [[nodiscard]] std::uint32_t planes() const;
  [[nodiscard]] bool are_floats() const;
  [[nodiscard]] bool is_whole() const;
  [[nodiscard]] bool is_fixed() const;
  [[nodiscard]] bool is_trimmed() const;
  [[nodiscard]] bool is_cut() const;
  [[nodiscard]] std::size_t usual_digits() const;

  std::array<Plane, 3> planes_{};
  std::array<Seen, kMostDigits + 1> by_digits_{};
  std::array<Seen, kMostDecimals + 1> by_decimals_{};  ///< those without an exponent
  std::size_t most_digits_ = 0;                        ///< of all numbers with a point or an exponent
  std::size_t most_decimals_ = 0;                      ///< of all numbers with a point
  std::size_t least_decimals_ = kMostDecimals;
  std::uint64_t rounded_ = 0;
  bool has_exponent_ = false;
  bool may_be_floats_ = true;    ///< each is the nearest float, written with as many digits
  double surprise_ = 0;          ///< how unlikely that is of doubles: minus the logarithm
  std::vector<double> tried_{};  ///< numbers that count for it
};

}  // namespace kerf
