// What a recording keeps of another engine: it comes back as it was written, and what makes no sense is
// refused.

#include "core/recording/their_rows.h"

#include <gmock/gmock.h>

#include "core/recording/recording_reader.h"
#include "core/recording/schema.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/tampering.h"

namespace kerf {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

template <class T>
class TheirRows : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;

  TheirRows() {
    Bsp<kDimension, EventLog> tree(test::busy_config());
    RecordingInfo info = test::info_of<kDimension>(test::busy_config());
    info.imported = true;
    info.names = GivenNames({{true, 5}, {false, 3}, {false, UINT64_MAX}}, {"5000", "5001.5", "6000"});
    info.design = {{0.1, 0.3}, {{{0}, {2}}, {{1}, {2}}}};
    Recorder<kDimension> recorder(tree, file_.path(), info);
    test::play_crowd<kDimension>(recorder, 3, 3, [&](std::uint32_t step) {
      if (step == 1) recorder.add_theirs(first_);
      if (step == 2) recorder.add_theirs(std::vector<Pair>{{{0}, {2}}, {{0}, {1}}}, judged_);
      if (step == 3) recorder.add_theirs(TheirChanges<kDimension>{{{{1}, std::nullopt}}, {}});
    });
    recorder.finish();
  }
  static GivenBox<kDimension> box() {
    GivenBox<kDimension> box;
    box.min.fill(0.1);
    box.max.fill(std::numeric_limits<double>::infinity());
    return box;
  }
  /// Why the recording cannot be read any more, after a change.
  [[nodiscard]] std::string refusal(const std::string& sql) const {
    file_.change(sql);
    try {
      test::reseal(file_.path());
      const RecordingReader<kDimension> reader(file_.path());
      for (std::uint32_t step = 1; step <= 3; ++step) {
        (void)reader.their_pairs(step);
        (void)reader.judged_pairs(step);
        (void)reader.their_changes(step);
        (void)reader.their_step(step);
      }
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  test::TemporaryRecording file_;
  TheirChanges<kDimension> first_{{{{1}, box()}, {{2}, box()}}, {{{2}, {UINT64_MAX, 6}}}};
  std::vector<JudgedPair> judged_{{{{0}, {1}}, PairVerdict::extra}, {{{1}, {2}}, PairVerdict::listed}};
};
TYPED_TEST_SUITE(TheirRows, test::Dimensions, test::DimensionNames);

TYPED_TEST(TheirRows, ComeBackAsTheyWereWritten) {
  constexpr int kD = TypeParam::value;
  const RecordingReader<kD> reader(this->file_.path());
  EXPECT_EQ(reader.info().names,
            GivenNames({{true, 5}, {false, 3}, {false, UINT64_MAX}}, {"5000", "5001.5", "6000"}));
  EXPECT_EQ(reader.info().design, (PairDesign{{0.1, 0.3}, {{{0}, {2}}, {{1}, {2}}}}));
  EXPECT_EQ(reader.their_changes(1), this->first_);
  EXPECT_EQ(reader.their_changes(2), TheirChanges<kD>());
  EXPECT_THAT(reader.their_pairs(2), ElementsAre(Pair{{0}, {2}}, Pair{{0}, {1}}));
  EXPECT_EQ(reader.judged_pairs(2), this->judged_);
  EXPECT_EQ(reader.their_step(2), (TheirStep{2, 0, 1, 0, 1}));
  EXPECT_FALSE(reader.their_step(1));
  EXPECT_THAT(reader.their_steps(), ElementsAre(std::pair(2U, TheirStep{2, 0, 1, 0, 1})));
  EXPECT_EQ(reader.given_box({1}, 2), this->box());
  EXPECT_FALSE(reader.given_box({1}, 3)) << "then the floats say all";
  EXPECT_FALSE(reader.given_box({0}, 3));
  EXPECT_EQ(reader.filter({2}, 3), (GivenFilter{UINT64_MAX, 6}));
  EXPECT_FALSE(reader.filter({1}, 3));
  EXPECT_TRUE(reader.has_filters());
}

/// The last step of an import that was killed had none.
TYPED_TEST(TheirRows, ACommittedStepHasThem) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording file;
  Bsp<kD, EventLog> tree(test::busy_config());
  RecordingInfo info = test::info_of<kD>(test::busy_config());
  info.imported = true;
  Recorder<kD> recorder(tree, file.path(), info);
  test::play_crowd<kD>(recorder, 27, 3, [&](std::uint32_t step) {
    if (step >= 25) {
      const RecordingReader<kD> reader(file.path());
      EXPECT_TRUE(reader.steps() == 0 || reader.their_step(reader.steps())) << step;
      EXPECT_TRUE(step < 26 || reader.steps() > 0) << step;
    }
    recorder.add_theirs(std::vector<Pair>{{{0}, {2}}}, {});
  });
}

/// An earlier Kerf has no such verdict, and refuses the version.
TYPED_TEST(TheirRows, HowBoxesWereRoundedHasAVersionOfItsOwn) {
  constexpr int kD = TypeParam::value;
  const std::vector<JudgedPair> judged{{{{0}, {1}}, PairVerdict::undecided},
                                       {{{1}, {2}}, PairVerdict::undecided}};
  for (const bool has_structure : {false, true}) {
    const test::TemporaryRecording file;
    Bsp<kD, EventLog> tree(test::busy_config());
    RecordingInfo info = test::info_of<kD>(test::busy_config());
    info.imported = true;
    info.design.rounding = {6, 0, true, 0b100};
    Recorder<kD> recorder(tree, file.path(), info);
    test::play_crowd<kD>(recorder, 3, 3, [&](std::uint32_t step) {
      if (step != 2) return;
      recorder.add_theirs(std::vector<Pair>{{{0}, {1}}}, judged);
      if (has_structure) recorder.add_theirs(TheirStructure<kD>{});
    });
    recorder.finish();
    EXPECT_EQ(Database::open(file.path()).ask("PRAGMA user_version"), kRoundedVersion);
    const RecordingReader<kD> reader(file.path());
    EXPECT_EQ(reader.info().design, info.design);
    EXPECT_EQ(reader.judged_pairs(2), judged);
    EXPECT_EQ(reader.their_step(2), (TheirStep{1, 0, 0, 0, 0, 2}));
    EXPECT_THAT(reader.their_steps(), ElementsAre(std::pair(2U, TheirStep{1, 0, 0, 0, 0, 2})));
    EXPECT_EQ(reader.structure_steps().size(), has_structure ? 1U : 0U);
    file.change("DELETE FROM meta WHERE key = 'bound_planes'");
    EXPECT_EQ(read_design(Database::open(file.path())).rounding.planes, 7U) << "as earlier versions judged";
  }
  EXPECT_EQ(Database::open(this->file_.path()).ask("PRAGMA user_version"), kRecordingVersion);
  EXPECT_THAT(this->refusal("INSERT INTO meta VALUES('bound_digits', '31')"),
              HasSubstr("its bound_digits are 31"));
}

TYPED_TEST(TheirRows, WhatMakesNoSenseIsRefused) {
  EXPECT_THAT(this->refusal(""), IsEmpty());
  EXPECT_THAT(this->refusal("UPDATE their_pairs SET b = -1 WHERE a = 0 AND b = 2"),
              HasSubstr("no object -1"));
  EXPECT_THAT(this->refusal("UPDATE their_pairs SET b = 4294967295 WHERE b = -1"),
              HasSubstr("no object 4294967295"));
  EXPECT_THAT(this->refusal("UPDATE their_pairs SET b = 0 WHERE b = 4294967295"), HasSubstr("do not rise"));
  EXPECT_THAT(this->refusal("DELETE FROM their_pairs; UPDATE their_verdicts SET verdict = 'odd' WHERE a = 0"),
              HasSubstr("no verdict 'odd'"));
  EXPECT_THAT(this->refusal("DELETE FROM their_verdicts; UPDATE their_steps SET missed = -1"),
              HasSubstr("count"));
  EXPECT_THAT(this->refusal("DELETE FROM their_steps; UPDATE their_boxes SET object = -4 WHERE object = 2"),
              HasSubstr("no object -4"));
  EXPECT_THAT(this->refusal("DELETE FROM their_boxes; UPDATE meta SET value = '-1' WHERE key = 'margin'"),
              HasSubstr("margin"));
  EXPECT_THAT(this->refusal("UPDATE meta SET value = '0' WHERE key = 'margin'; UPDATE object_names SET name "
                            "= '3' WHERE object = 0"),
              HasSubstr("object 3 follows object 3"));
  EXPECT_THAT(this->refusal("UPDATE object_names SET name = 'x' WHERE object = 0"),
              HasSubstr("object 0 has no name"));
  EXPECT_THAT(this->refusal("DELETE FROM object_names WHERE object = 0"), HasSubstr("object 0 has no name"));
  EXPECT_THAT(this->refusal("DELETE FROM object_names; UPDATE step_names SET name = '7' WHERE step = 2"),
              HasSubstr("step 7 follows step 5000"));
}

/// What an object was given may stand in an earlier step than the one that is asked about.
TYPED_TEST(TheirRows, WhatWasGivenIsReadOnlyAsItWasWritten) {
  constexpr int kD = TypeParam::value;
  {
    const RecordingReader<kD> reader(this->file_.path());
    EXPECT_TRUE(reader.given_box({2}, 3));
  }
  this->file_.change("UPDATE their_boxes SET min_x = 0.2 WHERE step = 1 AND object = 2");
  const RecordingReader<kD> changed(this->file_.path());
  EXPECT_THROW((void)changed.given_box({2}, 3), std::runtime_error);
  EXPECT_THROW((void)changed.filter({2}, 3), std::runtime_error);
}

TYPED_TEST(TheirRows, AStepThatWasJudgedIsMissed) {
  constexpr int kD = TypeParam::value;
  this->file_.change("DELETE FROM their_steps");
  const RecordingReader<kD> reader(this->file_.path());
  EXPECT_FALSE(reader.their_step(1));
  EXPECT_THROW((void)reader.their_step(2), std::runtime_error);
  EXPECT_THROW((void)reader.their_steps(), std::runtime_error);
}

/// A changed sum would accuse the other engine, or clear it.
TYPED_TEST(TheirRows, SumsOfAllStepsAreReadOnlyAsTheyWereWritten) {
  constexpr int kD = TypeParam::value;
  this->file_.change("UPDATE their_steps SET extra = 0 WHERE step = 2");
  const RecordingReader<kD> reader(this->file_.path());
  EXPECT_THROW((void)reader.their_steps(), std::runtime_error);
}

/// Nor has a run of our own another engine's verdicts because they were put in.
TYPED_TEST(TheirRows, SumsInARunOfOurOwnAreRefused) {
  constexpr int kD = TypeParam::value;
  const test::TemporaryRecording own;
  test::record_crowd<kD>(own.path(), 3, test::busy_config());
  EXPECT_THAT(RecordingReader<kD>(own.path()).their_steps(), IsEmpty());
  own.change("INSERT INTO their_steps VALUES(2, 5, 1, 0, 0, 0)");
  const RecordingReader<kD> reader(own.path());
  EXPECT_THROW((void)reader.their_steps(), std::runtime_error);
}

}  // namespace
}  // namespace kerf
