#include "core/replay/judge_theirs.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/replay/oracle.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr JudgedPair judged(std::uint32_t a, std::uint32_t b, PairVerdict verdict) {
  return {{{a}, {b}}, verdict};
}

/// Boxes in a row along x: neighbours overlap, but for the last two, between which is a gap of 0.05.
template <class T>
class JudgeTheirs : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;

  JudgeTheirs() {
    add(0, 1);
    add(0.9, 2);
    add(1.9, 3);
    add(3.05, 4);
  }
  void add(double min, double max, Mobility mobility = Mobility::moving) {
    const ObjectId object{objects_.size()};
    GivenBox<kDimension> box;
    box.max.fill(1);
    box.min[0] = min;
    box.max[0] = max;
    (void)objects_.insert(object, round_outward(box), mobility);
    world_.apply({{{object, box}}, {}});
  }
  [[nodiscard]] std::vector<JudgedPair> judge(const std::vector<Pair>& reported,
                                              const PairDesign& design = {}) const {
    return judge_theirs<kDimension>(reported, oracle_pairs(objects_), objects_, world_, design);
  }
  static constexpr Pair pair(std::uint32_t a, std::uint32_t b) { return {{a}, {b}}; }

  ObjectTable<kDimension> objects_;
  TheirWorld<kDimension> world_;
};
TYPED_TEST_SUITE(JudgeTheirs, test::Dimensions, test::DimensionNames);

TYPED_TEST(JudgeTheirs, RightPairsHaveNoVerdictInWhateverOrderTheyComeIn) {
  EXPECT_THAT(this->judge({this->pair(2, 1), this->pair(1, 0)}), IsEmpty());
}

TYPED_TEST(JudgeTheirs, MissedExtraAndTwice) {
  EXPECT_THAT(this->judge({this->pair(1, 2), this->pair(2, 1), this->pair(2, 3), this->pair(0, 77)}),
              ElementsAre(judged(0, 1, PairVerdict::missed), judged(0, 77, PairVerdict::extra),
                          judged(2, 3, PairVerdict::extra), judged(1, 2, PairVerdict::twice)));
}

