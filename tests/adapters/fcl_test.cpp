#include <fcl/broadphase/broadphase_bruteforce.h>
#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "sims3d/fcl/fcl_manager.h"

namespace kerf {
namespace {

using Object = fcl::CollisionObject<double>;
using Pairs = std::multiset<std::pair<Object*, Object*>>;

bool note(Object* a, Object* b, void* data) {
  static_cast<Pairs*>(data)->insert(std::minmax(a, b));
  return false;
}

/// The least distance so far, and how many pairs the narrow phase was asked about.
struct Nearest {
  double least = std::numeric_limits<double>::max();
  int asked = 0;
};

bool measure(Object* a, Object* b, void* data, double& least) {
  auto& nearest = *static_cast<Nearest*>(data);
  ++nearest.asked;
  fcl::DistanceRequest<double> request;
  fcl::DistanceResult<double> result;
  nearest.least = std::min(nearest.least, fcl::distance(a, b, request, result));
  least = nearest.least;
  return least <= 0;
}

class FclManagerTest : public testing::Test {
 protected:
  Object* make(double size) {
    std::shared_ptr<fcl::CollisionGeometry<double>> geometry;
    if (random_.below(2) == 0) {
      geometry = std::make_shared<fcl::Sphere<double>>(random_.uniform(0.3, 0.5) * size);
    } else {
      geometry = std::make_shared<fcl::Box<double>>(size, size * 0.7, size);
    }
    objects_.push_back(std::make_unique<Object>(geometry));
    place(*objects_.back());
    return objects_.back().get();
  }
  void place(Object& object) {
    object.setTranslation({random_.uniform(0, 9), random_.uniform(0, 9), random_.uniform(0, 9)});
    object.computeAABB();
  }

  static constexpr int kQueries = 500'000;  ///< so many that each thread runs while the other one does

