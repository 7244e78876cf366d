#include "core/bsp/place_boxes.h"

#include "core/bsp/motions.h"
#include "core/bsp/stream.h"

namespace kerf {

template <int D>
bool may_stay(const StepContext<D>& step) {
  return step.requests.are_moves() && (step.shift || !most_jump(step.requests.latest(), step.tree.table));
}

template <int D>
void place_boxes(const StepContext<D>& step, bool many_stay, LeafBoxes<D>& boxes) {
  Workers<D>& workers = step.workers;
  if (many_stay) {
    workers.leave_pass.run(step.tree, step.pool(), boxes);
    stream(step.tree, workers.leave_pass, boxes, workers.stream_memory, step.pool());
  } else {
    stream(step.tree, boxes, workers.stream_memory, step.pool());
  }
}

#define KERF_INSTANTIATE(D)                         \
  template bool may_stay<D>(const StepContext<D>&); \
  template void place_boxes<D>(const StepContext<D>&, bool, LeafBoxes<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
