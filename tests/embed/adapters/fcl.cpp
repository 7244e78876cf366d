#include <fcl/fcl.h>

#include <cstdio>
#include <memory>

#include "sims3d/fcl/fcl_manager.h"

int main() {
  const auto shape = std::make_shared<fcl::Sphere<double>>(0.5);
  fcl::CollisionObject<double> still(shape);
  fcl::CollisionObject<double> moving(shape);

  kerf::FclManager<double> manager;  // in place of fcl::DynamicAABBTreeCollisionManager<double>
  manager.registerObject(&still);
  manager.registerObject(&moving);
  manager.setup();

  int near = 0;
  for (double x = 2; x >= 0; x -= 0.5) {
    moving.setTranslation({x, 0, 0});
    moving.computeAABB();
    manager.update();
    manager.collide(&near, [](auto*, auto*, void* data) { return ++*static_cast<int*>(data) < 0; });
  }
  std::printf("near in %d of 5 steps\n", near);
}
