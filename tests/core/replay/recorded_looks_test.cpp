#include "core/replay/recorded_looks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/query/scenario.h"
#include "core/recording/shape_rows.h"
#include "core/replay/verify.h"
#include "core/replay/what_if.h"
#include "tests/support/crowd_shapes.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/tampering.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr std::uint32_t kSteps = 300;  ///< with one keyframe, at step 256
constexpr std::uint32_t kKeyframe = 256;

template <class T>
class LooksOfRecording : public testing::Test {
 protected:
  void SetUp() override { test::record_shaped_crowd<T::value>(file_.path(), kSteps); }
  [[nodiscard]] std::filesystem::path path() const { return file_.path(); }
  void change(const std::string& sql) const {
    file_.change(sql);
    test::reseal(path());
  }

 private:
  test::TemporaryRecording file_;
};
TYPED_TEST_SUITE(LooksOfRecording, test::Dimensions, test::DimensionNames);

template <int D>
struct Seen {
  ShapeText shape;
  Turn<D> turn;
  Stretch<D> stretch{};
  friend bool operator==(const Seen&, const Seen&) = default;
};

/// What objects look like, independent of the numbers of shapes.
template <int D>
std::vector<Seen<D>> appearances(RecordingReader<D>& recording, std::uint32_t step) {
  RecordedLooks<D> looks(recording);
  const std::uint32_t bound = looks.at(step).bound();
  std::vector<Seen<D>> all;
  for (std::uint32_t id = 0; id < bound; ++id) {
    const Appearance<D> appearance = looks.appearance({id});
    all.push_back({appearance.shape == nullptr ? ShapeText() : encode_shape<D>(*appearance.shape),
                   appearance.turn, appearance.stretch.value()});
  }
  while (!all.empty() && all.back().shape == ShapeText()) all.pop_back();
  return all;
}

TYPED_TEST(LooksOfRecording, ASeekFindsThoseOfAStraightRun) {
  constexpr int kD = TypeParam::value;
  RecordingReader<kD> recording(this->path());
  ASSERT_TRUE(recording.has_keyframe(kKeyframe));
  EXPECT_EQ(recording.shapes().size(), recording.shape_count());
  EXPECT_GT(recording.shape_count(), 3U);
  Looks<kD> straight;
  std::vector<Looks<kD>> expected{straight};
  for (std::uint32_t step = 1; step <= kSteps; ++step) {
    straight.apply(recording.step(step).looks);
    expected.push_back(straight);
  }
  EXPECT_EQ(recording.keyframe_looks(kKeyframe), expected[kKeyframe]);
  RecordedLooks<kD> looks(recording);
  for (const std::uint32_t step : {300U, 256U, 257U, 258U, 40U, 41U, 41U, 0U, 255U, 256U, 12U})
    EXPECT_EQ(looks.at(step), expected[step]) << "step " << step;
}

/// Objects that have no place have no shape, and one that came again has the new one.
TYPED_TEST(LooksOfRecording, ObjectsThatAreGoneHaveNone) {
  constexpr int kD = TypeParam::value;
  RecordingReader<kD> recording(this->path());
  Looks<kD> looks;
  ObjectTable<kD> objects(recording.info().volume);
  std::size_t gone = 0;
  for (std::uint32_t step = 1; step <= kSteps; ++step) {
    looks.apply(recording.step(step).looks);
    for_each_request(recording.step(step).requests, objects.kind(),
                     [&](const ObjectRequest<kD>& request) { apply(request, objects); });
    for (std::uint32_t id = 0; id < objects.bound(); ++id) {
      EXPECT_EQ(looks.of({id}).shape != kNoShape, objects.is_placed({id})) << id << " in step " << step;
      gone += objects.is_placed({id}) ? 0 : 1;
    }
  }
  EXPECT_GT(gone, 0U);
}

TYPED_TEST(LooksOfRecording, AreVerified) {
  const Verdict verdict = verify(this->path(), 0);
  EXPECT_TRUE(verdict.holds());
  EXPECT_THAT(verdict.shapes, testing::MatchesRegex("[0-9]+ balls?, [0-9]+ bricks?, [0-9]+ [a-z]+"));
  EXPECT_THAT(verdict.unchecked, testing::Contains(HasSubstr("how objects are turned")));
}

