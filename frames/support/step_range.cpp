#include "frames/support/step_range.h"

#include <algorithm>
#include <vector>

#include "core/base/counted.h"
#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

std::vector<std::uint32_t> numbers_between_colons(std::string_view text) {
  std::vector<std::uint32_t> numbers;
  for (std::string_view rest = text;;) {
    const std::size_t colon = rest.find(':');
    const auto number = parse_number<std::uint32_t>(rest.substr(0, colon));
    if (!number) return {};
    numbers.push_back(*number);
    if (colon == std::string_view::npos) return numbers;
    rest.remove_prefix(colon + 1);
  }
}

}  // namespace

void check(const StepRange& range, const std::string& given) {
  if (range.first == 0) throw UsageError(given + ": steps count from 1");
  if (range.stride == 0)
    throw UsageError(given + ": N, the steps from one frame to the next, must be 1 or more");
  if (range.first > range.last) {
    throw UsageError(given + ": the first step, " + std::to_string(range.first) + ", comes after the last, " +
                     std::to_string(range.last));
  }
  if (std::max(range.last, range.stride) > kMaxStep)
    throw UsageError(given + ": at most " + std::to_string(kMaxStep) + " steps");
  if (range.frames() > kMaxFrames) {
    throw UsageError(given + ": that is " + counted(range.frames(), "frame") + ", at most " +
                     std::to_string(kMaxFrames) + " can be numbered; give a larger N");
  }
}

StepRange parse_steps(std::string_view text) {
  const std::string given = "--steps '" + std::string(text) + "'";
  const std::vector<std::uint32_t> n = numbers_between_colons(text);
  StepRange range;
  if (n.size() == 1) {
    if (n[0] == 0) throw UsageError(given + ": at least 1 step is needed");
    range = {1, n[0], 1};
  } else if (n.size() == 2) {
    range = {n[0], n[1], 1};
  } else if (n.size() == 3) {
    range = {n[0], n[1], n[2]};
  } else {
    throw UsageError(given + " is not A:B:N (steps A to B, a frame every N), for example 1:1000:4");
  }
  check(range, given);
  return range;
}

}  // namespace kerf
