#include "core/replay/replayer.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/replay/oracle.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

template <class T>
class ReplayerTest : public testing::Test {};
TYPED_TEST_SUITE(ReplayerTest, test::Dimensions, test::DimensionNames);

/// Goes to random steps, and some steps back from each; everywhere the tree must be as it was.
template <int D>
void wander(const std::filesystem::path& path, std::size_t memory) {
  Replayer<D> replayer(std::make_shared<RecordingReader<D>>(path), memory);
  const RecordingReader<D>& recording = replayer.recording();
  Random random(1);
  for (int k = 0; k < 30; ++k) {
    std::uint32_t step = random.below(recording.steps() + 1);
    for (int back = 0; back < 4 && step > 0; ++back, --step) {
      replayer.seek(step);
      ASSERT_EQ(replayer.step(), step);
      ASSERT_EQ(replayer.tree().state_hash(), recording.row(step).state_hash) << "step " << step;
      ASSERT_EQ(hash_pairs(replayer.tree().pairs()), recording.row(step).pairs_hash) << "step " << step;
      ASSERT_EQ(replayer.tree().statistics().operators, recording.row(step).statistics.operators);
    }
  }
  EXPECT_LE(replayer.memory(), std::max<std::size_t>(memory, 600'000));
}

TYPED_TEST(ReplayerTest, EveryStepIsReachedFromEverywhere) {
  constexpr int kD = TypeParam::value;
  for (const char* const policy : {"byte_sweep=0", "byte_sweep=1,skin=4"}) {
    const test::TemporaryRecording file;
    Config config = test::busy_config();
    kerf::apply(config, policy);
    test::record_crowd<kD>(file.path(), 600, config);  // with keyframes at 256 and 512
    EXPECT_EQ(RecordingReader<kD>(file.path()).keyframes().size(), 2U);
    wander<kD>(file.path(), std::size_t{64} << 20U);
    wander<kD>(file.path(), 500'000);  // hardly any state is kept
  }
}

TYPED_TEST(ReplayerTest, AStepThatIsNotThereIsAnError) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording file;
  test::record_crowd<kD>(file.path(), 5, test::busy_config());
  Replayer<kD> replayer(std::make_shared<RecordingReader<kD>>(file.path()));
  EXPECT_THROW(replayer.seek(6), std::runtime_error);
  replayer.seek(5);
  EXPECT_THROW(replayer.advance(), std::runtime_error);
  EXPECT_EQ(replayer.step(), 5U);
}

TEST(Oracle, JudgesMissedExtraAndTwice) {
  const std::vector<Pair> truth{{{1}, {2}}, {{1}, {3}}, {{4}, {5}}};
  const std::vector<Pair> reported{{{3}, {1}}, {{1}, {2}}, {{2}, {1}}, {{7}, {8}}};
  const PairJudgement judgement = judge_pairs(reported, truth);
  EXPECT_EQ(judgement.missed, (std::vector<Pair>{{{4}, {5}}}));
  EXPECT_EQ(judgement.extra, (std::vector<Pair>{{{7}, {8}}}));
  EXPECT_EQ(judgement.twice, (std::vector<Pair>{{{1}, {2}}}));
  EXPECT_FALSE(judgement.is_exact());
  EXPECT_TRUE(judge_pairs(truth, truth).is_exact());
}

}  // namespace
}  // namespace kerf
