// Walks faults through the commands that write, and prints what was tried and found.
// usage: kerf_faults POINTS [SCENARIO...]

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tests/outputs/walk.h"

namespace {

using kerf::faults::Scenario;
using kerf::faults::WalkResult;

void print(const Scenario& scenario, const WalkResult& result) {
  std::printf("| %s | %llu | %d | %d | %d | %d | %zu |\n", scenario.name.c_str(),
              static_cast<unsigned long long>(result.calls), result.errors, result.full, result.kills,
              result.unharmed, result.findings.size());
  std::fflush(stdout);
  for (const std::string& finding : result.findings) std::fprintf(stderr, "%s\n", finding.c_str());
}

/// How many findings there are.
std::size_t walk_all(std::uint64_t points, const std::vector<std::string>& only) {
  std::printf("| command | calls of a run | EIO | ENOSPC | killed | done all the same | findings |\n");
  std::printf("|---|--:|--:|--:|--:|--:|--:|\n");
  std::size_t findings = 0;
  for (const Scenario& scenario : kerf::faults::scenarios()) {
    if (!only.empty() && std::ranges::find(only, scenario.name) == only.end()) continue;
    const WalkResult result = kerf::faults::walk(scenario, points);
    print(scenario, result);
    findings += result.findings.size();
  }
  return findings;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  std::uint64_t points = 0;
  if (!words.empty()) std::from_chars(words[0].data(), words[0].data() + words[0].size(), points);
  if (points == 0) {
    std::fprintf(stderr, "usage: kerf_faults POINTS [SCENARIO...]\n");
    return 2;
  }
  try {
    return walk_all(points, {words.begin() + 1, words.end()}) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kerf_faults: %s\n", error.what());
    return 2;
  }
}
