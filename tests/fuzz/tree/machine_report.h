#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/trace/event.h"
#include "tests/fuzz/corpus.h"

namespace kerf::test {

/// What the cases run so far did. A finding ends its case.
struct MachineReport {
  std::uint64_t cases = 0;
  std::uint64_t requests = 0;                         ///< insert, move, remove, step, parameter change
  std::array<std::uint64_t, kOperatorCount> acted{};  ///< operators that changed a tree
  std::uint64_t refused = 0;                          ///< operators that were called and left the tree alone
  std::uint64_t validations = 0;
  std::uint64_t comparisons = 0;  ///< of all pairs with the oracle's
  std::uint64_t pairs = 0;        ///< compared
  std::string finding;            ///< of the last case; empty: none

  [[nodiscard]] std::uint64_t operators() const {
    std::uint64_t sum = refused;
    for (const std::uint64_t count : acted) sum += count;
    return sum;
  }
};

/// Runs a case on a tree whose operators are called directly, in any order and on any node, beside placement
/// and Algorithm 1. After every operation the tree is validated and, unless a byte says to wait, its pairs
/// are compared with the oracle's. Bytes choose the dimension and the kind of volume as well.
void run_operator_case(CaseBytes bytes, MachineReport& report);

/// Runs a case on a broad phase as callers see it: requests good and bad, parameter changes and steps. It is
/// compared with the oracle, and with itself without a trace.
void run_broad_phase_case(CaseBytes bytes, MachineReport& report);

/// What one such case finds; empty: nothing.
std::string operators_case(CaseBytes bytes);
std::string broad_phase_case(CaseBytes bytes);

}  // namespace kerf::test
