#include "core/recording/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "core/recording/keyframe_codec.h"
#include "core/recording/recording_reader.h"
#include "core/recording/schema.h"
#include "core/replay/verify.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/recorded_crowd.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

template <class T>
class Recording : public testing::Test {};
TYPED_TEST_SUITE(Recording, test::Dimensions, test::DimensionNames);

TYPED_TEST(Recording, HasEachStepAndEvent) {
  constexpr int kD = TypeParam::value;
  const TemporaryRecording file;
  Bsp<kD, EventLog> tree(test::busy_config());
  Recorder<kD> recorder(tree, file.path(), test::info_of<kD>(tree.config()));
  std::vector<StepRow> rows;
  test::play_crowd<kD>(recorder, 60, 1, [&](std::uint32_t step) {
    rows.push_back({.step = step, .statistics = tree.statistics(), .pairs = tree.pairs().size()});
    rows.back().state_hash = tree.state_hash();
  });
  recorder.finish();
  const std::vector<Event> events = tree.trace().take();

  RecordingReader<kD> reader(file.path());
  EXPECT_TRUE(reader.info().complete);
  EXPECT_EQ(to_string(reader.info().config), to_string(tree.config()));
  ASSERT_EQ(reader.steps(), rows.size());
  std::vector<Event> read;
  for (const StepRow& row : rows) {
    EXPECT_EQ(reader.row(row.step).state_hash, row.state_hash);
    EXPECT_EQ(reader.row(row.step).statistics.entries, row.statistics.entries);
    EXPECT_EQ(reader.row(row.step).statistics.operators, row.statistics.operators);
    EXPECT_EQ(reader.row(row.step).pairs, row.pairs);
    EXPECT_EQ(reader.row(row.step).first_event, read.size());
    for (const Event& event : reader.step(row.step).events) read.push_back(event);
  }
  EXPECT_EQ(read, events);
  EXPECT_EQ(reader.step_of(0), 1U);
  EXPECT_EQ(reader.step_of(events.back().id), 60U);
  EXPECT_EQ(reader.step_of(events.size()), std::nullopt);
}

TYPED_TEST(Recording, HoldsForEveryPolicyAndVolume) {
  constexpr int kD = TypeParam::value;
  const auto holds = [](const Config& config, VolumeKind kind) {
    const TemporaryRecording file;
    test::record_crowd<kD>(file.path(), 120, config, kind);
    const Verdict verdict = verify(file.path());
    EXPECT_EQ(verdict.steps, 120U);
    EXPECT_GT(verdict.pairs, 0U);
    EXPECT_TRUE(verdict.holds()) << to_string(config) << " " << to_string(kind) << " "
                                 << (verdict.divergence ? verdict.divergence->replayed : "");
  };
  holds(test::busy_config(), VolumeKind::box);
  holds(tuned_config(), VolumeKind::box);
  holds(test::config_of("min_threshold=8,max_threshold=8,byte_sweep=1,skin=4,bulk_factor=2"),
        VolumeKind::box);
  for (const VolumeKind kind : volume_kinds<kD>()) holds(test::busy_config(), kind);
}

TYPED_TEST(Recording, KeyframesGoOnAsTheTreeDid) {
  constexpr int kD = TypeParam::value;
  for (const char* const policy : {"byte_sweep=0", "byte_sweep=1,skin=4"}) {
    Config config = test::busy_config();
    kerf::apply(config, policy);
    Bsp<kD, EventLog> tree(config);
    Bsp<kD, EventLog> again(config);
    StepRequests<kD> none;
    std::vector<std::uint64_t> hashes;
    std::vector<BspState<kD>> states;
    test::play_crowd<kD>(tree, 80, 1, [&](std::uint32_t step) {
      if (step == 40) states.push_back(tree.state());
    });
    const Bytes bytes = encode_keyframe(states.front());
    again.restore(decode_keyframe<kD>(bytes, make_projector<kD>(config, VolumeKind::box)));
    Bsp<kD, EventLog> copied(config);
    copied.restore(states.front());
    EXPECT_EQ(again.state_hash(), copied.state_hash()) << policy;
    for (int step = 0; step < 20; ++step) {
      again.step();
      copied.step();
      ASSERT_EQ(again.state_hash(), copied.state_hash()) << policy;
      EXPECT_TRUE(test::same_pairs(again.pairs(), copied.pairs()));
    }
  }
}

TYPED_TEST(Recording, KeyframesHoldAllThatIsKnownOfSkins) {
  constexpr int kD = TypeParam::value;
  const Config config;
  BspState<kD> state = Bsp<kD>(config).state();
  state.skins = {
      Skin{},
      {.level = 2, .wrapped = true, .wraps = 3, .restless = 4, .since = 60000, .seen = 50000},
  };
  const Bytes bytes = encode_keyframe(state);
  EXPECT_EQ(decode_keyframe<kD>(bytes, make_projector<kD>(config, VolumeKind::box)).skins, state.skins);
}

TYPED_TEST(Recording, ADifferentRunIsNamedByStepAndEvent) {
  constexpr int kD = TypeParam::value;
  const TemporaryRecording file;
  test::record_another_run<kD>(file.path(), 60);
  const Verdict verdict = verify(file.path());
  ASSERT_TRUE(verdict.divergence);
  ASSERT_TRUE(verdict.divergence->event);
  RecordingReader<kD> reader(file.path());
  EXPECT_EQ(reader.step_of(*verdict.divergence->event), verdict.divergence->step);
  EXPECT_NE(verdict.divergence->recorded, verdict.divergence->replayed);
  EXPECT_THAT(verdict.divergence->recorded,
              HasSubstr("e" + std::to_string(*verdict.divergence->event) + " "));
}

