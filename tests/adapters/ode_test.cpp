#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "sims3d/ode/ode_geoms.h"

namespace kerf {
namespace {

using GeomPairs = std::multiset<std::pair<dGeomID, dGeomID>>;

void note(void* data, dGeomID a, dGeomID b) { static_cast<GeomPairs*>(data)->insert(std::minmax(a, b)); }

/// ODE with a space of its own, in which the geoms are as well.
class OdeGeomsTest : public testing::Test {
 protected:
  void SetUp() override {
    dInitODE2(0);
    dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
    world_ = dWorldCreate();
    space_ = dSimpleSpaceCreate(nullptr);
  }
  void TearDown() override {
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    dCloseODE();
  }
  void place(dGeomID geom) {
    dGeomSetPosition(geom, random_.uniform(0, 9), random_.uniform(0, 9), random_.uniform(0, 9));
  }
  dGeomID make() {
    const dGeomID geom = random_.below(2) == 0
                             ? dCreateSphere(space_, random_.uniform(0.3, 0.8))
                             : dCreateBox(space_, random_.uniform(0.5, 1.5), 1, random_.uniform(0.5, 1.5));
    if (random_.below(4) != 0) dGeomSetBody(geom, dBodyCreate(world_));
    place(geom);
    dGeomSetCategoryBits(geom, 1UL << random_.below(3));
    dGeomSetCollideBits(geom, 1UL << random_.below(3) | 1UL << random_.below(3));
    if (random_.below(10) == 0) dGeomDisable(geom);
    return geom;
  }

