#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "frames/experiment/claim.h"

namespace kerf {

enum class Outcome : std::uint8_t {
  holds,
  partly,    ///< some of its comparisons hold, or it is true in kind and not in degree
  opposite,  ///< most of its comparisons are the other way round
  cannot_be_judged,
};
std::string_view name_of(Outcome outcome);

/// How ours stand beside what the paper says: BSP where the statement names it, otherwise LO or SP.
enum class Standing : std::uint8_t { as_the_paper, better, worse, mixed, unknown };

struct ClaimVerdict {
  Outcome outcome = Outcome::cannot_be_judged;
  Standing standing = Standing::unknown;
  std::string_view ours;  ///< of which the standing speaks: "BSP"; empty if ours are not in the statement
  std::string figures;    ///< the quantities with their spreads
  std::string reason;     ///< in words; empty if the statement holds
};
/// "better for BSP", "as the paper"; "" if it is unknown.
std::string text_of_standing(const ClaimVerdict& verdict);

/// Fewer samples have no spread, and nothing is judged by them.
inline constexpr std::size_t kLeastSamples = 3;

/// The verdict of the figures on a claim. Figures over each other are compared run by run; what the spread of
/// their ratio leaves open is not decided.
ClaimVerdict judge(const Claim& claim, const ClaimFigures& figures);

}  // namespace kerf
