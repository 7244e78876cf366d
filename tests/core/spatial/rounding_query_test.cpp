// Queries in each rounding mode of the caller: what they find is what they find in the usual one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <functional>
#include <vector>

#include "core/base/random.h"
#include "core/bsp/bsp.h"
#include "core/spatial/spatial_index.h"
#include "core/spatial/touch.h"
#include "core/spatial/tree_walk.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/every_kernel.h"
#include "tests/support/query_maker.h"

namespace kerf::test {
namespace {

/// Calls `ask` while the caller rounds that way.
template <class Ask>
auto rounding(int mode, Ask ask) {
  std::fesetround(mode);
  auto answer = ask();
  EXPECT_EQ(std::fegetround(), mode) << "the caller's mode is its own";
  std::fesetround(FE_TONEAREST);
  return answer;
}

template <class T>
class QueryRounding : public testing::Test {
 public:
  static constexpr int kD = T::value;

  QueryRounding() {
    Random random(7);
    for (std::uint32_t id = 0; id < 300; ++id) {
      Box<kD> box = random_box<kD>(random, 20, 2);
      for (int axis = 0; axis < kD; ++axis) {
        box.min[axis] = id % 2 == 0 ? box.min[axis] : std::floor(box.min[axis]);
        box.max[axis] = std::max(box.min[axis], box.max[axis]);
      }
      EXPECT_EQ(table.insert({id}, box, Mobility::moving), Status::ok);
    }
    index.update(table);
  }
  template <class Query>
  std::vector<ObjectId> touched(const Query& query) const {
    std::vector<ObjectId> all;
    for (std::uint32_t id = 0; id < table.bound(); ++id)
      if (touches(query, table.box({id}))) all.push_back({id});
    return all;
  }
  template <class Region>
  void judge_region(const Region& region) const {
    if (check(region) != QueryStatus::ok) return;
    const std::vector<ObjectId> all = touched(region);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
      EXPECT_EQ(rounding(mode,
                         [&] {
                           std::vector<ObjectId> found;
                           EXPECT_EQ(index.overlaps(region, found), QueryStatus::ok);
                           return found;
                         }),
                all)
          << mode;
  }
  template <class Way>
  void judge_way(const Way& way) const {
    const Cast<kD> cast(way);
    if (check(cast) != QueryStatus::ok) return;
    std::vector<Hit> all;
    for (const ObjectId object : touched(cast)) all.push_back({object, entry_of(cast, table.box(object))});
    std::ranges::sort(all, std::less<>());
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      Hit first;
      EXPECT_EQ(rounding(mode,
                         [&] {
                           std::vector<Hit> found;
                           EXPECT_EQ(index.hits(way, found), QueryStatus::ok);
                           EXPECT_EQ(index.first_hit(way, first), QueryStatus::ok);
                           return found;
                         }),
                all)
          << mode;
      EXPECT_EQ(first.object, all.empty() ? ObjectId::none() : all.front().object) << mode;
    }
  }
  void judge_nearest(const Nearest<kD>& nearest) const {
    if (check(nearest) != QueryStatus::ok) return;
    const auto ask = [&] {
      std::vector<Neighbour> found;
      EXPECT_EQ(index.nearest(nearest, found), QueryStatus::ok);
      return found;
    };
    const std::vector<Neighbour> all = ask();
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
      EXPECT_EQ(rounding(mode, ask), all) << mode;
  }

  ObjectTable<kD> table;
  SpatialIndex<kD> index;
};
TYPED_TEST_SUITE(QueryRounding, Dimensions, DimensionNames);

TYPED_TEST(QueryRounding, ChangesNoAnswer) {
  QueryMaker<TestFixture::kD> maker(this->table, 5);
  for (int round = 0; round < 400 && !this->HasFailure(); ++round) {
    this->judge_region(maker.sphere());
    this->judge_region(maker.frustum());
    this->judge_way(maker.ray());
    this->judge_way(maker.segment());
    this->judge_way(maker.swept());
    this->judge_nearest(maker.nearest());
  }
}

/// Spheres that reach a box by less than a double's last place: exact sums decide.
TYPED_TEST(QueryRounding, KeepsTouchesThatDoublesDoNotSee) {
  for (std::uint32_t id = 0; id < this->table.bound() && !this->HasFailure(); ++id) {
    const Box<TestFixture::kD> box = this->table.box({id});
    for (const Scalar tiny : {0x1.8p-41F, -0x1.8p-41F}) {
      Sphere<TestFixture::kD> sphere{box.min, std::abs(box.min[0])};
      sphere.center[0] = tiny;
      this->judge_region(sphere);
      this->judge_nearest({sphere.center, 3, sphere.radius});
    }
  }
}

/// The walk through the tree, too.
TYPED_TEST(QueryRounding, ChangesNoWalk) {
  Bsp<TestFixture::kD> bsp(tuned_config());
  for (std::uint32_t id = 0; id < this->table.bound(); ++id)
    EXPECT_EQ(bsp.insert({id}, this->table.box({id}), Mobility::moving), Status::ok);
  bsp.step();
  TreeWalk<TestFixture::kD> walk(bsp.tree(), bsp.objects());
  for (std::uint32_t id = 0; id < this->table.bound() && !this->HasFailure(); ++id) {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      Sphere<TestFixture::kD> sphere{this->table.box({id}).min, std::abs(this->table.box({id}).min[0])};
      sphere.center[0] = id % 2 == 0 ? 0x1.8p-41F : -0x1.8p-41F;
      const auto found = rounding(mode, [&] {
        std::vector<ObjectId> all;
        EXPECT_EQ(walk.overlaps(sphere, all), QueryStatus::ok);
        return all;
      });
      EXPECT_EQ(found, this->touched(sphere)) << mode;
    }
  }
}

/// A program may ask for a signal where a number becomes none. The slots beside the objects are empty.
TYPED_TEST(QueryRounding, AFrustumAmongOrdinaryNumbersIsNoInvalidOperation) {
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    for (const Scalar slope : {Scalar{-1}, Scalar{0}, Scalar{1}}) {
      Plane<TestFixture::kD> plane{all<TestFixture::kD>(slope), 3};
      plane.normal[0] = 1;
      std::vector<ObjectId> found;
      if (feenableexcept(FE_INVALID) < 0) GTEST_SKIP() << "there are no such signals here";
      const QueryStatus status = this->index.overlaps(Frustum<TestFixture::kD>{{&plane, 1}}, found);
      fedisableexcept(FE_INVALID);
      EXPECT_EQ(status, QueryStatus::ok);
      EXPECT_FALSE(found.empty());
    }
  }
  use_kernel("");
}

}  // namespace
}  // namespace kerf::test
