#include "sims3d/narrow_phase.h"

#include <gmock/gmock.h>

#include <array>

namespace kerf {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr Pair kPair{{0}, {1}};

/// Two unit balls whose middles are 1.5 apart.
class NarrowPhaseTest : public testing::Test {
 protected:
  NarrowPhaseTest() {
    for (const double x : {0.0, 1.5}) {
      geoms_.push_back(make_geom(Ball{1}));
      put(geoms_.size() - 1, x);
    }
  }
  void put(std::size_t geom, double x) { dGeomSetPosition(geoms_[geom].geom.get(), x, 0, 0); }
  void run(std::vector<Pair> candidates, std::array<std::uint8_t, 2> moved) {
    narrow_phase_.run(candidates, geoms_, moved);
  }

  OdeLibrary library_;
  std::vector<Geom> geoms_;
  NarrowPhase narrow_phase_;
};

TEST_F(NarrowPhaseTest, FindsContactsOfCandidatesOnly) {
  run({}, {1, 1});
  EXPECT_THAT(narrow_phase_.contacts(), IsEmpty());
  run({kPair}, {1, 1});
  EXPECT_THAT(narrow_phase_.contacts(), ElementsAre(kPair));
}

TEST_F(NarrowPhaseTest, RemembersWhatRests) {
  run({kPair}, {1, 1});
  run({kPair}, {0, 0});
  ASSERT_THAT(narrow_phase_.touches(), SizeIs(1));
  EXPECT_EQ(narrow_phase_.touches()[0].count, 0U);
  EXPECT_THAT(narrow_phase_.points(narrow_phase_.touches()[0], geoms_), SizeIs(1));
}

TEST_F(NarrowPhaseTest, AsksAgainWhenOneOfThemMoved) {
  run({kPair}, {1, 1});
  put(1, 5);
  run({kPair}, {0, 1});
  EXPECT_THAT(narrow_phase_.contacts(), IsEmpty());
  EXPECT_THAT(narrow_phase_.parted(), ElementsAre(kPair));
}

TEST_F(NarrowPhaseTest, ARestingPairThatWasNoCandidateIsTested) {
  run({}, {1, 1});
  run({kPair}, {0, 0});
  EXPECT_THAT(narrow_phase_.contacts(), ElementsAre(kPair));
  run({}, {0, 0});
  EXPECT_THAT(narrow_phase_.contacts(), IsEmpty());
  EXPECT_THAT(narrow_phase_.parted(), ElementsAre(kPair));
  run({kPair}, {0, 0});
  EXPECT_THAT(narrow_phase_.contacts(), ElementsAre(kPair));
}

}  // namespace
}  // namespace kerf
