// Random sequences of everything that can be done to a tree. The program kerf_operator_soak runs them for as
// long as requested, and libFuzzer looks for sequences that chance does not find.

#include <gtest/gtest.h>

#include "tests/fuzz/tree/machine_report.h"
#include "tests/fuzz/tree/random_case.h"

namespace kerf::test {
namespace {

TEST(OperatorMachine, FindsNothingInRandomSequences) {
  constexpr std::uint64_t kOperators = 20'000;
  MachineReport report;
  for (std::uint64_t seed = 0; report.operators() < kOperators; ++seed) {
    run_operator_case(random_case(seed), report);
    ASSERT_EQ(report.finding, "") << "seed " << seed;
  }
  for (std::size_t op = 0; op < report.acted.size(); ++op)
    EXPECT_GT(report.acted[op], 100U) << to_string(static_cast<Operator>(op)) << " is hardly tried";
  EXPECT_GT(report.refused, 100U);
  EXPECT_GT(report.pairs, 100'000U);
}

TEST(BroadPhaseMachine, FindsNothingInRandomSequences) {
  constexpr std::uint64_t kRequests = 40'000;
  MachineReport report;
  for (std::uint64_t seed = 0; report.requests < kRequests; ++seed) {
    run_broad_phase_case(random_case(seed), report);
    ASSERT_EQ(report.finding, "") << "seed " << seed;
  }
  for (std::size_t op = 0; op < report.acted.size(); ++op)
    EXPECT_GT(report.acted[op], 20U) << to_string(static_cast<Operator>(op)) << " is hardly tried";
  EXPECT_GT(report.pairs, 50'000U);
}

}  // namespace
}  // namespace kerf::test