  Random random_{7};
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
};

TEST_F(OdeGeomsTest, CallsBackForThePairsOfASpaceWhileGeomsComeAndGo) {
  OdeGeoms geoms;
  std::vector<dGeomID> all = {dCreatePlane(space_, 0, 1, 0, 2)};
  geoms.add(all[0]);
  for (int i = 0; i < 80; ++i) {
    all.push_back(make());
    geoms.add(all.back());
  }
  // Two geoms of one body are no pair.
  const dGeomID pieces[] = {dCreateSphere(space_, 1), dCreateSphere(space_, 1)};
  const dBodyID body = dBodyCreate(world_);
  for (const dGeomID piece : pieces) {
    dGeomSetBody(piece, body);
    geoms.add(piece);
  }
  std::size_t most = 0;
  for (int step = 0; step < 200; ++step) {
    for (std::size_t k = 1; k < all.size(); k += 3) place(all[k]);
    const std::size_t gone = 1 + random_.below(static_cast<std::uint32_t>(all.size()) - 1);
    geoms.remove(all[gone]);
    dGeomDestroy(all[gone]);
    all[gone] = make();
    geoms.add(all[gone]);
    GeomPairs ours;
    GeomPairs theirs;
    geoms.collide(&ours, note);
    dSpaceCollide(space_, &theirs, note);
    ASSERT_EQ(ours, theirs) << "step " << step;
    most = std::max(most, ours.size());
  }
  EXPECT_GT(most, 40U);
  EXPECT_EQ(geoms.size(), 83U);
}

TEST_F(OdeGeomsTest, BoxesThatMeetOnlyInFloatsAreNoPair) {
  OdeGeoms geoms;
  const dGeomID left = dCreateBox(space_, 1, 1, 1);
  const dGeomID right = dCreateBox(space_, 1, 1, 1);
  geoms.add(left);
  geoms.add(right);
  for (const double x : {101.000001, 101.0}) {
    dGeomSetPosition(left, 100, 0, 0);
    dGeomSetPosition(right, x, 0, 0);
    GeomPairs ours;
    GeomPairs theirs;
    geoms.collide(&ours, note);
    dSpaceCollide(space_, &theirs, note);
    EXPECT_EQ(ours, theirs) << x;
    geoms.remove(right);
    ours.clear();
    geoms.collide_with(right, &ours, note);
    geoms.add(right);
    EXPECT_EQ(ours, theirs) << x;
  }
}

TEST_F(OdeGeomsTest, AGeomFromOutsideMeetsWhatItMeetsInASpace) {
  OdeGeoms geoms;
  for (int i = 0; i < 60; ++i) geoms.add(make());
  for (int i = 0; i < 20; ++i) {
    const dGeomID probe = dCreateRay(nullptr, 12);
    dGeomRaySet(probe, random_.uniform(0, 9), 10, random_.uniform(0, 9), 0.3, -1, 0.2);
    GeomPairs ours;
    GeomPairs theirs;
    geoms.collide_with(probe, &ours, note);
    dSpaceCollide2(probe, reinterpret_cast<dGeomID>(space_), &theirs, note);
    EXPECT_EQ(ours, theirs);
    EXPECT_FALSE(ours.empty());
    dGeomDestroy(probe);
  }
}

TEST_F(OdeGeomsTest, ADisabledGeomFromOutsideMeetsWhatItMeetsInASpace) {
  OdeGeoms geoms;
  for (int i = 0; i < 60; ++i) geoms.add(make());
  const dGeomID probe = dCreateSphere(nullptr, 6);
  dGeomSetPosition(probe, 4, 4, 4);
  dGeomDisable(probe);
  GeomPairs ours;
  GeomPairs theirs;
  geoms.collide_with(probe, &ours, note);
  dSpaceCollide2(probe, reinterpret_cast<dGeomID>(space_), &theirs, note);
  EXPECT_EQ(ours, theirs);
  EXPECT_FALSE(ours.empty());
  dGeomDestroy(probe);
}

TEST_F(OdeGeomsTest, OfASpaceFromOutsideEachGeomMeetsWhatItMeetsInASpace) {
  OdeGeoms geoms;
  for (int i = 0; i < 60; ++i) geoms.add(make());
  const dSpaceID probe = dSimpleSpaceCreate(nullptr);
  for (int i = 0; i < 20; ++i) place(dCreateSphere(probe, 1));
  GeomPairs ours;
  GeomPairs theirs;
  geoms.collide_with(reinterpret_cast<dGeomID>(probe), &ours, note);
  dSpaceCollide2(reinterpret_cast<dGeomID>(probe), reinterpret_cast<dGeomID>(space_), &theirs, note);
  EXPECT_EQ(ours, theirs);
  EXPECT_FALSE(ours.empty());
  dGeomDisable(dSpaceGetGeom(probe, 0));
  GeomPairs fewer;
  geoms.collide_with(reinterpret_cast<dGeomID>(probe), &fewer, note);
  EXPECT_LT(fewer.size(), ours.size());
  dSpaceDestroy(probe);
}

/// They were in pairs, and had contacts.
TEST_F(OdeGeomsTest, GeomsWithoutSizeMeetWhatTheyMeetInASpace) {
  OdeGeoms geoms;
  const std::vector<dGeomID> all = {
      dCreateBox(space_, 4, 4, 4),   dCreateSphere(space_, 0),      dCreateBox(space_, 0, 1, 1),
      dCreateBox(space_, 1, 0, 1),   dCreateBox(space_, 1, 1, 0),   dCreateCapsule(space_, 0, 1),
      dCreateCapsule(space_, 1, 0),  dCreateCylinder(space_, 0, 1), dCreateCylinder(space_, 1, 0),
      dCreateRay(space_, 0),         dCreateSphere(space_, 1),      dCreateCapsule(space_, 1, 1),
      dCreateCylinder(space_, 1, 1), dCreateBox(space_, 1, 1, 1)};
  const dGeomID probe = dCreateSphere(nullptr, 0);  // ODE does not ask whether this takes part
  const dSpaceID outside = dSimpleSpaceCreate(nullptr);
  dCreateSphere(outside, 0);
  dCreateSphere(outside, 1);
  for (const dGeomID geom : all) geoms.add(geom);
  const auto expect_alike = [&](std::size_t present) {
    GeomPairs ours;
    GeomPairs theirs;
    geoms.collide(&ours, note);
    dSpaceCollide(space_, &theirs, note);
    EXPECT_EQ(ours, theirs);
    EXPECT_EQ(ours.size(), present * (present - 1) / 2);
    ours.clear();
    theirs.clear();
    geoms.collide_with(probe, &ours, note);
    dSpaceCollide2(probe, reinterpret_cast<dGeomID>(space_), &theirs, note);
    EXPECT_EQ(ours, theirs);
    EXPECT_EQ(ours.size(), present);
    ours.clear();
    geoms.collide_with(reinterpret_cast<dGeomID>(outside), &ours, note);
    EXPECT_EQ(ours.size(), present) << "of one of the two";
  };
  expect_alike(7);
  dGeomSphereSetRadius(all[1], 1);
  dGeomBoxSetLengths(all.back(), 1, 0, 1);
  dGeomCylinderSetParams(all[7], 1, 1);
  expect_alike(8);
  dSpaceDestroy(outside);
  dGeomDestroy(probe);
}

TEST_F(OdeGeomsTest, TwoFixedGeomsAreNoPairAndBadOnesAreRefused) {
  OdeGeoms geoms;
  const dGeomID wall = dCreateBox(space_, 1, 1, 1);
  const dGeomID floor = dCreateBox(space_, 1, 1, 1);
  const dGeomID ball = dCreateSphere(space_, 1);
  geoms.add(wall, ObjectKind::fixed);
  geoms.add(floor, ObjectKind::fixed);
  geoms.add(ball);
  GeomPairs pairs;
  geoms.collide(&pairs, note);
  EXPECT_THAT(pairs, testing::UnorderedElementsAre(std::minmax(wall, ball), std::minmax(floor, ball)));
  EXPECT_THROW(geoms.add(ball), std::invalid_argument);
  geoms.remove(ball);
  geoms.remove(ball);
  EXPECT_FALSE(geoms.contains(ball));
  dGeomSetPosition(ball, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  EXPECT_THROW(geoms.add(ball), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
