#include <vector>

#include "tests/hard/cases/cases.h"

namespace kerf::test {

std::span<const HardCase> hard_cases() {
  static const std::vector<HardCase> kCases = [] {
    std::vector<HardCase> all;
    for (const auto& part :
         {values_cases(), extremes_cases(), structure_cases(), motion_cases(), operators_cases()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return kCases;
}

}  // namespace kerf::test
