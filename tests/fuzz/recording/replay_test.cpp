#include "tests/fuzz/replay.h"

#include <gtest/gtest.h>

#include "core/recording/recording_reader.h"
#include "core/replay/verify.h"
#include "tests/fuzz/recording/recording_cases.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/tampering.h"

namespace kerf::test {
namespace {

TEST(RecordingCorpus, KeyframesFindNothing) { replay("keyframe", keyframe_case, 1); }
TEST(RecordingCorpus, BlocksFindNothing) { replay("block", block_case, 1); }
TEST(RecordingCorpus, LooksFindNothing) { replay("looks", looks_case, 1); }
TEST(RecordingCorpus, ChangedTablesFindNothing) { replay("recording", recording_case, 1); }

/// Without a change nothing is found: the cases begin with a recording that holds.
TEST(RecordingCorpus, TheSmallRecordingHolds) {
  const TemporaryRecording file;
  record_small(file.path());
  const Verdict verdict = verify(file.path());
  EXPECT_TRUE(verdict.holds());
  EXPECT_EQ(verdict.keyframes, 1U);
  EXPECT_FALSE(RecordingReader<2>(file.path()).operators().empty());
  for (const std::string& table : tables_of(file.path())) EXPECT_GT(rows_of(file.path(), table), 0U) << table;
}

}  // namespace
}  // namespace kerf::test
