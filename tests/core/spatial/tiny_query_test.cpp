// Queries among boxes as small as floats get, with and without denormals taken for zero: the answers are
// those of real arithmetic on the given floats.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/bsp/bsp.h"
#include "core/kernels/machine.h"
#include "core/spatial/spatial_index.h"
#include "core/spatial/touch.h"
#include "core/spatial/tree_walk.h"
#include "tests/hard/flush_to_zero.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

template <class Param>
class TinyQueries : public testing::Test {
 protected:
  static constexpr int kD = Param::value;

  void SetUp() override {
    for (std::uint32_t id = 0; id < 150; ++id)
      ASSERT_EQ(table_.insert({id}, box(), Mobility::moving), Status::ok);
    index_.update(table_);
  }
  void TearDown() override { use_kernel(""); }

  /// Zero, a denormal, or up to 2^-118, often one of a few.
  Scalar number() {
    constexpr std::array kFew{0.0F, 0x1p-149F, 0x1p-127F, 0x1p-126F, 0x1p-125F, 0x1p-124F, 0x1.000002p-125F};
    const Scalar size = random_.below(2) == 0 ? kFew[random_.below(kFew.size())]
                                              : std::ldexp(static_cast<Scalar>(random_.unit()),
                                                           -static_cast<int>(118 + random_.below(30)));
    return random_.below(2) == 0 ? size : -size;
  }
  Vector<kD> point() {
    Vector<kD> p;
    for (Scalar& x : p.value) x = number();
    return p;
  }
  Box<kD> box() {
    const Vector<kD> a = point();
    const Vector<kD> b = point();
    return join(Box<kD>{a, a}, Box<kD>{b, b});
  }
  /// Of no extent, or so little that a processor may take it for none.
  Box<kD> small_box() {
    const Vector<kD> min = point();
    Vector<kD> max = min;
    for (Scalar& x : max.value) x = std::nextafter(x, random_.below(2) == 0 ? x : 1.0F);
    return {min, max};
  }
  /// Not tiny: those are looked at box by box.
  Vector<kD> direction() {
    Vector<kD> way;
    for (Scalar& x : way.value)
      x = random_.below(3) == 0
              ? 0
              : std::ldexp(static_cast<Scalar>(random_.uniform(-1, 1)), -static_cast<int>(random_.below(90)));
    return way;
  }

  /// By a look at each box, as this processor usually computes.
  template <class Query>
  std::vector<ObjectId> touched(const Query& query) {
    std::vector<ObjectId> all;
    for (std::uint32_t id = 0; id < table_.bound(); ++id)
      if (touches(query, table_.box({id}))) all.push_back({id});
    return all;
  }
  template <class Region>
  void judge_region(const Region& region) {
    const std::vector<ObjectId> all = touched(region);
    const FlushToZero flush(true);
    std::vector<ObjectId> found;
    ASSERT_EQ(index_.overlaps(region, found), QueryStatus::ok);
    EXPECT_EQ(found, all);
    found.clear();
    auto take = [&found](ObjectId object) {
      found.push_back(object);
      return true;
    };
    ASSERT_EQ(index_.visit(region, make_visitor(take)), QueryStatus::ok);
    std::ranges::sort(found);
    EXPECT_EQ(found, all);
  }
  void judge_cast(const Cast<kD>& cast) {
    const std::vector<ObjectId> all = touched(cast);
    const FlushToZero flush(true);
    std::vector<Hit> least;
    for (const ObjectId object : all) least.push_back({object, entry_of(cast, table_.box(object))});
    std::ranges::sort(least, std::less<>());
    std::vector<Hit> hits;
    ASSERT_EQ(index_.hits(cast, hits), QueryStatus::ok);
    EXPECT_EQ(hits, least);
    Hit first;
    ASSERT_EQ(index_.first_hit(cast, first), QueryStatus::ok);
    EXPECT_EQ(first.object, least.empty() ? ObjectId::none() : least.front().object);
  }
  void judge_nearest(const Nearest<kD>& nearest) {
    std::vector<Neighbour> least;
    for (const ObjectId object : touched(Sphere<kD>{nearest.point, nearest.max_distance}))
      least.push_back({object, squared_distance(nearest.point, table_.box(object))});
    std::ranges::sort(least, std::less<>());
    least.resize(std::min(least.size(), nearest.count));
    const FlushToZero flush(true);
    std::vector<Neighbour> found;
    ASSERT_EQ(index_.nearest(nearest, found), QueryStatus::ok);
    EXPECT_EQ(found, least);
  }

  Random random_{3};
  ObjectTable<kD> table_;
  SpatialIndex<kD> index_;
};
TYPED_TEST_SUITE(TinyQueries, Dimensions, DimensionNames);

