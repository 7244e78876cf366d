#include "core/spatial/spatial_index.h"

#include <limits>
#include <thread>

#include "core/bsp/bsp.h"
#include "core/kernels/machine.h"
#include "core/spatial/batch.h"
#include "core/spatial/touch.h"
#include "tests/hard/flush_to_zero.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"
#include "tests/support/query_judge.h"

namespace kerf::test {
namespace {

template <class Param>
class SpatialIndexTest : public testing::Test {
 protected:
  static constexpr int kDimension = Param::value;

  void judge(std::uint32_t rounds, std::uint64_t seed) {
    TreeWalk<kDimension> walk(bsp_.tree(), bsp_.objects());
    ASSERT_EQ(judge_queries(bsp_.objects(), index_, &walk, rounds, seed), "");
  }

  Bsp<kDimension> bsp_{Config{}};
  MovingBoxes<kDimension> crowd_{bsp_, 20, 2, 1};
  SpatialIndex<kDimension> index_;
};
TYPED_TEST_SUITE(SpatialIndexTest, Dimensions, DimensionNames);

TYPED_TEST(SpatialIndexTest, AnEmptyOneFindsNothing) {
  this->judge(20, 1);
  this->index_.update(this->bsp_.objects());
  this->judge(20, 1);
}

TYPED_TEST(SpatialIndexTest, AnswersAsALookAtEachBoxForAnyNumberOfObjects) {
  for (const std::uint32_t count : {1U, 14U, 1U, 1U, 238U, 2U, 3838U, 3U}) {  // around powers of sixteen
    this->crowd_.add(count, 5);
    this->bsp_.step();
    this->index_.update(this->bsp_.objects());
    ASSERT_EQ(this->index_.size(), this->crowd_.size());
    this->judge(15, count);
  }
}

TYPED_TEST(SpatialIndexTest, AnswersAfterManySteps) {
  this->crowd_.add(600, 7);
  for (int step = 0; step < 60; ++step) {
    if (step % 5 == 1) this->crowd_.remove(20);
    if (step % 7 == 2) this->crowd_.add(10);
    if (step % 11 == 3) this->crowd_.replace(15);
    if (step % 13 == 4) this->crowd_.damage(9);
    if (step % 13 == 9) this->crowd_.heal();
    if (step % 17 == 5) this->crowd_.teleport();
    if (step % 19 == 6) this->crowd_.gather(0.3);
    this->crowd_.walk(0.3);
    if (step % 3 != 0) this->bsp_.step();  // else they are asked between requests and step
    this->index_.update(this->bsp_.objects());
    this->judge(4, static_cast<std::uint64_t>(step));
  }
}

TYPED_TEST(SpatialIndexTest, EveryKernelFindsTheSame) {
  this->crowd_.add(300);
  this->bsp_.step();
  this->index_.update(this->bsp_.objects());
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    this->judge(20, 3);
  }
  use_kernel("");
}

TYPED_TEST(SpatialIndexTest, RefitsWhatMovesAndBuildsWhatIsNew) {
  using Update = typename SpatialIndex<TypeParam::value>::Update;
  this->crowd_.add(300);
  EXPECT_EQ(this->index_.update(this->bsp_.objects()), Update::built);
  this->crowd_.walk(0.01);
  EXPECT_EQ(this->index_.update(this->bsp_.objects()), Update::refit);
  this->crowd_.remove(5);
  EXPECT_EQ(this->index_.update(this->bsp_.objects()), Update::refit);
  this->crowd_.add(6);
  EXPECT_EQ(this->index_.update(this->bsp_.objects()), Update::built);
  this->crowd_.teleport();
  EXPECT_EQ(this->index_.update(this->bsp_.objects()), Update::built);
  this->index_.forget();
  EXPECT_EQ(this->index_.update(this->bsp_.objects()), Update::built);
}

TYPED_TEST(SpatialIndexTest, NothingInTheBroadPhaseChanges) {
  this->crowd_.add(200);
  this->bsp_.step();
  const std::uint64_t before = this->bsp_.state_hash();
  this->index_.update(this->bsp_.objects());
  this->judge(5, 1);
  EXPECT_EQ(this->bsp_.state_hash(), before);
}

TYPED_TEST(SpatialIndexTest, RefusesWhatIsNoQuery) {
  constexpr int kD = TypeParam::value;
  constexpr Scalar kNaN = std::numeric_limits<Scalar>::quiet_NaN();
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  this->crowd_.add(20);
  this->index_.update(this->bsp_.objects());
  std::vector<ObjectId> objects;
  std::vector<Hit> hits;
  std::vector<Neighbour> neighbours;
  Box<kD> box;
  box.max[0] = kNaN;
  EXPECT_EQ(this->index_.overlaps(box, objects), QueryStatus::not_a_number);
  box.max[0] = -1;
  EXPECT_EQ(this->index_.overlaps(box, objects), QueryStatus::not_ordered);
  EXPECT_EQ(this->index_.overlaps(Sphere<kD>{{}, -1}, objects), QueryStatus::not_ordered);
  EXPECT_EQ(this->index_.overlaps(Sphere<kD>{all<kD>(kInfinity), 1}, objects), QueryStatus::not_finite);
  const Plane<kD> plane{all<kD>(1), kInfinity};
  EXPECT_EQ(this->index_.overlaps(Frustum<kD>{{&plane, 1}}, objects), QueryStatus::not_finite);
  EXPECT_EQ(this->index_.hits(Ray<kD>{{}, all<kD>(kInfinity), 1}, hits), QueryStatus::not_finite);
  EXPECT_EQ(this->index_.hits(Ray<kD>{{}, all<kD>(1), -1}, hits), QueryStatus::not_ordered);
  EXPECT_EQ(this->index_.hits(Segment<kD>{{}, all<kD>(kNaN)}, hits), QueryStatus::not_a_number);
  EXPECT_EQ(this->index_.nearest({all<kD>(kNaN), 1}, neighbours), QueryStatus::not_a_number);
  EXPECT_TRUE(objects.empty() && hits.empty() && neighbours.empty());
}

TYPED_TEST(SpatialIndexTest, TinySpheresAreExactThoughDenormalsAreZero) {
  constexpr int kD = TypeParam::value;
  Box<kD> box{all<kD>(-1), all<kD>(1)};
  box.min[0] = 0x1p-68F;
  ASSERT_EQ(this->bsp_.insert({0}, box, Mobility::moving), Status::ok);
  this->index_.update(this->bsp_.objects());
  const FlushToZero flush(true);
  std::vector<ObjectId> found;
  ASSERT_EQ(this->index_.overlaps(Sphere<kD>{{}, 0x1p-69F}, found), QueryStatus::ok);
  EXPECT_TRUE(found.empty()) << "it is half as far as the box";
  ASSERT_EQ(this->index_.overlaps(Sphere<kD>{{}, 0x1p-68F}, found), QueryStatus::ok);
  EXPECT_EQ(found.size(), 1U);
}

TYPED_TEST(SpatialIndexTest, AHitIsNeverAtInfinity) {
  constexpr int kD = TypeParam::value;
  ASSERT_EQ(this->bsp_.insert({0}, slab<kD>(0x1p60F, 0x1p61F), Mobility::moving), Status::ok);
  this->index_.update(this->bsp_.objects());
  Ray<kD> ray{all<kD>(0.5F), {}};
  ray.direction[0] = 0x1p-90F;
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    std::vector<Hit> hits;
    ASSERT_EQ(this->index_.hits(ray, hits), QueryStatus::ok);
    EXPECT_EQ(hits, (std::vector<Hit>{{{0}, std::numeric_limits<Scalar>::max()}})) << kernel;
    Hit first;
    ASSERT_EQ(this->index_.first_hit(ray, first), QueryStatus::ok);
    EXPECT_EQ(first, hits.front()) << kernel;
  }
  use_kernel("");
}