  Random random_{8};
  std::vector<std::unique_ptr<Object>> objects_;
  FclManager<double> ours_;
  fcl::NaiveCollisionManager<double> theirs_;
};

TEST_F(FclManagerTest, CallsBackForThePairsOfTheNaiveManagerWhileObjectsComeAndGo) {
  std::vector<Object*> present;
  for (int i = 0; i < 120; ++i) present.push_back(make(1));
  ours_.registerObjects(present);
  theirs_.registerObjects(present);
  ours_.setup();
  Object* const probe = make(3);
  for (int step = 0; step < 100; ++step) {
    std::vector<Object*> moved;
    for (std::size_t k = 0; k < present.size(); k += 3) moved.push_back(present[k]);
    for (Object* object : moved) place(*object);
    if (step % 2 == 0) {
      ours_.update();
    } else {
      ours_.update(moved);
    }
    const std::size_t gone = random_.below(static_cast<std::uint32_t>(present.size()));
    ours_.unregisterObject(present[gone]);
    theirs_.unregisterObject(present[gone]);
    present[gone] = make(1);
    ours_.registerObject(present[gone]);
    theirs_.registerObject(present[gone]);
    Pairs found;
    Pairs expected;
    ours_.collide(&found, note);
    theirs_.collide(&expected, note);
    ASSERT_EQ(found, expected) << "step " << step;
    ASSERT_FALSE(found.empty());
    for (int asked = 0; asked < 4; ++asked) {
      place(*probe);
      found.clear();
      expected.clear();
      ours_.collide(probe, &found, note);
      for (Object* object : present)
        if (object->getAABB().overlap(probe->getAABB())) note(object, probe, &expected);
      ASSERT_EQ(found, expected);
    }
  }
  EXPECT_EQ(ours_.size(), 120U);
}

TEST_F(FclManagerTest, DistancesAreThoseOfTheNaiveManagerAndFewPairsAreAsked) {
  for (int round = 0; round < 20; ++round) {
    ours_.clear();
    theirs_.clear();
    for (int i = 0; i < 40; ++i) {
      Object* const object = make(0.3);
      ours_.registerObject(object);
      theirs_.registerObject(object);
    }
    Object* const probe = make(0.3);
    Nearest found;
    Nearest expected;
    ours_.distance(&found, measure);
    theirs_.distance(&expected, measure);
    EXPECT_DOUBLE_EQ(found.least, expected.least);
    EXPECT_LT(found.asked, 40);  // of 780 pairs
    Nearest near;
    Nearest expected_near;
    ours_.distance(probe, &near, measure);
    theirs_.distance(probe, &expected_near, measure);
    EXPECT_DOUBLE_EQ(near.least, expected_near.least);
    EXPECT_LT(near.asked, 10);
  }
}

/// Enough queries for the index to be packed, in two clusters far apart, with probes that are points, too.
TEST_F(FclManagerTest, WhatIsNearestIsFoundByTheIndexWhileObjectsMove) {
  const auto shift = [](Object& object) {
    object.setTranslation(object.getTranslation() + fcl::Vector3d(1e4, 0, 1e4));
    object.computeAABB();
  };
  for (int i = 0; i < 200; ++i) {
    Object* const object = make(0.2);
    if (i % 2 == 0) shift(*object);
    ours_.registerObject(object);
    theirs_.registerObject(object);
  }
  Object* const probe = make(0.2);
  objects_.push_back(std::make_unique<Object>(std::make_shared<fcl::Sphere<double>>(0)));
  Object* const point = objects_.back().get();
  for (int asked = 0; asked < 400; ++asked) {
    Object* const asking = asked % 3 == 0 ? point : probe;
    for (Object* object : {asking, objects_[random_.below(200)].get()}) {
      place(*object);
      if (random_.below(2) == 0) shift(*object);
    }
    ours_.update();
    Nearest found;
    Nearest expected;
    ours_.distance(asking, &found, measure);
    theirs_.distance(asking, &expected, measure);
    ASSERT_DOUBLE_EQ(found.least, expected.least) << asked;
    ASSERT_LT(found.asked, 30);
    if (asked % 20 != 0) continue;
    Nearest two;
    Nearest expected_two;
    ours_.distance(&two, measure);
    theirs_.distance(&expected_two, measure);
    ASSERT_DOUBLE_EQ(two.least, expected_two.least) << asked;
  }
}

TEST_F(FclManagerTest, NoOtherPairIsAskedWhenTwoObjectsOverlap) {
  for (int i = 0; i < 60; ++i) {
    Object* const object = make(30);  // all overlap
    ours_.registerObject(object);
    theirs_.registerObject(object);
  }
  Nearest found;
  Nearest expected;
  const auto go_on = [](Object* a, Object* b, void* data, double& least) {
    static_cast<void>(measure(a, b, data, least));
    least = std::max(least, 0.0);
    return false;
  };
  ours_.distance(&found, go_on);
  theirs_.distance(&expected, go_on);
  EXPECT_EQ(expected.asked, 1);
  EXPECT_EQ(found.asked, 1);
}

TEST_F(FclManagerTest, ATinyGapIsNoOverlapAndIsAsked) {
  const auto shape = std::make_shared<fcl::Box<double>>(1, 1, 1);
  for (const double x : {0.5, -0.5 - 1e-200}) {
    objects_.push_back(std::make_unique<Object>(shape));
    objects_.back()->setTranslation({x, 0, 0});
  }
  objects_[0]->computeAABB();
  objects_[1]->computeAABB();
  const_cast<fcl::AABB<double>&>(objects_[0]->getAABB()).min_[0] = 1e-200;  // whose square is 0
  const_cast<fcl::AABB<double>&>(objects_[1]->getAABB()).max_[0] = -1e-200;
  for (const auto& object : objects_) {
    ours_.registerObject(object.get());
    theirs_.registerObject(object.get());
  }
  Nearest found;
  Nearest expected;
  ours_.distance(&found, measure);
  theirs_.distance(&expected, measure);
  EXPECT_EQ(expected.asked, 1);
  EXPECT_EQ(found.asked, 1);
}

TEST_F(FclManagerTest, TwoManagersMeet) {
  fcl::DynamicAABBTreeCollisionManager<double> others;
  std::vector<Object*> here;
  std::vector<Object*> there;
  for (int i = 0; i < 60; ++i) {
    here.push_back(make(1));
    there.push_back(make(1));
  }
  ours_.registerObjects(here);
  others.registerObjects(there);
  others.setup();
  Pairs found;
  Pairs expected;
  ours_.collide(&others, &found, note);
  Nearest expected_near;
  for (Object* a : here)
    for (Object* b : there) {
      if (a->getAABB().overlap(b->getAABB())) note(a, b, &expected);
      measure(a, b, &expected_near, expected_near.least);
    }
  EXPECT_EQ(found, expected);
  Nearest near;
  ours_.distance(&others, &near, measure);
  EXPECT_EQ(near.least <= 0, expected_near.least <= 0);
  found.clear();
  ours_.collide(static_cast<fcl::BroadPhaseCollisionManager<double>*>(&ours_), &found, note);
  Pairs self;
  ours_.collide(&self, note);
  EXPECT_EQ(found, self);
}

TEST_F(FclManagerTest, OfTwoManagersOursComesFirstAsInFclsTree) {
  fcl::DynamicAABBTreeCollisionManager<double> tree;
  fcl::DynamicAABBTreeCollisionManager<double> others;
  Object* const here = make(20);
  Object* const there = make(20);
  ours_.registerObject(here);
  tree.registerObject(here);
  others.registerObject(there);
  tree.setup();
  others.setup();
  using Order = std::vector<std::pair<Object*, Object*>>;
  const auto order = [](Object* a, Object* b, void* data) {
    static_cast<Order*>(data)->emplace_back(a, b);
    return false;
  };
  const auto near = [](Object* a, Object* b, void* data, double& /*least*/) {
    static_cast<Order*>(data)->emplace_back(a, b);
    return false;
  };
  Order found;
  Order expected;
  ours_.collide(&others, &found, order);
  ours_.distance(&others, &found, near);
  tree.collide(&others, &expected, order);
  tree.distance(&others, &expected, near);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found, Order(2, std::pair(here, there)));
}

TEST_F(FclManagerTest, QueriesOfTwoThreadsChangeNothing) {
  for (int k = 0; k < 3; ++k) ours_.registerObject(make(30));
  ours_.setup();
  const void* const tree = &ours_.world().tree();
  const auto ask = [this](int& calls) {
    const auto count = [](Object*, Object*, void* data) { return ++*static_cast<int*>(data) < 0; };
    for (int k = 0; k < kQueries; ++k) ours_.collide(&calls, count);
  };
  int first = 0;
  int second = 0;
  std::thread other([&] { ask(first); });
  ask(second);
  other.join();
  EXPECT_EQ(first, 3 * kQueries);
  EXPECT_EQ(second, 3 * kQueries);
  EXPECT_EQ(&ours_.world().tree(), tree) << "the tree is not made anew";
  std::vector<std::uint8_t> state;
  EXPECT_EQ(ours_.world().save(state), WorldStatus::ok);
}

/// Neither the pairs nor the distances end for it.
TEST_F(FclManagerTest, ACallbackMayUnregisterObjects) {
  struct Seen {
    FclManager<double>* manager;
    std::set<Object*> gone;
    int calls = 0;
    bool forgets_all = false;

    void leave(Object* a, Object* b) {
      EXPECT_FALSE(gone.contains(a) || gone.contains(b));
      ++calls;
      if (forgets_all) return manager->clear();
      manager->unregisterObject(b);
      gone.insert(b);
    }
  };
  const auto collided = [](Object* a, Object* b, void* data) {
    static_cast<Seen*>(data)->leave(a, b);
    return false;
  };
  const auto measured = [](Object* a, Object* b, void* data, double& /*least*/) {
    static_cast<Seen*>(data)->leave(a, b);
    return false;
  };
  std::vector<Object*> all;
  for (const double size : {30.0, 0.01}) {  // all overlap, and none do
    all.clear();
    for (int k = 0; k < 8; ++k) all.push_back(make(size));
    for (const bool forgets_all : {false, true}) {
      for (const bool measures : {false, true}) {
        if (size < 1 && !measures) continue;
        ours_.clear();
        ours_.registerObjects(all);
        ours_.setup();
        Seen seen{&ours_, {}, 0, forgets_all};
        measures ? ours_.distance(&seen, measured) : ours_.collide(&seen, collided);
        EXPECT_EQ(seen.calls, forgets_all ? 1 : 7);
        EXPECT_EQ(ours_.size(), forgets_all ? 0U : 1U);
      }
    }
  }
}

TEST_F(FclManagerTest, ACallbackEndsTheSearchAndTwiceIsRefused) {
  Object* const a = make(30);
  for (Object* object : {a, make(30), make(30)}) ours_.registerObject(object);
  int calls = 0;
  const auto stop = [](Object*, Object*, void* data) { return ++*static_cast<int*>(data) == 2; };
  ours_.collide(&calls, stop);
  EXPECT_EQ(calls, 2);
  ours_.collide(a, &calls, stop);
  EXPECT_EQ(calls, 5);
  EXPECT_THROW(ours_.registerObject(a), std::invalid_argument);
  ours_.unregisterObject(a);
  ours_.unregisterObject(a);
  std::vector<Object*> left;
  ours_.getObjects(left);
  EXPECT_EQ(left.size(), 2U);
  EXPECT_FALSE(ours_.empty());
}

}  // namespace
}  // namespace kerf
