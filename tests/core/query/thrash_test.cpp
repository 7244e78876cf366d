#include "core/query/thrash.h"

#include <gmock/gmock.h>

#include "core/recording/recording_reader.h"
#include "core/trace/event_facts.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

using Kind = OperatorRow::Kind;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

OperatorRow row(std::uint64_t event, std::uint32_t step, Kind kind, Operator op, std::uint32_t node,
                float shift = 0) {
  return {
      .event = event, .step = step, .kind = kind, .op = op, .node = {NodeId{node}, 0}, .new_offset = shift};
}

TEST(Thrash, ANodeSplitMergedAndSplitAgainIsFound) {
  const std::vector<OperatorRow> rows{row(1, 10, Kind::acted, Operator::split, 7),
                                      row(2, 20, Kind::acted, Operator::merge, 7),
                                      row(3, 30, Kind::acted, Operator::shift_split, 7)};
  const auto found = find_thrash(rows, 100, 20);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, ThrashKind::split_merge_split);
  EXPECT_EQ(found[0].event, 3U);
  EXPECT_THAT(to_text(found[0], {}), HasSubstr("n7 was split, merged and split again, steps 10 to 30"));
  std::vector<std::string> names;
  for (int step = 1; step <= 100; ++step) names.push_back(std::to_string(4999 + step));
  EXPECT_THAT(to_text(found[0], GivenNames({}, names)), HasSubstr("steps 5009 to 5029"));
  EXPECT_THAT(find_thrash(rows, 100, 19), IsEmpty()) << "it took longer";
}

TEST(Thrash, OtherNodesAndSplitsWithoutAMergeAreNone) {
  const std::vector<OperatorRow> rows{
      row(1, 10, Kind::acted, Operator::split, 7), row(2, 20, Kind::acted, Operator::merge, 8),
      row(3, 30, Kind::acted, Operator::split, 7), row(4, 31, Kind::refused, Operator::merge, 7),
      row(5, 32, Kind::acted, Operator::split, 7)};
  EXPECT_THAT(find_thrash(rows, 100, 50), IsEmpty());
}

TEST(Thrash, APartitionerThatGoesToAndFroIsFound) {
  std::vector<OperatorRow> rows{row(1, 10, Kind::acted, Operator::balance, 7, 0.5F),
                                row(2, 20, Kind::acted, Operator::balance, 7, -0.5F),
                                row(3, 30, Kind::acted, Operator::balance, 7, 0.5F)};
  const auto found = find_thrash(rows, 100, 20);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, ThrashKind::balance_ping_pong);
  EXPECT_EQ(found[0].first_step, 10U);
  rows[1].new_offset = 0.25;  // follows what moves one way
  EXPECT_THAT(find_thrash(rows, 100, 20), IsEmpty());
}

TEST(Thrash, WhatIsListedAndWaitsIsFoundUntilItIsDone) {
  std::vector<OperatorRow> rows{row(1, 10, Kind::scheduled, Operator::shift_split, 7),
                                row(2, 20, Kind::acted, Operator::split, 7)};
  EXPECT_THAT(find_thrash(rows, 100, 10), IsEmpty());
  const auto late = find_thrash(rows, 100, 9);
  ASSERT_EQ(late.size(), 1U);
  EXPECT_EQ(late[0].kind, ThrashKind::starved);
  EXPECT_EQ(late[0].last_step, 20U);
  rows.pop_back();
  const auto never = find_thrash(rows, 100, 50);
  ASSERT_EQ(never.size(), 1U);
  EXPECT_EQ(never[0].last_step, 100U);
}

TEST(Thrash, ARecordingsOperatorsAreItsEvents) {
  const test::TemporaryRecording file;
  test::record_crowd<2>(file.path(), 40, test::busy_config());
  RecordingReader<2> recording(file.path());
  const auto rows = read_operators(file.path());
  ASSERT_GT(rows.size(), 20U);
  for (const OperatorRow& found : rows) {
    const Event event = recording.event(found.event);
    EXPECT_EQ(event.step, found.step);
    const auto* const acted = acted_of(event);
    EXPECT_EQ(acted != nullptr, found.kind == Kind::acted);
    if (acted == nullptr) continue;
    EXPECT_EQ(acted->op, found.op);
    EXPECT_EQ(acted->node, found.node);
  }
}

}  // namespace
}  // namespace kerf
