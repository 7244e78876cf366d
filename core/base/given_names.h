#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/given_id.h"
#include "core/base/ids.h"

namespace kerf {

/// When a step was, as another program writes it: a number, or a date with a time of day
/// ("2024-05-01T12:00:00.016", in seconds since 1970). Nothing for anything else. As long as a number is
/// whole, 64 bits of it count.
std::optional<long double> parse_step_time(std::string_view text);

/// What objects and steps are called outside. A run has objects and steps of its own numbers, from 0 and from
/// 1; an import keeps beside them what the other engine calls them. Without names the own numbers are the
/// names.
class GivenNames {
 public:
  GivenNames() = default;
  /// Of the objects from 0 on, rising, and of the steps from 1 on, their times rising; either may be empty:
  /// own numbers are the names. Throws std::invalid_argument, saying which, if they do not rise.
  GivenNames(std::vector<GivenId> objects, std::vector<std::string> steps);

  [[nodiscard]] std::string object(ObjectId object) const { return to_string(object_id(object)); }
  [[nodiscard]] GivenId object_id(ObjectId object) const;
  /// "1,2", the lesser name first.
  [[nodiscard]] std::string pair(const Pair& pair) const;
  [[nodiscard]] std::string step(std::uint32_t step) const;
  /// "steps 5000 to 5059"
  [[nodiscard]] std::string steps(std::uint32_t first, std::uint32_t last) const;
  /// "step 5000", or "a step after the last" if it is later than all that have names.
  [[nodiscard]] std::string coming_step(std::uint32_t step) const;
  /// As a number, which is what conditions compare; own numbers where there is no name.
  [[nodiscard]] long double step_number(std::uint32_t step) const;

  [[nodiscard]] std::optional<ObjectId> find_object(const GivenId& name) const;
  [[nodiscard]] std::optional<std::uint32_t> find_step(std::string_view name) const;

  /// Whether steps have other names than their numbers: then step 0, which no other engine has, has none.
  [[nodiscard]] bool names_steps() const { return !steps_.empty(); }
  [[nodiscard]] std::span<const GivenId> objects() const { return objects_; }
  [[nodiscard]] std::span<const std::string> steps() const { return steps_; }
  friend bool operator==(const GivenNames&, const GivenNames&) = default;

 private:
  std::vector<GivenId> objects_;
  std::vector<std::string> steps_;
  std::vector<long double> times_;  ///< of the steps
};

/// The step's name if it has one, else nothing.
inline std::string given_step_name(const GivenNames& names, std::uint32_t step) {
  return names.names_steps() ? names.step(step) : std::string();
}

}  // namespace kerf
