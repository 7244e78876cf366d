#include "core/broad_phase/approximation.h"

#include <array>
#include <stdexcept>

#include "core/base/assignments.h"
#include "core/base/float_mode.h"
#include "core/base/number_text.h"

namespace kerf {
namespace {

constexpr std::uint32_t kLongestPeriod = 1'000'000;
constexpr float kLargest = 1e9F;

constexpr std::array<std::string_view, 5> kNames{"period", "margin", "filter", "grid", "shrink"};

template <class T>
T parse(std::string_view name, std::string_view text) {
  const DefaultFloats floats;  // std::from_chars may round as the caller does
  const auto value = read_number<T>(text);
  if (!value)
    throw std::invalid_argument("parameter " + std::string(name) + ": '" + std::string(text) +
                                "' is no number");
  return *value;
}

bool parse_switch(std::string_view name, std::string_view text) {
  if (text != "0" && text != "1")
    throw std::invalid_argument("parameter " + std::string(name) + ": '" + std::string(text) +
                                "' is neither 0 nor 1");
  return text == "1";
}

void set(Approximation& how, std::string_view name, std::string_view value) {
  if (name == "period") {
    how.period = parse<std::uint32_t>(name, value);
  } else if (name == "margin") {
    how.margin = parse<float>(name, value);
  } else if (name == "filter") {
    how.filter = parse_switch(name, value);
  } else if (name == "grid") {
    how.grid = parse<float>(name, value);
  } else if (name == "shrink") {
    how.shrink = parse_switch(name, value);
  } else {
    throw std::invalid_argument("unknown parameter '" + std::string(name) +
                                "'; known are period, margin, filter, grid and shrink");
  }
}

}  // namespace

void check(const Approximation& how) {
  if (how.period < 1 || how.period > kLongestPeriod)
    throw std::invalid_argument("parameter period: from 1 to 1000000 steps are possible");
  if (!(how.margin >= 0 && how.margin <= kLargest))
    throw std::invalid_argument("parameter margin: from 0 to 1e9 is possible");
  if (!(how.grid >= 0 && how.grid <= kLargest))
    throw std::invalid_argument("parameter grid: from 0 to 1e9 is possible");
  if (how.shrink && how.grid == 0)
    throw std::invalid_argument("parameter shrink: it needs a grid, for example grid=0.1");
}

bool is_approximation_parameter(std::string_view name) {
  for (const std::string_view known : kNames)
    if (known == name) return true;
  return false;
}

void apply(Approximation& how, std::string_view assignments) {
  Approximation changed = how;
  for (const auto& [name, value] : parse_assignments(assignments)) set(changed, name, value);
  check(changed);
  how = changed;
}

std::string to_string(const Approximation& how) {
  const Approximation exact;
  std::string text;
  const auto add = [&text](std::string_view name, const std::string& value) {
    text += (text.empty() ? "" : ",") + std::string(name) + "=" + value;
  };
  if (how.period != exact.period) add("period", std::to_string(how.period));
  if (how.margin != exact.margin) add("margin", exact_number(how.margin));
  if (how.filter) add("filter", "1");
  if (how.grid != exact.grid) add("grid", exact_number(how.grid));
  if (how.shrink) add("shrink", "1");
  return text;
}

}  // namespace kerf
