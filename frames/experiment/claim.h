#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "frames/experiment/measure.h"

namespace kerf {

/// Up to this factor figures are "similar" and differences "small"; beyond it a difference is "much", "big"
/// or "substantial". The paper gives no number.
inline constexpr double kTolerance = 1.5;
/// Figures that differ by less are alike: neither is the smaller one.
inline constexpr double kAlike = 1.02;

/// Why some statements cannot be judged.
inline constexpr std::string_view kNoFigure = "its words name no figure";

/// What a statement says of a figure over another.
enum class Relation : std::uint8_t {
  less,
  much_less,      ///< by more than kTolerance
  slightly_less,  ///< by at most kTolerance
  more,
  much_more,
  similar,  ///< within kTolerance either way
};

/// A figure, what it is compared with, and what the paper says of them.
struct Comparison {
  Quantity subject;
  Relation relation = Relation::similar;
  std::optional<Quantity> rival;  ///< none: a fixed number
  double number = 1;              ///< instead of a rival
};

/// A statement of the paper.
struct Claim {
  int simulation = 0;                   ///< 0: of several
  std::string_view section;             ///< "6.2" or "7"
  std::string_view words;               ///< the paper's, shortened
  std::vector<Comparison> comparisons;  ///< all of them must hold; empty: it cannot be judged
  std::string_view note;                ///< how it is read, or why it cannot be judged
  bool one_suffices = false;            ///< one of the comparisons must hold
};

/// Every statement of the paper's sections 6.2 and 7 on results, in its order.
const std::vector<Claim>& claims();

}  // namespace kerf
