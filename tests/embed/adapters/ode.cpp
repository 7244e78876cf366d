#include <ode/ode.h>

#include <cstdio>

#include "sims3d/ode/ode_geoms.h"

int main() {
  dInitODE();
  const dGeomID floor = dCreateBox(nullptr, 20, 2, 20);  // in no space
  const dGeomID ball = dCreateSphere(nullptr, 0.5);
  dGeomSetPosition(ball, 0, 4, 0);

  kerf::OdeGeoms geoms;  // in place of a space
  geoms.add(floor, kerf::ObjectKind::fixed);
  geoms.add(ball);

  int near = 0;
  for (double height = 4; height > 1; height -= 0.5) {
    dGeomSetPosition(ball, 0, height, 0);
    // in place of dSpaceCollide
    geoms.collide(&near, [](void* data, dGeomID, dGeomID) { ++*static_cast<int*>(data); });
  }
  std::printf("near in %d of 6 steps\n", near);
  dGeomDestroy(ball);
  dGeomDestroy(floor);
  dCloseODE();
}
