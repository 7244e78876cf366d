#include "tests/support/pairs.h"

#include <algorithm>
#include <iterator>

namespace kerf::test {
namespace {

/// "; 2 missed: 3-17 4-9", or nothing.
std::string list(const std::string& what, const std::vector<Pair>& pairs) {
  constexpr std::size_t kShown = 8;
  if (pairs.empty()) return "";
  std::string text = "; " + std::to_string(pairs.size()) + " " + what + ":";
  for (std::size_t i = 0; i < std::min(pairs.size(), kShown); ++i)
    text += " " + std::to_string(pairs[i].a.value) + "-" + std::to_string(pairs[i].b.value);
  return pairs.size() > kShown ? text + " ..." : text;
}

std::vector<Pair> without(const std::vector<Pair>& all, const std::vector<Pair>& taken) {
  std::vector<Pair> rest;
  std::set_difference(all.begin(), all.end(), taken.begin(), taken.end(), std::back_inserter(rest));
  return rest;
}

}  // namespace

std::vector<Pair> sorted(std::span<const Pair> pairs) {
  std::vector<Pair> result(pairs.begin(), pairs.end());
  std::sort(result.begin(), result.end());
  return result;
}

std::string difference(std::span<const Pair> found, std::span<const Pair> expected) {
  const std::vector<Pair> have = sorted(found);
  const std::vector<Pair> want = sorted(expected);
  std::vector<Pair> once;
  std::unique_copy(have.begin(), have.end(), std::back_inserter(once));
  const std::string text = list("missed", without(want, once)) + list("invented", without(once, want)) +
                           list("reported again", without(have, once));
  return text.empty() ? text : std::to_string(want.size()) + " pairs expected" + text;
}

testing::AssertionResult same_pairs(std::span<const Pair> found, std::span<const Pair> expected) {
  const std::string text = difference(found, expected);
  return text.empty() ? testing::AssertionSuccess() : testing::AssertionFailure() << text;
}

}  // namespace kerf::test
