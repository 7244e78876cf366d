#include <cstdio>
#include <vector>

#include "core/bsp/bsp.h"

int main() {
  kerf::Bsp<2> tree(kerf::tuned_config());
  const kerf::Box<2> floor = {{0, 0}, {10, 1}};
  if (tree.insert({0}, floor, kerf::Mobility::fixed) != kerf::Status::ok) return 1;

  const std::vector<kerf::ObjectId> bodies = {{1}, {2}};
  std::vector<kerf::Box<2>> boxes = {{{1, 3}, {2, 4}}, {{5, 4}, {6, 5}}};
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (tree.insert(bodies[k], boxes[k], kerf::Mobility::moving) != kerf::Status::ok) return 1;

  for (int step = 1; step <= 6; ++step) {
    for (kerf::Box<2>& box : boxes) {  // everything falls by half a unit
      box.min[1] -= 0.5F;
      box.max[1] -= 0.5F;
    }
    if (tree.move_many(bodies, boxes) != kerf::Status::ok) return 1;
    tree.step();
    for (const kerf::Pair& pair : tree.pairs())
      std::printf("step %d: %u and %u overlap\n", step, pair.a.value, pair.b.value);
  }
}
