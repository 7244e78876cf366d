#include "core/spatial/lazy_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/random.h"
#include "tests/support/dimensions.h"

namespace kerf {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;

/// Boxes that come, move and go, and what is asked of them.
template <int D>
class Crowd {
 public:
  explicit Crowd(std::size_t count) : boxes_(count) {
    for (std::size_t i = 0; i < count; ++i) set(i, any_box(1));
  }

  void set(std::size_t i, const std::optional<Box<D>>& box) {
    boxes_[i] = box;
    index_.note(id(i));
  }
  /// Some come, some move, some go.
  void change(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = random_.below(static_cast<std::uint32_t>(boxes_.size()));
      set(i, random_.below(3) == 0 ? std::nullopt : std::optional(any_box(1)));
    }
  }
  Box<D> any_box(double size) {
    Box<D> box;
    for (int i = 0; i < D; ++i) {
      box.min[i] = static_cast<Scalar>(random_.uniform(0, 30));
      box.max[i] = box.min[i] + static_cast<Scalar>(random_.uniform(0, size));
    }
    return box;
  }
  Cast<D> any_cast() {
    SweptBox<D> swept{any_box(1), {}};
    for (int i = 0; i < D; ++i) swept.displacement[i] = static_cast<Scalar>(random_.uniform(-9, 9));
    return swept;
  }

  template <class Query>
  std::vector<ObjectId> candidates(const Query& query) {
    return index_.candidates(query, boxes_.size(),
                             [this](ObjectId object) { return boxes_[object.index()]; });
  }
  /// By an index that has never seen anything else.
  template <class Query>
  std::vector<ObjectId> met(const Query& query) const {
    ObjectTable<D> table;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (!boxes_[i]) continue;
      EXPECT_EQ(table.insert(id(i), *boxes_[i], Mobility::moving), Status::ok);
    }
    SpatialIndex<D> fresh;
    fresh.update(table);
    std::vector<ObjectId> found;
    auto take = [&found](ObjectId object) {
      found.push_back(object);
      return true;
    };
    EXPECT_EQ(fresh.visit(query, make_visitor(take)), QueryStatus::ok);
    std::ranges::sort(found);
    return found;
  }
  /// Asks until the index has been packed.
  void pack() {
    for (int k = 0; k < 100; ++k) static_cast<void>(candidates(Box<D>{}));
  }
  static ObjectId id(std::size_t i) { return {static_cast<std::uint32_t>(i)}; }

 private:
  Random random_{3};
  std::vector<std::optional<Box<D>>> boxes_;
  LazyIndex<D> index_;
};

template <class Dimension>
class LazyIndexTest : public ::testing::Test {};
TYPED_TEST_SUITE(LazyIndexTest, test::Dimensions, test::DimensionNames);

TYPED_TEST(LazyIndexTest, MissesNothingAndNamesNothingTwiceHoweverMuchChanges) {
  constexpr int kD = TypeParam::value;
  for (const std::size_t changes : {0, 1, 20, 90, 400}) {
    Crowd<kD> crowd(200);
    for (int k = 0; k < 120; ++k) {
      crowd.change(changes);
      const auto check = [&](const auto& query) {
        std::vector<ObjectId> found = crowd.candidates(query);
        std::ranges::sort(found);
        ASSERT_EQ(std::ranges::adjacent_find(found), found.end());
        ASSERT_TRUE(std::ranges::includes(found, crowd.met(query))) << changes << " changes, query " << k;
      };
      check(crowd.any_box(9));
      check(crowd.any_cast());
    }
  }
}