TYPED_TEST(JudgeTheirs, BoxesAreComparedAsTheyWereGiven) {
  this->add(4 + 1e-12, 5);  // beside the last: in floats, rounded outward, the two overlap
  ASSERT_TRUE(overlaps(this->objects_.box({3}), this->objects_.box({4})));
  const std::vector<Pair> right{this->pair(0, 1), this->pair(1, 2)};
  EXPECT_THAT(this->judge(right), IsEmpty());
  const ObjectId forged{4'000'000'000};  // must not cost gigabytes
  this->world_.apply({{{forged, std::nullopt}}, {{forged, {1, 6}}}});
  EXPECT_EQ(this->world_.filter(forged), (GivenFilter{1, 6}));
  this->world_.apply({{{{4}, std::nullopt}}, {}});  // from now on the floats say all
  EXPECT_THAT(this->judge(right), ElementsAre(judged(3, 4, PairVerdict::missed)));
}

TYPED_TEST(JudgeTheirs, AMarginExcusesWhatIsReportedAndAsksForNothing) {
  const PairDesign design{{0.03, 0}, {}};
  EXPECT_THAT(this->judge({this->pair(0, 1), this->pair(1, 2)}, design), IsEmpty());
  EXPECT_THAT(this->judge({this->pair(0, 1), this->pair(1, 2), this->pair(2, 3), this->pair(0, 3)}, design),
              ElementsAre(judged(0, 3, PairVerdict::extra), judged(2, 3, PairVerdict::margin)));
  EXPECT_THAT(this->judge({this->pair(0, 1)}, design), ElementsAre(judged(1, 2, PairVerdict::missed)));
}

TYPED_TEST(JudgeTheirs, FiltersAndTheListAreIgnoredReportedOrNot) {
  this->world_.apply({{}, {{{0}, {1, 6}}, {{1}, {8, 255}}}});
  const PairDesign design{{}, {this->pair(1, 2)}};
  EXPECT_THAT(this->judge({}, design),
              ElementsAre(judged(0, 1, PairVerdict::filtered), judged(1, 2, PairVerdict::listed)));
  EXPECT_THAT(this->judge({this->pair(0, 1), this->pair(1, 2)}, design), IsEmpty())
      << "reported, and they do overlap";
  EXPECT_FALSE(lets_pass({1, 2}, {1, 2}));
  EXPECT_TRUE(lets_pass({1, 2}, {2, 1}));
  EXPECT_FALSE(lets_pass({1, 2}, {2, 2}));
}

/// Masks and lists excuse what an engine leaves out, and nothing that it reports where no boxes overlap.
TYPED_TEST(JudgeTheirs, AReportedPairWithoutAnOverlapIsExtraInSpiteOfFiltersAndTheList) {
  this->world_.apply({{}, {{{0}, {1, 6}}, {{2}, {1, 6}}}});
  const PairDesign design{{0.03, 0}, {this->pair(1, 3), this->pair(2, 3)}};
  ASSERT_FALSE(lets_pass(this->world_.filter({0}), this->world_.filter({2})));
  EXPECT_THAT(this->judge({this->pair(0, 1), this->pair(1, 2), this->pair(0, 2), this->pair(1, 3),
                           this->pair(2, 3), this->pair(0, 77)},
                          design),
              ElementsAre(judged(0, 2, PairVerdict::extra), judged(0, 77, PairVerdict::extra),
                          judged(1, 3, PairVerdict::extra), judged(2, 3, PairVerdict::margin)));
}

TYPED_TEST(JudgeTheirs, AReportedPairOfFixedObjectsIsExtraInSpiteOfFiltersAndTheList) {
  for (std::uint32_t id = 4; id < 7; ++id) this->add(8, 9, Mobility::fixed);
  this->world_.apply({{}, {{{4}, {1, 2}}}});
  ASSERT_FALSE(lets_pass(this->world_.filter({4}), this->world_.filter({5})));
  EXPECT_THAT(this->judge({this->pair(0, 1), this->pair(1, 2), this->pair(4, 5), this->pair(5, 6)},
                          {{0.03, 0}, {this->pair(5, 6)}}),
              ElementsAre(judged(4, 5, PairVerdict::extra), judged(5, 6, PairVerdict::extra)));
}

/// In floats a margin of 0.05 is nothing beside 5,000,000, where they are 0.5 apart, and 0.3 is as much as
/// 0.5.
TYPED_TEST(JudgeTheirs, AMarginIsRoundedAsTheEngineMayRoundIt) {
  const auto excused = [&](double from, double to, double margin) {
    const std::uint32_t first = this->objects_.size();
    this->add(std::floor(from) - 1, from);
    this->add(to, std::ceil(to) + 1);
    const auto all =
        this->judge({this->pair(0, 1), this->pair(1, 2), this->pair(first, first + 1)}, {{margin, 0}, {}});
    EXPECT_EQ(all.size(), 1U);
    return all.front().verdict == PairVerdict::margin;
  };
  EXPECT_FALSE(excused(5000001.1, 5000002.9, 0.05)) << "floats do not hold what was given";
  EXPECT_TRUE(excused(6000001.1, 6000002.9, 0.95));
  EXPECT_FALSE(excused(7000001, 7000001.5, 0.05));
  EXPECT_TRUE(excused(8000001, 8000002, 0.3)) << "a float engine's boxes are 0.5 larger";
  EXPECT_TRUE(excused(1500, 1500.10009765625, 0.05)) << "they meet in floats";
  EXPECT_TRUE(excused(1600.1, 1600.2001, 0.05)) << "written in few digits";
  EXPECT_FALSE(excused(1700.1, 1700.201, 0.05));
  EXPECT_FALSE(excused(1800.1, 1800.2000000001, 0.05)) << "no float has these digits";
}

/// Written in six digits, two of the boxes touch.
TYPED_TEST(JudgeTheirs, WhatWasRoundedAwayDecidesIsUndecidedReportedOrNot) {
  this->add(4, 5);
  const PairDesign design{{}, {}, {6, 0, false}};
  const std::vector<Pair> right{this->pair(0, 1), this->pair(1, 2)};
  EXPECT_THAT(this->judge(right, design), ElementsAre(judged(3, 4, PairVerdict::undecided)));
  EXPECT_THAT(this->judge({this->pair(3, 4), this->pair(3, 4), this->pair(2, 3)}, design),
              ElementsAre(judged(0, 1, PairVerdict::missed), judged(1, 2, PairVerdict::missed),
                          judged(2, 3, PairVerdict::extra), judged(3, 4, PairVerdict::twice),
                          judged(3, 4, PairVerdict::undecided)));
  EXPECT_THAT(this->judge(right), ElementsAre(judged(3, 4, PairVerdict::missed)));
  EXPECT_THAT(this->judge(right, {{}, {this->pair(3, 4)}, {6, 0, false}}),
              ElementsAre(judged(3, 4, PairVerdict::listed)));
}

TYPED_TEST(JudgeTheirs, AMarginIsWidenedByWhatWasRoundedAway) {
  const std::vector<Pair> all{this->pair(0, 1), this->pair(1, 2), this->pair(2, 3)};
  const auto of_gap = [&](const PairDesign& design) { return this->judge(all, design).front().verdict; };
  EXPECT_EQ(of_gap({{0.0246, 0}, {}, {}}), PairVerdict::extra);
  EXPECT_EQ(of_gap({{0.0201, 0}, {}, {3, 0, false}}), PairVerdict::margin);
  EXPECT_EQ(of_gap({{0.0201, 0}, {}, {0, 2, false}}), PairVerdict::margin);
  EXPECT_EQ(of_gap({{0.0201, 0}, {}, {0, 3, false}}), PairVerdict::extra);
}

TEST(TheirStep, CountsEachVerdict) {
  const std::vector<JudgedPair> all{judged(0, 1, PairVerdict::missed),   judged(0, 2, PairVerdict::extra),
                                    judged(0, 3, PairVerdict::twice),    judged(0, 4, PairVerdict::filtered),
                                    judged(0, 5, PairVerdict::listed),   judged(0, 6, PairVerdict::margin),
                                    judged(0, 7, PairVerdict::undecided)};
  EXPECT_EQ(sum_of(9, all), (TheirStep{9, 1, 1, 1, 3, 1}));
  EXPECT_EQ(by_verdict(all).undecided, (std::vector<Pair>{{{0}, {7}}}));
  EXPECT_EQ(by_verdict(all).ignored.size(), 3U);
}

}  // namespace
}  // namespace kerf
