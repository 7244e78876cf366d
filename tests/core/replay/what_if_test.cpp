#include "core/replay/what_if.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/query/explain_event.h"
#include "core/replay/cursor.h"
#include "core/replay/verify.h"
#include "core/trace/event_facts.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

template <class T>
class WhatIf : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;
  using Reader = RecordingReader<kDimension>;

  void SetUp() override {
    Config config = test::busy_config();
    config.merge_fraction = 0.95F;  // or merges are rare
    record(config);
  }

  void record(const Config& config) {
    std::filesystem::remove(file_.path());
    test::record_crowd<kDimension>(file_.path(), kSteps, config);
    reader_ = std::make_shared<Reader>(file_.path());
  }

  /// The first event, from `from` on, of an operator that acted.
  std::optional<Event> first_acted(Operator op, std::uint32_t from = 1) {
    for (std::uint32_t step = from; step <= reader_->steps(); ++step)
      for (const Event& event : reader_->step(step).events)
        if (const auto* acted = acted_of(event); acted != nullptr && acted->op == op) return event;
    return std::nullopt;
  }

  /// The run that `info` describes; it replays and its pairs are exact and those of the first run.
  std::shared_ptr<Reader> rerun_as(const RecordingInfo& info) {
    std::filesystem::remove(rerun_.path());
    EXPECT_TRUE(rerun(*reader_, info, rerun_.path()));
    const Verdict verdict = verify(rerun_.path());
    EXPECT_TRUE(verdict.holds());
    auto other = std::make_shared<Reader>(rerun_.path());
    for (std::uint32_t step = 1; step <= kSteps; ++step)
      EXPECT_EQ(other->row(step).pairs_hash, reader_->row(step).pairs_hash) << "step " << step;
    return other;
  }

  void expect_same_before(Reader& other, std::uint64_t event) {
    for (std::uint64_t id = 0; id < event; ++id) ASSERT_EQ(other.event(id), reader_->event(id));
  }

  static constexpr std::uint32_t kSteps = 60;
  test::TemporaryRecording file_;
  test::TemporaryRecording rerun_;
  std::shared_ptr<Reader> reader_;
};
TYPED_TEST_SUITE(WhatIf, test::Dimensions, test::DimensionNames);

TYPED_TEST(WhatIf, EveryOperatorCanBeRefused) {
  for (int k = 0; k < kOperatorCount; ++k) {
    const auto op = static_cast<Operator>(k);
    SCOPED_TRACE(to_string(op));
    const auto event = this->first_acted(op);
    ASSERT_TRUE(event);
    RecordingInfo info = this->reader_->info();
    Replayer<TypeParam::value> replayer(this->reader_);
    decide(info, replayer, event->id);
    const auto other = this->rerun_as(info);
    this->expect_same_before(*other, event->id);
    const Event refused = other->event(event->id);
    EXPECT_EQ(refused.body, EventBody(OperatorRefused{op, acted_of(*event)->node, Refusal::decided}));
    EXPECT_EQ(other->info().decisions, info.decisions);
  }
}

TYPED_TEST(WhatIf, ASplitTakesAnotherCandidate) {
  constexpr int kD = TypeParam::value;
  const auto event = this->first_acted(Operator::split, 12);
  ASSERT_TRUE(event);
  Replayer<kD> replayer(this->reader_);
  const auto ballot = ballot_of(state_before(replayer, event->id), *event);
  ASSERT_GT(ballot.size(), 1U);
  ASSERT_NE(ballot[1].result, Ballot::undividing);
  RecordingInfo info = this->reader_->info();
  decide(info, replayer, event->id, 1);
  const auto other = this->rerun_as(info);
  this->expect_same_before(*other, event->id);
  const Event happened = other->event(event->id);
  ASSERT_TRUE(has_acted(happened));
  EXPECT_EQ(acted_of(happened)->direction, ballot[1].direction);
  EXPECT_EQ(acted_of(happened)->new_offset, ballot[1].offset);
  Cursor<kD> cursor(other);
  cursor.go_to_event(event->id);
  EXPECT_EQ(cursor.candidates()[0].result, Ballot::overruled);
  EXPECT_FALSE(cursor.candidates()[0].taken);
  EXPECT_EQ(cursor.candidates()[1].result, ballot[1].result);
  EXPECT_TRUE(cursor.candidates()[1].taken);
  const std::string why = to_text(explain_event(cursor.replayer(), event->id), {});
  EXPECT_THAT(why, HasSubstr("  candidate 0: direction " + std::to_string(ballot[0].direction) + ", "));
  EXPECT_THAT(why, HasSubstr("; chosen without the decision\n"));
  EXPECT_THAT(why, HasSubstr("; taken by a decision; by itself " + std::string(to_string(ballot[1].result))));
}

TYPED_TEST(WhatIf, ACursorSeesTheSameRunBackwards) {
  constexpr int kD = TypeParam::value;
  RecordingInfo info = this->reader_->info();
  Replayer<kD> replayer(this->reader_);
  decide(info, replayer, this->first_acted(Operator::split)->id);
  Config config = info.config;
  config.merge = false;
  change_config(info, *this->reader_, 30, config);
  Cursor<kD> cursor(this->rerun_as(info));
  for (std::uint32_t step = TestFixture::kSteps; step > 0; --step) {
    cursor.go_to_step(step);
    ASSERT_EQ(cursor.state().hash(), cursor.recording().row(step).state_hash) << "step " << step;
    ASSERT_EQ(cursor.state().config.merge, step < 30);
  }
}