TYPED_TEST(LazyIndexTest, WhenItIsPackedItNamesWhatIsMetAndWhatChanged) {
  constexpr int kD = TypeParam::value;
  Crowd<kD> crowd(200);
  EXPECT_EQ(crowd.candidates(Box<kD>{}).size(), 200U)
      << "looking at all is cheaper than to pack for one query";
  crowd.pack();
  for (int k = 0; k < 20; ++k) {
    const Box<kD> box = crowd.any_box(9);
    EXPECT_EQ(crowd.candidates(box), crowd.met(box));
    const Cast<kD> cast = crowd.any_cast();
    EXPECT_THAT(crowd.candidates(cast), ::testing::UnorderedElementsAreArray(crowd.met(cast)));
  }
  crowd.set(7, std::nullopt);
  crowd.set(9, crowd.any_box(1));
  Box<kD> nowhere;
  nowhere.min[0] = nowhere.max[0] = -5;
  EXPECT_THAT(crowd.candidates(nowhere), ElementsAre(Crowd<kD>::id(7), Crowd<kD>::id(9)));
}

TYPED_TEST(LazyIndexTest, WhatCannotBeAskedMayMeetAll) {
  constexpr int kD = TypeParam::value;
  Crowd<kD> crowd(50);
  crowd.pack();
  Box<kD> box;
  box.min[0] = std::numeric_limits<Scalar>::quiet_NaN();
  EXPECT_EQ(crowd.candidates(box).size(), 50U);
}

TYPED_TEST(LazyIndexTest, ABoxThatIsNoneIsAlwaysNamed) {
  constexpr int kD = TypeParam::value;
  Crowd<kD> crowd(50);
  Box<kD> box;
  box.max[kD - 1] = std::numeric_limits<Scalar>::quiet_NaN();
  crowd.set(20, box);
  crowd.pack();
  EXPECT_THAT(crowd.candidates(Box<kD>{}), Contains(Crowd<kD>::id(20)));
}

TYPED_TEST(LazyIndexTest, FewerObjectsThanBeforeAreAllThatIsNamed) {
  constexpr int kD = TypeParam::value;
  LazyIndex<kD> index;
  const Box<kD> origin;
  const auto box_of = [&](ObjectId /*object*/) { return std::optional(origin); };
  const auto ask = [&](std::size_t bound) { return index.candidates(origin, bound, box_of); };
  for (const std::size_t bound : {50, 2, 20}) {
    index.forget();
    for (int k = 0; k < 200; ++k) ASSERT_EQ(ask(bound).size(), bound);
  }
}

TYPED_TEST(LazyIndexTest, InfiniteBoxesMeetInfiniteQueries) {
  constexpr int kD = TypeParam::value;
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  Crowd<kD> crowd(50);
  Box<kD> everything;
  Box<kD> far;
  for (int i = 0; i < kD; ++i) {
    everything.min[i] = -kInfinity;
    everything.max[i] = far.min[i] = far.max[i] = kInfinity;
  }
  crowd.set(20, everything);
  crowd.pack();
  EXPECT_THAT(crowd.candidates(far), Contains(Crowd<kD>::id(20)));
}

TYPED_TEST(LazyIndexTest, WhatIsTooLargeToReckonWithMeetsAll) {
  constexpr int kD = TypeParam::value;
  Crowd<kD> crowd(50);
  crowd.pack();
  SweptBox<kD> swept;
  swept.displacement[0] = 2;
  swept.max_t = std::numeric_limits<Scalar>::max();
  EXPECT_EQ(crowd.candidates(Cast<kD>(with_slack(swept))).size(), 50U);
}

TYPED_TEST(LazyIndexTest, ThreadsMayAskAtTheSameTime) {
  constexpr int kD = TypeParam::value;
  Crowd<kD> crowd(300);
  const Box<kD> box = crowd.any_box(20);
  const std::vector<ObjectId> met = crowd.met(box);
  const auto ask = [&] {
    for (int k = 0; k < 200; ++k) {
      std::vector<ObjectId> found = crowd.candidates(box);
      std::ranges::sort(found);
      EXPECT_TRUE(std::ranges::includes(found, met));
    }
  };
  std::thread other(ask);
  ask();
  other.join();
  EXPECT_EQ(crowd.candidates(box), met);
}

}  // namespace
}  // namespace kerf
