#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace kerf {

/// The whole number that a value is; JSON's own conversion cuts off what does not fit, and takes 1.5 and true
/// for 1. Throws std::out_of_range with the name of the value.
template <class Whole, class Json>
Whole whole_number(const Json& value, const std::string& name) {
  const bool fits = value.is_number_unsigned() ? std::in_range<Whole>(value.template get<std::uint64_t>())
                                               : value.is_number_integer() &&
                                                     std::in_range<Whole>(value.template get<std::int64_t>());
  if (!fits) throw std::out_of_range(name + " is no whole number in range");
  return value.template get<Whole>();
}

/// Likewise for any number that a float holds.
template <class Json>
float float_number(const Json& value, const std::string& name) {
  const double number = value.is_number() ? value.template get<double>() : std::nan("");
  if (!(std::abs(number) <= double{std::numeric_limits<float>::max()}))
    throw std::out_of_range(name + " is no number in range");
  return static_cast<float>(number);
}

}  // namespace kerf
