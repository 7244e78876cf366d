#include "core/world/world_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

template <class T>
class WorldIndexOf : public testing::Test {
 public:
  static constexpr int kDimension = T::value;

  WorldIndexOf() {
    for (int k = 0; k < 200; ++k) {
      ObjectDef def;
      def.kind = static_cast<ObjectKind>(random.below(kObjectKinds));
      def.margin = random.below(2) == 0 ? 0 : 2;
      def.filter = {1ULL << random.below(3), random.below(8), 0};
      def.user_data = random.below(2);
      handles.push_back(world.insert(random_box<kDimension>(random, 20, 1), def).handle);
    }
    world.step();
  }

  /// What a query with this filter has to find, by index.
  template <class Touches>
  std::vector<Handle> expected(const WorldQueryFilter& filter, Touches touches) const {
    std::vector<Handle> found;
    world.for_each([&](Handle handle) {
      const ObjectDef& def = *world.find(handle);
      const bool has_kind = (filter.kinds & 1U << static_cast<unsigned>(def.kind)) != 0;
      if (has_kind && (!filter.filter || may_pair(def.filter, *filter.filter)) &&
          (!filter.accepts || filter.accepts(handle)) && touches(*world.box(handle)))
        found.push_back(handle);
    });
    return found;
  }

  Random random{11};
  World<kDimension> world;
  std::vector<Handle> handles;
  WorldIndex<kDimension> index;
};
TYPED_TEST_SUITE(WorldIndexOf, Dimensions, DimensionNames);

TYPED_TEST(WorldIndexOf, FindsByExactBoxesWhatFiltersAllow) {
  constexpr int kD = TypeParam::value;
  this->index.update(this->world);
  std::size_t found_at_all = 0;
  for (int k = 0; k < 200; ++k) {
    const Box<kD> box = random_box<kD>(this->random, 20, 3);
    WorldQueryFilter filter;
    if (k % 2 == 0) filter.kinds = this->random.below(16);
    if (k % 3 == 0) filter.filter = PairFilter{this->random.below(8), this->random.below(8), 0};
    if (k % 5 == 0) filter.accepts = [&](Handle handle) { return this->world.find(handle)->user_data == 1; };
    std::vector<Handle> found;
    ASSERT_EQ(this->index.overlaps(this->world, box, found, filter), QueryStatus::ok);
    ASSERT_EQ(found, this->expected(filter, [&](const Box<kD>& other) { return overlaps(box, other); }));
    found_at_all += found.size();

    const Vector<kD> point = box.center();
    found.clear();
    ASSERT_EQ(this->index.overlaps(this->world, point, found, filter), QueryStatus::ok);
    ASSERT_EQ(found, this->expected(filter, [&](const Box<kD>& other) {
      return overlaps(Box<kD>{point, point}, other);
    }));
  }
  EXPECT_GT(found_at_all, kD == 2 ? 300U : 50U);
}

TYPED_TEST(WorldIndexOf, WithoutAFilterEveryObjectIsFound) {
  constexpr int kD = TypeParam::value;
  this->index.update(this->world);
  const Box<kD> everything{all<kD>(-100), all<kD>(100)};
  std::vector<Handle> found;
  ASSERT_EQ(this->index.overlaps(this->world, everything, found), QueryStatus::ok);
  EXPECT_EQ(found, this->handles) << "of each category and mask, none among them";
  WorldQueryFilter filter;
  filter.filter = PairFilter{};
  found.clear();
  ASSERT_EQ(this->index.overlaps(this->world, everything, found, filter), QueryStatus::ok);
  EXPECT_LT(found.size(), this->handles.size()) << "as an object of the defaults";
}

TYPED_TEST(WorldIndexOf, CastsHitInOrder) {
  constexpr int kD = TypeParam::value;
  this->index.update(this->world);
  Ray<kD> ray;
  ray.direction[0] = 1;
  ray.origin = all<kD>(7);
  ray.origin[0] = -1;
  const auto touches = [&](const Box<kD>& box) {
    Box<kD> way{ray.origin, ray.origin};
    way.max[0] = 100;
    return overlaps(way, box);
  };
  std::vector<WorldHit> hits;
  ASSERT_EQ(this->index.hits(this->world, Cast<kD>(ray), hits), QueryStatus::ok);
  std::vector<Handle> objects;
  for (const WorldHit& hit : hits) {
    objects.push_back(hit.object);
    EXPECT_EQ(hit.t, std::max(Scalar{0}, this->world.box(hit.object)->min[0] + 1));
  }
  EXPECT_TRUE(std::ranges::is_sorted(hits, {}, &WorldHit::t));
  std::ranges::sort(objects, {}, &Handle::index);
  EXPECT_EQ(objects, this->expected({}, touches));
  WorldHit first;
  ASSERT_EQ(this->index.first_hit(this->world, Cast<kD>(ray), first), QueryStatus::ok);
  EXPECT_EQ(first, hits.empty() ? WorldHit{} : hits.front());
  ray.direction[0] = -1;
  ASSERT_EQ(this->index.first_hit(this->world, Cast<kD>(ray), first), QueryStatus::ok);
  EXPECT_TRUE(first.object.is_none());
}