TYPED_TEST(WhatIf, AParameterChangesFromAStepOn) {
  constexpr std::uint32_t kFrom = 21;
  RecordingInfo info = this->reader_->info();
  Config config = info.config;
  config.split = false;
  change_config(info, *this->reader_, kFrom, config);
  const auto other = this->rerun_as(info);
  for (std::uint32_t step = 1; step < kFrom; ++step)
    ASSERT_EQ(other->row(step).state_hash, this->reader_->row(step).state_hash);
  const auto splits = [](const auto& reader, std::uint32_t step) {
    return reader.row(step).statistics.count(Operator::split);
  };
  EXPECT_EQ(splits(*other, kFrom - 1), splits(*other, TestFixture::kSteps));
  EXPECT_GT(splits(*this->reader_, TestFixture::kSteps), splits(*this->reader_, kFrom - 1));
  EXPECT_EQ(config_of(other->info(), kFrom - 1), this->reader_->info().config);
  EXPECT_EQ(config_of(other->info(), kFrom), config);
}

TYPED_TEST(WhatIf, WhatCannotBeDecidedIsSaid) {
  constexpr int kD = TypeParam::value;
  RecordingInfo info = this->reader_->info();
  Replayer<kD> replayer(this->reader_);
  const auto merge = this->first_acted(Operator::merge)->id;
  const auto split = this->first_acted(Operator::split)->id;
  const auto says = [](const char* text) { return ThrowsMessage<std::invalid_argument>(HasSubstr(text)); };
  EXPECT_THAT([&] { decide(info, replayer, 0); }, says("not an operator that acts"));
  EXPECT_THAT([&] { decide(info, replayer, merge, 0); }, says("only a split has candidates"));
  EXPECT_THAT([&] { decide(info, replayer, split, 1000); }, says("there is no candidate 1000"));
  EXPECT_THROW(decide(info, replayer, UINT64_MAX), std::runtime_error);
  EXPECT_THAT([&] { change_config(info, *this->reader_, 61, info.config); }, says("steps 1 to 60"));
  Config other_directions = info.config;
  other_directions.directions = 32;
  EXPECT_THAT([&] { change_config(info, *this->reader_, 2, other_directions); }, says("from the beginning"));
  EXPECT_TRUE(info.decisions.empty());
  EXPECT_TRUE(info.changes.empty());
}

/// After a decision later events have other numbers.
TYPED_TEST(WhatIf, NothingIsDecidedBeforeAnEarlierDecision) {
  constexpr int kD = TypeParam::value;
  RecordingInfo info = this->reader_->info();
  Replayer<kD> replayer(this->reader_);
  const auto split = this->first_acted(Operator::split)->id;
  const auto later = this->first_acted(Operator::split, 20);
  decide(info, replayer, later->id);
  EXPECT_THROW(decide(info, replayer, later->id), std::invalid_argument);
  EXPECT_THROW(decide(info, replayer, split), std::invalid_argument);
  EXPECT_THROW(change_config(info, *this->reader_, later->step, info.config), std::invalid_argument);
  change_config(info, *this->reader_, later->step + 1, info.config);
  EXPECT_THROW(decide(info, replayer, later->id + 1), std::invalid_argument);
}

/// Entries beyond their cap are shed whatever the decisions.
TYPED_TEST(WhatIf, SheddingIsNotRefused) {
  constexpr int kD = TypeParam::value;
  Config config = test::busy_config();
  config.max_entries = 1;
  config.max_redundancy = 1;
  this->record(config);
  RecordingInfo info = this->reader_->info();
  config.max_entries = 4;
  info.config = config;
  config.max_entries = 1;
  info.changes = {{30, config}};
  this->reader_ = this->rerun_as(info);
  const auto shed = this->first_acted(Operator::merge, 30);
  ASSERT_TRUE(shed);
  Replayer<kD> replayer(this->reader_);
  RecordingInfo decided = this->reader_->info();
  decide(decided, replayer, shed->id);
  const test::TemporaryRecording out;
  EXPECT_THAT([&] { rerun(*this->reader_, decided, out.path()); },
              ThrowsMessage<std::runtime_error>(HasSubstr("raise max_entries")));
  EXPECT_FALSE(std::filesystem::exists(out.path()));
}

TYPED_TEST(WhatIf, StopsWhenAskedAndKeepsWhatWasDone) {
  const test::TemporaryRecording out;
  int asked = 0;
  EXPECT_FALSE(rerun(*this->reader_, this->reader_->info(), out.path(), [&] { return ++asked > 10; }));
  EXPECT_EQ(RecordingReader<TypeParam::value>(out.path()).steps(), 10U);
}

TEST(WhatIfDecide, ATreeThatNumbersNothingTakesNoDecisions) {
  Bsp<2> tree;
  EXPECT_THROW(tree.decide({}), std::invalid_argument);
  Bsp<2, EventLog> watched;
  EXPECT_THROW(watched.decide({{1, Operator::split, ChosenPlane{10'000, 0}}}), std::invalid_argument);
  EXPECT_THROW(watched.decide({{1, Operator::split, ChosenPlane{0, NAN}}}), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