TYPED_TEST(SpatialIndexTest, ACastOfNoLengthHitsWhereItIs) {
  constexpr int kD = TypeParam::value;
  ASSERT_EQ(this->bsp_.insert({0}, {all<kD>(-1), all<kD>(1)}, Mobility::moving), Status::ok);
  this->index_.update(this->bsp_.objects());
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    for (const Scalar length : {0.0F, -0.0F}) {
      Hit first;
      ASSERT_EQ(this->index_.first_hit(Ray<kD>{all<kD>(0), all<kD>(1), length}, first), QueryStatus::ok);
      EXPECT_EQ(first, (Hit{{0}, 0})) << kernel << ' ' << length;
    }
  }
  use_kernel("");
}

TYPED_TEST(SpatialIndexTest, TheNearestStandBehindWhatWasFoundBefore) {
  constexpr int kD = TypeParam::value;
  for (std::uint32_t id = 0; id < 50; ++id)
    ASSERT_EQ(
        this->bsp_.insert({id}, slab<kD>(static_cast<Scalar>(id), static_cast<Scalar>(id)), Mobility::moving),
        Status::ok);
  this->index_.update(this->bsp_.objects());
  for (const std::size_t count : {std::size_t{3}, std::size_t{40}}) {
    std::vector<Neighbour> found{{{99}, 1e9}};
    ASSERT_EQ(this->index_.nearest({all<kD>(0), count}, found), QueryStatus::ok);
    ASSERT_EQ(found.size(), count + 1);
    EXPECT_EQ(found.front(), (Neighbour{{99}, 1e9}));
    for (std::uint32_t k = 0; k < count; ++k) EXPECT_EQ(found[k + 1].object, ObjectId{k});
  }
}

