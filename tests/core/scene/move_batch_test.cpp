#include "core/scene/move_batch.h"

#include <gmock/gmock.h>

#include <limits>
#include <vector>

#include "core/broad_phase/brute_force.h"

namespace kerf {
namespace {

using testing::ElementsAre;
using testing::Eq;

/// Counts the calls by which an oracle is moved.
class Counted final : public BroadPhase<2> {
 public:
  explicit Counted(VolumeKind kind = VolumeKind::box) : oracle_(kind) {}
  [[nodiscard]] std::string_view name() const override { return oracle_.name(); }
  [[nodiscard]] VolumeKind volume_kind() const override { return oracle_.volume_kind(); }
  Status insert(ObjectId object, const Box<2>& box, Mobility mobility) override {
    return oracle_.insert(object, box, mobility);
  }
  Status move(ObjectId object, const Box<2>& box) override {
    ++single;
    return oracle_.move(object, box);
  }
  Status move(ObjectId object, const Volume<2>& volume) override {
    ++single;
    return oracle_.move(object, volume);
  }
  Status move_many(std::span<const ObjectId> objects, std::span<const Box<2>> boxes) override {
    many.push_back(objects.size());
    Status first = Status::ok;
    for (std::size_t k = 0; k < objects.size(); ++k) {
      const Status status = oracle_.move(objects[k], boxes[k]);
      if (first == Status::ok) first = status;
    }
    return first;
  }
  Status remove(ObjectId object) override { return oracle_.remove(object); }
  void step() override { oracle_.step(); }
  [[nodiscard]] std::span<const Pair> pairs() const override { return oracle_.pairs(); }

  int single = 0;
  std::vector<std::size_t> many;

 private:
  BruteForce<2> oracle_;
};

Box<2> square_at(Scalar x) { return {{{x, 0}}, {{x + 1, 1}}}; }

void insert_three(BroadPhase<2>& broad_phase) {
  for (std::uint32_t k = 0; k < 3; ++k)
    ASSERT_EQ(broad_phase.insert({k}, square_at(10 * static_cast<Scalar>(k)), Mobility::moving), Status::ok);
}

TEST(MoveBatch, SendsAllBoxesInOneCallAndThenForgetsThem) {
  Counted counted;
  insert_three(counted);
  MoveBatch<2> batch;
  batch.add({0}, make_box_volume(square_at(5)));
  batch.add({2}, make_box_volume(square_at(5.5F)));
  EXPECT_FALSE(batch.send(counted));
  EXPECT_FALSE(batch.send(counted));
  EXPECT_THAT(counted.many, ElementsAre(2U, 0U));
  EXPECT_EQ(counted.single, 0);
  counted.step();
  EXPECT_THAT(counted.pairs(), ElementsAre(Pair{{0}, {2}}));
}

TEST(MoveBatch, NamesTheFirstObjectThatWasRefusedBehindOneThatWasClamped) {
  Counted counted;
  insert_three(counted);
  const Scalar infinity = std::numeric_limits<Scalar>::infinity();
  MoveBatch<2> batch;
  batch.add({0}, make_box_volume<2>({{{0, 0}}, {{infinity, 1}}}));
  batch.add({1}, make_box_volume<2>({{{2, 2}}, {{1, 1}}}));
  batch.add({2}, make_box_volume(square_at(7)));
  const auto refusal = batch.send(counted);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->object, ObjectId{1});
  EXPECT_EQ(refusal->status, Status::quarantined);
  counted.step();
  EXPECT_THAT(counted.pairs(), ElementsAre(Pair{{0}, {2}})) << "the others were moved all the same";
}

TEST(MoveBatch, MovesOtherVolumesOneByOne) {
  Counted counted(VolumeKind::sphere);
  insert_three(counted);
  MoveBatch<2> batch;
  batch.add({0}, make_sphere<2>({{5, 0}}, 1));
  batch.add({1}, make_sphere<2>({{6.5F, 0}}, 1));
  EXPECT_FALSE(batch.send(counted));
  EXPECT_EQ(counted.single, 2);
  counted.step();
  EXPECT_THAT(counted.pairs(), ElementsAre(Pair{{0}, {1}}));
}

}  // namespace
}  // namespace kerf