TYPED_TEST(Recording, AChangedHashIsNamedByItsStep) {
  const TemporaryRecording file;
  test::record_crowd<TypeParam::value>(file.path(), 30, test::busy_config());
  file.change("UPDATE steps SET state_hash = 1 WHERE step = 17");
  const Verdict verdict = verify(file.path());
  ASSERT_TRUE(verdict.divergence);
  EXPECT_EQ(verdict.divergence->step, 17U);
  EXPECT_EQ(verdict.divergence->event, std::nullopt);
  ASSERT_TRUE(verdict.change);
  EXPECT_EQ(verdict.change->step, 17U);
}

std::string refusal(const std::filesystem::path& path) {
  try {
    (void)read_recording_info(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "opened";
}

TEST(RecordingFile, WhatCannotBeReadIsRefusedClearly) {
  const TemporaryRecording file;
  EXPECT_THAT(refusal(file.path()), HasSubstr("there is no recording"));
  std::ofstream(file.path()) << "a text, long enough to be looked at as if it were a database of some kind";
  EXPECT_THAT(refusal(file.path()), HasSubstr("is no recording of Kerf"));
  std::filesystem::remove(file.path());
  file.change("CREATE TABLE something(x)");
  EXPECT_THAT(refusal(file.path()), HasSubstr("is no recording of Kerf"));
  std::filesystem::remove(file.path());
  test::record_crowd<2>(file.path(), 3, test::busy_config());
  EXPECT_EQ(refusal(file.path()), "opened");
  EXPECT_THROW(RecordingReader<3>{file.path()}, std::runtime_error);
  file.change("PRAGMA user_version = 99");
  EXPECT_THAT(refusal(file.path()),
              HasSubstr("version 99, and this Kerf reads versions " + std::to_string(kRecordingVersion)));
}

TEST(RecordingFile, OneOfAnotherVersionIsStillARecording) {
  const TemporaryRecording file;
  EXPECT_FALSE(is_recording(file.path()));
  EXPECT_FALSE(is_recording(file.path().parent_path()));
  std::ofstream(file.path()) << "a text, long enough to be looked at as if it were a database of some kind";
  EXPECT_FALSE(is_recording(file.path()));
  std::filesystem::remove(file.path());
  file.change("CREATE TABLE something(x)");
  EXPECT_FALSE(is_recording(file.path()));
  std::filesystem::remove(file.path());
  test::record_crowd<2>(file.path(), 3, test::busy_config());
  EXPECT_TRUE(is_recording(file.path()));
  file.change("PRAGMA user_version = 1; DROP TABLE meta");
  EXPECT_TRUE(is_recording(file.path()));
}

TEST(RecordingFile, AMissingStepOrBlockIsNamed) {
  const TemporaryRecording file;
  test::record_crowd<2>(file.path(), 60, test::busy_config());
  EXPECT_THROW((void)RecordingReader<2>(file.path()).step(61), std::runtime_error);
  const auto opening = [&] { RecordingReader<2>{file.path()}; };
  file.change("DELETE FROM blocks WHERE first_step = 26");
  EXPECT_THAT(opening,
              ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("block of step 26 is missing")));
  file.change("DELETE FROM steps WHERE step = 5");
  EXPECT_THAT(opening, ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("step 5 is missing")));
}

TEST(RecordingFile, AnotherFileIsNeverOverwritten) {
  const TemporaryRecording file;
  std::ofstream(file.path()) << "mine";
  EXPECT_THROW(test::record_crowd<2>(file.path(), 1, test::busy_config()), std::runtime_error);
  EXPECT_EQ(std::filesystem::file_size(file.path()), 4U);
}

/// Records until it is killed.
[[noreturn]] void record_for_ever(const std::filesystem::path& path) {
  Config config = test::busy_config();
  config.directions = 16;  // to begin soon
  test::record_crowd<3>(path, UINT32_MAX, config);
  _exit(0);
}

TEST(RecordingFile, KilledAtAnyMomentThePrefixOpens) {
  Random random(1);
  std::uint32_t longest = 0;
  std::uint32_t patience = 30'000;  // microseconds; more where the machine is slow
  for (int kill_number = 0; kill_number < 50; ++kill_number) {
    const TemporaryRecording file;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) record_for_ever(file.path());
    std::this_thread::sleep_for(std::chrono::microseconds(random.below(patience)));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    if (!std::filesystem::exists(file.path()) || refusal(file.path()) != "opened") {  // before its tables
      patience = std::min(patience + patience / 8, 2'000'000U);
      continue;
    }
    const Verdict verdict = verify(file.path(), 0);
    EXPECT_TRUE(verdict.holds()) << "killed the " << kill_number << "th time";
    longest = std::max(longest, verdict.steps);
    if (longest == 0) patience = std::min(2 * patience, 2'000'000U);
  }
  EXPECT_GT(longest, 10U);
}

TEST(RecordingFile, CanBeReadWhileItIsWritten) {
  const TemporaryRecording file;
  Bsp<2, EventLog> tree(test::busy_config());
  Recorder<2> recorder(tree, file.path(), test::info_of<2>(tree.config()));
  test::play_crowd<2>(recorder, 40, 1, [&](std::uint32_t step) {
    if (step != 35) return;
    RecordingReader<2> reader(file.path());
    EXPECT_EQ(reader.steps(), 25U);
    EXPECT_FALSE(reader.info().complete);
    EXPECT_TRUE(verify(file.path()).holds());
  });
}

}  // namespace
}  // namespace kerf::test
