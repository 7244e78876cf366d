#include "tests/fuzz/replay.h"

#include "tests/fuzz/tree/machine_report.h"

namespace kerf::test {
namespace {

TEST(TreeCorpus, OperatorsFindNothing) { replay("operators", operators_case, 5); }
TEST(TreeCorpus, BroadPhaseFindsNothing) { replay("broad_phase", broad_phase_case, 5); }

}  // namespace
}  // namespace kerf::test
