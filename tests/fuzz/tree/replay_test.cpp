#include <gtest/gtest.h>

#include "tests/fuzz/tree/machine_report.h"

namespace kerf::test {
namespace {

void replay(const char* target, std::string (*run)(CaseBytes)) {
  const std::vector<KeptCase> cases = corpus(KERF_SOURCE_DIR, target);
  EXPECT_GE(cases.size(), 5U);
  for (const KeptCase& kept : cases) EXPECT_EQ(run(kept.bytes), "") << target << "/" << kept.name;
}

TEST(TreeCorpus, OperatorsFindNothing) { replay("operators", operators_case); }
TEST(TreeCorpus, BroadPhaseFindsNothing) { replay("broad_phase", broad_phase_case); }

}  // namespace
}  // namespace kerf::test
