#include "frames/sequence/recorded_steps.h"

#include <algorithm>
#include <vector>

#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

std::vector<std::string> parts_of(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + separator.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

bool has_dates(const GivenNames& names) {
  return std::ranges::any_of(names.steps(),
                             [](const std::string& name) { return name.find(':') != std::string::npos; });
}

/// `between` stands between the parts of "A:B:N".
StepRange parse_named(const std::string& text, const GivenNames& names, const std::string& between) {
  const std::string given = "--steps '" + text + "'";
  const std::vector<std::string> parts = parts_of(text, between);
  const auto stride = parts.size() == 3 ? parse_number<std::uint32_t>(parts[2]) : 1U;
  if (parts.size() > 3 || !stride)
    throw UsageError(given + " is not A" + between + "B" + between +
                     "N (steps A to B, a frame every N), for example " + names.step(1) + between +
                     names.step(static_cast<std::uint32_t>(names.steps().size())) + between + "4");
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
  const bool are_dates = has_dates(names);
  const bool is_named =
      names.names_steps() && (!are_dates || names.find_step(text) || text.find("..") != std::string::npos);
  const StepRange range = is_named ? parse_named(text, names, are_dates ? ".." : ":") : parse_steps(text);
  if (range.last > steps)
    throw UsageError("--steps '" + text + "': the recording ends with step " +
                     (is_named ? names.step(steps) : std::to_string(steps)));
  return range;
}

}  // namespace kerf
