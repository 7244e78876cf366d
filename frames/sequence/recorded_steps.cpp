#include "frames/sequence/recorded_steps.h"

#include <algorithm>
#include <vector>

#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

std::vector<std::string> between_colons(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

bool has_dates(const GivenNames& names) {
  return std::ranges::any_of(names.steps(),
                             [](const std::string& name) { return name.find(':') != std::string::npos; });
}

StepRange parse_named(const std::string& text, const GivenNames& names) {
  const std::string given = "--steps '" + text + "'";
  const std::vector<std::string> parts = between_colons(text);
  const auto stride = parts.size() == 3 ? parse_number<std::uint32_t>(parts[2]) : 1U;
  if (parts.size() > 3 || !stride)
    throw UsageError(given + " is not A:B:N (steps A to B, a frame every N), for example " + names.step(1) +
                     ":" + names.step(static_cast<std::uint32_t>(names.steps().size())) + ":4");
  const auto find = [&](const std::string& name) {
    const auto step = names.find_step(name);
    if (step) return *step;
    throw UsageError(given + ": there is no step '" + name + "'; the recording has " +
                     names.steps(1, static_cast<std::uint32_t>(names.steps().size())));
  };
  const StepRange range{parts.size() == 1 ? 1 : find(parts[0]), find(parts[parts.size() == 1 ? 0 : 1]),
                        *stride};
  if (range.first > range.last)
    throw UsageError(given + ": the first step, " + parts[0] + ", comes after the last, " + parts[1]);
  check(range, given);
  return range;
}

}  // namespace

StepRange parse_recorded_steps(const std::string& text, const GivenNames& names, std::uint32_t steps) {
  const bool is_named = names.names_steps() && !has_dates(names);
  const StepRange range = is_named ? parse_named(text, names) : parse_steps(text);
  if (range.last > steps)
    throw UsageError("--steps '" + text + "': the recording ends with step " +
                     (is_named ? names.step(steps) : std::to_string(steps)));
  return range;
}

}  // namespace kerf
