#include "frames/advise/recorded_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "frames/bench/truth.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

constexpr std::uint32_t kSteps = 40;

template <class T>
class RecordedMotion : public ::testing::Test {
 protected:
  void record(VolumeKind volume = VolumeKind::box) {
    test::record_crowd<T::value>(file_.path(), kSteps, test::busy_config(), volume);
    reader_ = std::make_shared<RecordingReader<T::value>>(file_.path());
  }
  RecordedRun<T::value> run(std::uint32_t first, std::uint32_t last) {
    return {reader_, {first, last, 1}, [](std::uint32_t) {}};
  }

  test::TemporaryRecording file_;
  std::shared_ptr<RecordingReader<T::value>> reader_;
};

TYPED_TEST_SUITE(RecordedMotion, test::Dimensions, test::DimensionNames);

/// Objects come, go, come again with another mobility, and have boxes that cannot be placed.
TYPED_TEST(RecordedMotion, HasThePairsOfTheRecordingInEachStep) {
  constexpr int kD = TypeParam::value;
  this->record();
  for (const std::uint32_t first : {1U, 17U}) {
    const RecordedRun<kD> run = this->run(first, kSteps);
    const auto motion = run.motion();
    for (std::uint32_t step = first;; ++step) {
      EXPECT_EQ(true_pairs(motion->boxes(), motion->moving()).size(), this->reader_->row(step).pairs) << step;
      if (step == kSteps) break;
      motion->advance();
    }
  }
}

TYPED_TEST(RecordedMotion, SaysWhatChanges) {
  constexpr int kD = TypeParam::value;
  this->record();
  const RecordedRun<kD> run = this->run(1, kSteps);
  const auto motion = run.motion();
  std::size_t changes = 0;
  for (std::uint32_t step = 2; step <= kSteps; ++step) {
    std::vector<Box<kD>> boxes(motion->boxes().begin(), motion->boxes().end());
    motion->advance();
    EXPECT_LE(motion->inserted().size() + motion->removed().size(), motion->most_changes());
    changes += motion->inserted().size() + motion->removed().size();
    for (const ObjectId object : motion->removed()) boxes[object.index()] = no_box<kD>();
    for (const ObjectId object : motion->inserted()) {
      EXPECT_TRUE(is_absent(boxes[object.index()])) << "it came and was there";
      boxes[object.index()] = motion->boxes()[object.index()];
    }
    for (const ObjectId object : motion->moved()) {
      EXPECT_FALSE(is_absent(boxes[object.index()])) << "it moved and was not there";
      boxes[object.index()] = motion->boxes()[object.index()];
    }
    EXPECT_TRUE(std::ranges::equal(boxes, motion->boxes())) << step;
  }
  EXPECT_GT(changes, 20U);
}

TYPED_TEST(RecordedMotion, KnowsHowManyAreThereAtOnce) {
  constexpr int kD = TypeParam::value;
  this->record();
  const RecordedRun<kD> run = this->run(17, kSteps);
  std::uint32_t most = 0;
  for (std::uint32_t step = 17; step <= kSteps; ++step)
    most = std::max(most, this->reader_->row(step).statistics.objects);
  EXPECT_EQ(run.most_at_once(), most);
  EXPECT_LT(most, run.objects()) << "some go, and others come";
}

TYPED_TEST(RecordedMotion, TakesTheBoxesOfVolumes) {
  constexpr int kD = TypeParam::value;
  this->record(VolumeKind::sphere);
  const RecordedRun<kD> run = this->run(3, 4);
  const auto motion = run.motion();
  EXPECT_GE(true_pairs(motion->boxes(), motion->moving()).size(), this->reader_->row(3).pairs)
      << "boxes overlap wherever spheres do";
}

}  // namespace
}  // namespace kerf
