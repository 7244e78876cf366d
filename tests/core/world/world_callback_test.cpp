#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <vector>

#include "core/world/move_list.h"
#include "core/world/world.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

/// Three objects in one place, and what the world is after the next step.
template <class T>
class WorldCallback : public testing::Test {
 public:
  static constexpr int kDimension = T::value;

  WorldCallback() {
    for (World<kDimension>* each : {&world, &untouched}) {
      handles.clear();
      for (int k = 0; k < 3; ++k) handles.push_back(each->insert(box).handle);
      each->step();
    }
    untouched.step();
    EXPECT_EQ(untouched.save(expected), WorldStatus::ok);
  }

  /// Makes a step, in which each pair is reported after `ask`.
  void step_with(const std::function<void()>& ask) {
    world.set_callback([&ask](const WorldPair&) {
      ask();
      return true;
    });
    world.step();
  }
  [[nodiscard]] std::vector<std::uint8_t> saved() const {
    std::vector<std::uint8_t> bytes;
    EXPECT_EQ(world.save(bytes), WorldStatus::ok);
    return bytes;
  }

  const Box<kDimension> box = box_at<kDimension>({}, 1);
  const Box<kDimension> elsewhere = box_at<kDimension>(all<kDimension>(9), 1);
  World<kDimension> world;
  World<kDimension> untouched;
  std::vector<Handle> handles;
  std::vector<std::uint8_t> expected;
};
TYPED_TEST_SUITE(WorldCallback, Dimensions, DimensionNames);

TYPED_TEST(WorldCallback, RequestsAreBusyAndChangeNothing) {
  constexpr int kD = TypeParam::value;
  auto& asker = this->world;
  int asked = 0;
  this->step_with([&] {
    ++asked;
    const auto [status, handle] = asker.insert(this->elsewhere);
    EXPECT_EQ(status, WorldStatus::busy);
    EXPECT_TRUE(handle.is_none());
    EXPECT_EQ(asker.move(this->handles[1], this->elsewhere), WorldStatus::busy);
    EXPECT_EQ(asker.remove(this->handles[2]), WorldStatus::busy);
    EXPECT_EQ(asker.set_kind(this->handles[0], ObjectKind::fixed), WorldStatus::busy);
    EXPECT_EQ(asker.set_filter(this->handles[0], {}), WorldStatus::busy);
    EXPECT_EQ(asker.set_user_data(this->handles[0], 7), WorldStatus::busy);
    EXPECT_EQ(asker.set_margin(this->handles[0], 1), WorldStatus::busy);
    EXPECT_EQ(asker.shift_origin(all<kD>(1)), WorldStatus::busy);
    std::string why;
    EXPECT_EQ(asker.restore(this->expected, &why), WorldStatus::busy);
    EXPECT_EQ(why, to_string(WorldStatus::busy));
    std::vector<std::uint8_t> bytes;
    EXPECT_EQ(asker.save(bytes), WorldStatus::unstepped) << "the step is not done";
  });
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(this->saved(), this->expected);
  EXPECT_EQ(asker.restore(this->expected), WorldStatus::ok);
  EXPECT_EQ(asker.move(this->handles[1], this->elsewhere), WorldStatus::ok) << "the step is over";
}

TYPED_TEST(WorldCallback, EachRequestOfABatchIsBusy) {
  auto& asker = this->world;
  const std::vector boxes(3, this->elsewhere);
  const ObjectDef def;
  this->step_with([&] {
    const std::vector<WorldStatus> all_busy(3, WorldStatus::busy);
    std::vector<WorldStatus> statuses(3);
    std::vector<Handle> given = this->handles;
    EXPECT_EQ(asker.insert(boxes, {&def, 1}, given, statuses), WorldStatus::busy);
    EXPECT_EQ(given, std::vector<Handle>(3));
    EXPECT_EQ(statuses, all_busy);
    statuses.assign(3, {});
    EXPECT_EQ(asker.move(this->handles, boxes, statuses), WorldStatus::busy);
    EXPECT_EQ(statuses, all_busy);
    statuses.assign(3, {});
    EXPECT_EQ(asker.remove(this->handles, statuses), WorldStatus::busy);
    EXPECT_EQ(statuses, all_busy);
  });
  EXPECT_EQ(this->saved(), this->expected);
}

TYPED_TEST(WorldCallback, AMoveListKeepsItsMovesWhileTheWorldIsBusy) {
  auto& asker = this->world;
  MoveList<TypeParam::value> moves;
  moves.add(this->handles[0], this->elsewhere);
  moves.add(this->handles[1], this->elsewhere);
  this->step_with([&] { EXPECT_EQ(moves.send(asker), WorldStatus::busy); });
  EXPECT_EQ(this->saved(), this->expected);
  EXPECT_EQ(moves.send(asker), WorldStatus::ok);
  EXPECT_EQ(*asker.box(this->handles[0]), this->elsewhere);
  EXPECT_EQ(*asker.box(this->handles[1]), this->elsewhere);
  EXPECT_EQ(asker.move(this->handles[0], this->box), WorldStatus::ok);
  EXPECT_EQ(moves.send(asker), WorldStatus::ok);
  EXPECT_EQ(*asker.box(this->handles[0]), this->box) << "moves are made once";
}

TYPED_TEST(WorldCallback, WhatReturnsNoStatusThrows) {
  auto& asker = this->world;
  this->step_with([&] {
    EXPECT_THROW(asker.step(), std::logic_error);
    EXPECT_THROW(asker.set_callback({}), std::logic_error);
    EXPECT_THROW(asker.set_threads(2), std::logic_error);
  });
  EXPECT_EQ(this->saved(), this->expected);
}

TYPED_TEST(WorldCallback, AfterOneThatThrewTheWorldTakesRequests) {
  EXPECT_THROW(this->step_with([] { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(this->world.move(this->handles[0], this->elsewhere), WorldStatus::ok);
  this->world.set_callback({});
  this->world.step();
  EXPECT_EQ(this->world.ended().size(), 2U);
  EXPECT_FALSE(this->saved().empty());
}

}  // namespace
}  // namespace kerf::test