TYPED_TEST(WorldIndexOf, TheNearestAreTheFirstThatAreAllowed) {
  constexpr int kD = TypeParam::value;
  this->index.update(this->world);
  WorldQueryFilter filter;
  filter.kinds = 1U << static_cast<unsigned>(ObjectKind::moving);
  std::vector<WorldNeighbour> found;
  const Nearest<kD> query{all<kD>(10), 5};
  ASSERT_EQ(this->index.nearest(this->world, query, found, filter), QueryStatus::ok);
  ASSERT_EQ(found.size(), 5U);
  for (const WorldNeighbour& neighbour : found)
    EXPECT_EQ(this->world.find(neighbour.object)->kind, ObjectKind::moving);
  const double reach = found.back().squared_distance;
  std::size_t nearer = 0;
  for (const Handle handle : this->expected(filter, [](const Box<kD>&) { return true; })) {
    double squared = 0;
    for (int axis = 0; axis < kD; ++axis) {
      const Box<kD> box = *this->world.box(handle);
      const double gap =
          std::max({0.0, static_cast<double>(box.min[axis]) - 10, 10 - static_cast<double>(box.max[axis])});
      squared += gap * gap;
    }
    nearer += squared < reach ? 1 : 0;
  }
  EXPECT_LE(nearer, 4U);
}

TYPED_TEST(WorldIndexOf, RemovedObjectsAreNotFoundNorMistaken) {
  constexpr int kD = TypeParam::value;
  this->index.update(this->world);
  const Box<kD> everything{all<kD>(-100), all<kD>(100)};
  EXPECT_EQ(this->world.remove(this->handles[3]), WorldStatus::ok);
  this->world.step();
  const Handle next = this->world.insert(box_at<kD>({}, 1)).handle;
  ASSERT_EQ(next.index(), this->handles[3].index());
  std::vector<Handle> found;
  ASSERT_EQ(this->index.overlaps(this->world, everything, found), QueryStatus::ok);
  EXPECT_FALSE(std::ranges::any_of(found, [&](Handle handle) { return handle.index() == next.index(); }));
  this->index.update(this->world);
  found.clear();
  ASSERT_EQ(this->index.overlaps(this->world, everything, found), QueryStatus::ok);
  EXPECT_TRUE(std::ranges::find(found, next) != found.end()) << "requests count at once";
  EXPECT_EQ(found, this->expected({}, [](const Box<kD>&) { return true; }));
}

TYPED_TEST(WorldIndexOf, NothingIsFoundAfterARestoreOrInAnotherWorldUntilAnUpdate) {
  constexpr int kD = TypeParam::value;
  const Box<kD> everything{all<kD>(-100), all<kD>(100)};
  const auto found_in = [&](const World<kD>& asked) {
    std::vector<Handle> found;
    EXPECT_EQ(this->index.overlaps(asked, everything, found), QueryStatus::ok);
    WorldHit hit;
    const Cast<kD> cast = SweptBox<kD>{everything, all<kD>(1)};
    EXPECT_EQ(this->index.first_hit(asked, cast, hit), QueryStatus::ok);
    EXPECT_EQ(hit.object.is_none(), found.empty());
    return found.size();
  };
  this->index.update(this->world);
  World<kD> other;
  (void)other.insert(box_at<kD>({}, 1));
  EXPECT_EQ(found_in(other), 0U) << "its handle is that of an object of the first world";
  EXPECT_EQ(found_in(this->world), 200U);
  std::vector<std::uint8_t> state;
  ASSERT_EQ(this->world.save(state), WorldStatus::ok);
  ASSERT_EQ(this->world.restore(state), WorldStatus::ok);
  EXPECT_EQ(found_in(this->world), 0U);
  this->index.update(this->world);
  World<kD> moved = std::move(this->world);
  EXPECT_EQ(found_in(moved), 200U) << "it is the same world";
}

TYPED_TEST(WorldIndexOf, BadQueriesAreRefused) {
  constexpr int kD = TypeParam::value;
  std::vector<Handle> found;
  Box<kD> box = box_at<kD>({}, 1);
  EXPECT_EQ(this->index.overlaps(this->world, box, found), QueryStatus::ok) << "an index of nothing";
  EXPECT_TRUE(found.empty());
  this->index.update(this->world);
  box.min[0] = std::numeric_limits<Scalar>::quiet_NaN();
  EXPECT_EQ(this->index.overlaps(this->world, box, found), QueryStatus::not_a_number);
  EXPECT_EQ(this->index.overlaps(this->world, Sphere<kD>{{}, -1}, found), QueryStatus::not_ordered);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace kerf::test