TYPED_TEST(LooksOfRecording, ARerunKeepsThem) {
  constexpr int kD = TypeParam::value;
  RecordingReader<kD> recording(this->path());
  const test::TemporaryRecording out;
  ASSERT_TRUE(rerun(recording, recording.info(), out.path()));
  RecordingReader<kD> again(out.path());
  EXPECT_EQ(again.shapes().size(), recording.shapes().size());
  for (const std::uint32_t step : {1U, 77U, 256U, 300U})
    EXPECT_EQ(appearances(again, step), appearances(recording, step)) << "step " << step;
}

/// All steps, fewer of them, from a later step on, and only some of the objects.
TYPED_TEST(LooksOfRecording, AScenarioKeepsThem) {
  constexpr int kD = TypeParam::value;
  const auto recording = std::make_shared<RecordingReader<kD>>(this->path());
  Replayer<kD> replayer(recording);
  const auto recorded = [](const Scenario<kD>& scenario) {
    const test::TemporaryRecording out;
    record(scenario, out.path());
    RecordingReader<kD> again(out.path());
    EXPECT_TRUE(verify(out.path(), 0).holds());
    return appearances(again, again.steps());
  };
  const auto expected = appearances(*recording, 60);
  const Scenario<kD> whole = scenario_of(replayer, 0, 60);
  EXPECT_EQ(recorded(whole), expected);
  EXPECT_EQ(recorded(scenario_of(replayer, 37, 60)), expected);
  EXPECT_EQ(recorded(with_steps(whole, {3, 30, 59})), expected);
  const auto few = recorded(with_objects(whole, {{3}, {10}, {11}}));
  ASSERT_EQ(few.size(), 12U);
  for (const std::size_t id : {3U, 10U, 11U}) EXPECT_EQ(few[id], expected[id]);
  EXPECT_EQ(few[4].shape, ShapeText());
}

TYPED_TEST(LooksOfRecording, WithoutShapesThereAreNone) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording file;
  test::record_crowd<kD>(file.path(), 20, test::busy_config());
  RecordingReader<kD> recording(file.path());
  EXPECT_EQ(recording.shape_count(), 0U);
  EXPECT_EQ(RecordedLooks<kD>(recording).at(20), Looks<kD>());
  EXPECT_EQ(verify(file.path(), 0).shapes, "");
}

// What a forger writes, all hashes being right.

template <int D>
std::string objection(const std::filesystem::path& path) {
  try {
    const Verdict verdict = verify(path, 0);
    return verdict.divergence ? verdict.divergence->replayed + " / " + verdict.divergence->recorded : "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TYPED_TEST(LooksOfRecording, AShapeThatOutgrowsItsBoxIsFound) {
  this->change("UPDATE shapes SET data = x'0000A041' WHERE kind = 'ball'");  // a radius of 20
  EXPECT_THAT(objection<TypeParam::value>(this->path()), HasSubstr("too small for it, of object"));
}

TYPED_TEST(LooksOfRecording, AShapeThatIsNoneIsRefused) {
  this->change("UPDATE shapes SET data = x'0000C07F' WHERE kind = 'ball'");  // not a number
  EXPECT_THAT(objection<TypeParam::value>(this->path()), HasSubstr("a size of nan"));
}

TYPED_TEST(LooksOfRecording, AShapeThatCameLaterIsRefused) {
  constexpr int kD = TypeParam::value;
  this->change("UPDATE shapes SET step = 280");
  EXPECT_THAT(objection<kD>(this->path()), HasSubstr("in step 1 there is no shape"));
  this->change("DELETE FROM shapes");
  EXPECT_THAT(objection<kD>(this->path()), HasSubstr("in step 1 there is no shape"));
}

TYPED_TEST(LooksOfRecording, AKeyframeWithOthersIsFound) {
  constexpr int kD = TypeParam::value;
  Looks<kD> looks = RecordingReader<kD>(this->path()).keyframe_looks(kKeyframe);
  Look<kD> other = looks.of({4});
  other.turn.parts[0] = static_cast<std::int16_t>(other.turn.parts[0] ^ 1);
  looks.set({4}, other);
  test::forge_keyframe_looks(this->path(), kKeyframe, encode_looks(looks));
  EXPECT_THAT(objection<kD>(this->path()), HasSubstr("other shapes or rotations"));
  looks.set({4}, {1'000, {}, {}});
  test::forge_keyframe_looks(this->path(), kKeyframe, encode_looks(looks));
  EXPECT_THAT(objection<kD>(this->path()), HasSubstr("no shape 1000"));
}

}  // namespace
}  // namespace kerf