TYPED_TEST(TinyQueries, AreExactThoughDenormalsAreZero) {
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    for (int round = 0; round < 200 && !this->HasFailure(); ++round) {
      this->judge_cast(Ray<TestFixture::kD>{this->point(), this->direction()});
      this->judge_cast(SweptBox<TestFixture::kD>{this->box(), this->direction(), 0x1p-60F});
      this->judge_region(this->box());
      this->judge_region(this->small_box());
      this->judge_region(Sphere<TestFixture::kD>{this->point(), std::abs(this->number())});
      this->judge_nearest({this->point(), 1 + static_cast<std::size_t>(round) % 50});
      this->judge_nearest({this->point(), 200, std::abs(this->number())});
      const Plane<TestFixture::kD> plane{this->direction(), this->number()};
      this->judge_region(Frustum<TestFixture::kD>{{&plane, 1}});
    }
  }
}

/// The walk through the tree finds the same, at the same t.
TYPED_TEST(TinyQueries, AreWalkedAlikeThoughDenormalsAreZero) {
  Bsp<TypeParam::value> bsp(tuned_config());
  for (std::uint32_t id = 0; id < this->table_.bound(); ++id)
    ASSERT_EQ(bsp.insert({id}, this->table_.box({id}), Mobility::moving), Status::ok);
  bsp.step();
  TreeWalk<TypeParam::value> walk(bsp.tree(), bsp.objects());
  for (int round = 0; round < 500 && !this->HasFailure(); ++round) {
    const Box<TypeParam::value> box = round % 2 == 0 ? this->box() : this->small_box();
    const Ray<TypeParam::value> ray{this->point(), this->direction()};
    const Nearest<TypeParam::value> nearest{this->point(), 1 + static_cast<std::size_t>(round) % 50};
    for (const auto where : {FlushToZero::Where::everywhere, FlushToZero::Where::operands}) {
      std::array<std::vector<ObjectId>, 2> overlapped;
      std::array<std::vector<Hit>, 2> hits;
      std::array<std::vector<Neighbour>, 2> neighbours;
      std::array<Hit, 2> first;
      {
        const FlushToZero flush(true, where);
        ASSERT_EQ(this->index_.overlaps(box, overlapped[0]), QueryStatus::ok);
        ASSERT_EQ(walk.overlaps(box, overlapped[1]), QueryStatus::ok);
        ASSERT_EQ(this->index_.hits(ray, hits[0]), QueryStatus::ok);
        ASSERT_EQ(walk.hits(ray, hits[1]), QueryStatus::ok);
        ASSERT_EQ(this->index_.first_hit(ray, first[0]), QueryStatus::ok);
        ASSERT_EQ(walk.first_hit(ray, first[1]), QueryStatus::ok);
        ASSERT_EQ(this->index_.nearest(nearest, neighbours[0]), QueryStatus::ok);
        ASSERT_EQ(walk.nearest(nearest, neighbours[1]), QueryStatus::ok);
      }
      EXPECT_EQ(overlapped[1], overlapped[0]);
      EXPECT_EQ(hits[1], hits[0]);
      EXPECT_EQ(first[1], first[0]);
      EXPECT_EQ(neighbours[1], neighbours[0]);
    }
  }
}

/// Where results stay denormal, comparing them takes them for zero.
TYPED_TEST(TinyQueries, TheFirstHitIsTheFirstOfAllThoughDenormalOperandsAreZero) {
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    const FlushToZero flush(true, FlushToZero::Where::operands);
    for (int round = 0; round < 500 && !this->HasFailure(); ++round) {
      const Ray<TestFixture::kD> ray{this->point(), this->direction()};
      std::vector<Hit> hits;
      Hit first;
      ASSERT_EQ(this->index_.hits(ray, hits), QueryStatus::ok);
      ASSERT_EQ(this->index_.first_hit(ray, first), QueryStatus::ok);
      ASSERT_EQ(first.object, hits.empty() ? ObjectId::none() : hits.front().object);
    }
  }
}

TYPED_TEST(TinyQueries, ALengthBelowZeroIsRefusedThoughDenormalsAreZero) {
  constexpr Scalar kTiny = -0x1p-149F;
  const FlushToZero flush(true);
  std::vector<ObjectId> objects;
  std::vector<Hit> hits;
  std::vector<Neighbour> neighbours;
  EXPECT_EQ(this->index_.overlaps(Sphere<TestFixture::kD>{{}, kTiny}, objects), QueryStatus::not_ordered);
  EXPECT_EQ(this->index_.hits(Ray<TestFixture::kD>{{}, all<TestFixture::kD>(1), kTiny}, hits),
            QueryStatus::not_ordered);
  EXPECT_EQ(this->index_.nearest({{}, 1, kTiny}, neighbours), QueryStatus::not_ordered);
}

}  // namespace
}  // namespace kerf::test
