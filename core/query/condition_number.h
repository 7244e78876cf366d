#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>

#include "core/base/given_id.h"
#include "core/query/text.h"

namespace kerf {

/// A number of a condition. Ids and times of steps may need 64 bits, which doubles do not have, so that they,
/// counts, and what is written have an exact value, too; measured figures and quotients have none. Two
/// numbers are compared exactly if both can be.
struct ConditionNumber {
  double nearest = std::numeric_limits<double>::quiet_NaN();  ///< NaN: it does not exist
  std::optional<long double> exact{};

  static ConditionNumber measured(double number) { return {number, {}}; }
  /// What is counted or written, as it is; or a time of a step.
  static ConditionNumber of(long double exact) { return {static_cast<double>(exact), exact}; }
  static ConditionNumber of(std::integral auto count) { return of(static_cast<long double>(count)); }
  static ConditionNumber of(const GivenId& id) {
    const auto magnitude = static_cast<long double>(id.magnitude);
    return of(id.negative ? -magnitude : magnitude);
  }

  [[nodiscard]] bool exists() const { return !std::isnan(nearest); }
  /// A whole number that is known exactly, and has the 64 bits of ids at most.
  [[nodiscard]] std::optional<long double> whole() const {
    return exact && std::abs(*exact) < 0x1p64L && std::trunc(*exact) == *exact ? exact : std::nullopt;
  }
  [[nodiscard]] bool is_true() const { return exists() && nearest != 0; }

  /// `relate` of the two, exactly if both can be.
  template <class Relate>
  static auto related(const ConditionNumber& x, const ConditionNumber& y, Relate relate) {
    return x.exact && y.exact
               ? relate(*x.exact, *y.exact)
               : relate(static_cast<long double>(x.nearest), static_cast<long double>(y.nearest));
  }
  friend bool operator==(const ConditionNumber& x, const ConditionNumber& y) {
    return related(x, y, [](long double a, long double b) { return a == b; });
  }
};

/// All digits of a whole number that is known exactly; of others as many as number_text writes.
std::string to_text(const ConditionNumber& number);

}  // namespace kerf