TYPED_TEST(SpatialIndexTest, FiltersByMaskAndByCall) {
  constexpr int kD = TypeParam::value;
  for (std::uint32_t id = 0; id < 20; ++id)
    ASSERT_EQ(this->bsp_.insert({id}, slab<kD>(static_cast<Scalar>(id), static_cast<Scalar>(id) + 0.5F),
                                Mobility::moving),
              Status::ok);
  this->index_.update(this->bsp_.objects());
  std::vector<std::uint32_t> categories(10, 1);
  categories[4] = 2;
  Filter filter;
  filter.mask = 2;
  filter.categories = categories;  // those from 10 on have all
  std::vector<ObjectId> found;
  const Box<kD> everything{all<kD>(-100), all<kD>(100)};
  ASSERT_EQ(this->index_.overlaps(everything, found, filter), QueryStatus::ok);
  ASSERT_EQ(found.size(), 11U);
  EXPECT_EQ(found.front(), ObjectId{4});
  filter.accepts = [](void*, ObjectId object) { return object.value % 2 == 1; };
  Hit first;
  Ray<kD> ray{all<kD>(0.5F), {}, 100};
  ray.direction[0] = 1;
  ASSERT_EQ(this->index_.first_hit(ray, first, filter), QueryStatus::ok);
  EXPECT_EQ(first, (Hit{{11}, 10.5F}));
  std::vector<Neighbour> nearest;
  ASSERT_EQ(this->index_.nearest({all<kD>(0), 2}, nearest, filter), QueryStatus::ok);
  EXPECT_EQ(nearest, (std::vector<Neighbour>{{{11}, 121}, {{13}, 169}}));
}

TYPED_TEST(SpatialIndexTest, AppendsWithoutAllocating) {
  constexpr int kD = TypeParam::value;
  this->crowd_.add(100);
  this->index_.update(this->bsp_.objects());
  std::vector<ObjectId> found{{77}};
  found.reserve(200);
  const ObjectId* const room = found.data();
  ASSERT_EQ(this->index_.overlaps(Box<kD>{all<kD>(-1000), all<kD>(1000)}, found), QueryStatus::ok);
  EXPECT_EQ(found.size(), 101U);
  EXPECT_EQ(found.front(), ObjectId{77});
  EXPECT_EQ(found.data(), room);
}

TYPED_TEST(SpatialIndexTest, ManyAtOnceFindWhatEachFindsAlone) {
  constexpr int kD = TypeParam::value;
  this->crowd_.add(500);
  this->index_.update(this->bsp_.objects());
  Random random(5);
  std::vector<Box<kD>> boxes;
  for (int k = 0; k < 1000; ++k) boxes.push_back(random_box<kD>(random, 20, 2));
  boxes[500].min[0] = std::numeric_limits<Scalar>::quiet_NaN();
  for (const unsigned threads : {1U, 4U}) {
    TaskPool pool(threads);
    BatchResult<ObjectId> result;
    overlaps(this->index_, std::span<const Box<kD>>(boxes), pool, result);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      std::vector<ObjectId> alone;
      ASSERT_EQ(this->index_.overlaps(boxes[k], alone), result.statuses[k]);
      ASSERT_TRUE(std::ranges::equal(alone, result.of(k))) << k;
    }
    EXPECT_EQ(result.statuses[500], QueryStatus::not_a_number);
  }
}

TYPED_TEST(SpatialIndexTest, ThreadsMayAskAtTheSameTime) {
  constexpr int kD = TypeParam::value;
  this->crowd_.add(500);
  this->index_.update(this->bsp_.objects());
  std::vector<std::thread> threads;
  std::vector<std::string> verdicts(4);
  for (std::size_t k = 0; k < verdicts.size(); ++k)
    threads.emplace_back(
        [&, k] { verdicts[k] = judge_queries<kD>(this->bsp_.objects(), this->index_, nullptr, 10, k); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(verdicts, std::vector<std::string>(4));
}

TYPED_TEST(SpatialIndexTest, AWalkSaysWhatItPruned) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> bsp{Config{}};
  MovingBoxes<kD> sparse(bsp, 100, 0.5, 1);
  sparse.add(2000);
  for (int step = 0; step < 30; ++step) bsp.step();
  TreeWalk<kD> walk(bsp.tree(), bsp.objects());
  ASSERT_TRUE(walk.waiting().empty());
  Ray<kD> ray{all<kD>(5), {}, 100};
  ray.direction[0] = 1;
  Hit first;
  ASSERT_EQ(walk.first_hit(ray, first), QueryStatus::ok);
  const auto count = [&](NodeFate fate) { return std::ranges::count(walk.visits(), fate, &NodeVisit::fate); };
  EXPECT_EQ(walk.visits().front().node, bsp.tree().root());
  EXPECT_GT(count(NodeFate::visited), 2);
  EXPECT_GT(count(NodeFate::apart) + count(NodeFate::later), 0);
  for (const NodeVisit& visit : walk.visits()) {
    if (visit.fate == NodeFate::apart) {
      EXPECT_FALSE(touches(Cast<kD>(ray), walk.bounds(visit.node)));
    }
    if (visit.fate == NodeFate::later) {
      EXPECT_GT(visit.key, static_cast<double>(first.t));
    }
  }
}

}  // namespace
}  // namespace kerf::test
