#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kerf {

/// How a broad phase may be wrong on purpose, for time. Nothing here is on by default: `Bsp` itself is always
/// exact, and `Approximate` wraps any broad phase. The cost of each setting in pairs:
///
/// - `period` k: boxes are handed on, and pairs looked for, in every k-th step only; between, the last pairs
///   stand. Misses what meets in between, invents what has parted. New objects have no pairs until then.
/// - `margin`: what is handed on is widened by so much on each side. With a period, nothing is missed while
///   each of two objects has moved less than it since. Invents pairs that are up to twice as far apart.
/// - `filter`: kept pairs are compared with the latest boxes, so that nothing is invented.
/// - `grid`: ends of intervals are rounded to multiples of it, by the same monotone function for all ends:
///   this invents pairs, and never misses one (DESIGN.md, "Correct pairs"). An object whose rounded box stays
///   the same is not moved.
/// - `shrink`: with a grid, ends are rounded inward instead: misses what overlaps by less than two cells and
///   invents nothing, but where a box is smaller than a cell.
struct Approximation {
  std::uint32_t period = 1;  ///< steps between two placements
  float margin = 0;          ///< units of the scene
  bool filter = false;
  float grid = 0;  ///< size of a cell in units of the scene; 0: intervals are not rounded
  bool shrink = false;

  friend bool operator==(const Approximation&, const Approximation&) = default;
};

/// Throws std::invalid_argument, naming the parameter and its range, when a value cannot work.
void check(const Approximation& how);

/// Whether `name` is one of the parameters above.
bool is_approximation_parameter(std::string_view name);
/// Applies "K=V,K=V,..." with the names above. All or nothing; throws std::invalid_argument that says what is
/// allowed.
void apply(Approximation& how, std::string_view assignments);
/// All settings that differ from the default as "K=V,K=V", such that `apply` restores them; empty: exact.
std::string to_string(const Approximation& how);

}  // namespace kerf
