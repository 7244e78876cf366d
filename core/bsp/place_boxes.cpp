#include "core/bsp/place_boxes.h"

#include <algorithm>
#include <limits>

#include "core/bsp/motions.h"
#include "core/bsp/stream.h"

namespace kerf {
namespace {

/// Lists the objects that come and go. Returns false if they are too many to be treated one by one.
template <int D>
bool list_traffic(const StepContext<D>& step, Traffic& traffic) {
  traffic.came.clear();
  traffic.gone.clear();
  if (step.requests.are_moves()) return true;
  const ObjectTable<D>& latest = step.requests.latest();
  const auto most = static_cast<std::size_t>(step.config.stream_share * static_cast<float>(latest.size()));
  for (const ObjectId object : step.requests.changed()) {
    const bool was_placed = step.tree.table.is_placed(object);
    const bool is_placed = latest.is_placed(object);
    if (was_placed == is_placed) continue;
    (is_placed ? traffic.came : traffic.gone).push_back(object);
    if (traffic.came.size() + traffic.gone.size() > most) return false;
  }
  std::ranges::sort(traffic.came);
  return true;
}

/// Finds the objects that must be placed anew. Those that are gone lie nowhere meanwhile, so that they leave
/// their leaves, too.
template <int D>
void find_leavers(const StepContext<D>& step, LeafBoxes<D>& boxes) {
  PackedBox<D> nowhere;
  nowhere.lane.fill(std::numeric_limits<Scalar>::quiet_NaN());
  ObjectTable<D>& table = step.tree.table;
  const auto& [came, gone] = step.memory.traffic;
  LeaverPass<D>& pass = step.memory.leaver_pass;
  for (const ObjectId object : gone) table.packed()[object.index()] = nowhere;
  pass.run(step.tree, step.pool(), boxes);
  for (const ObjectId object : gone) table.packed()[object.index()] = step.requests.latest().packed(object);
  if (!came.empty() || !gone.empty()) pass.amend(table, came, boxes.wanted());
}

}  // namespace

template <int D>
bool may_stay(const StepContext<D>& step) {
  return step.requests.kind() == VolumeKind::box && list_traffic(step, step.memory.traffic) &&
         (step.shift || !most_jump(step.requests.latest(), step.tree.table));
}

template <int D>
void place_boxes(const StepContext<D>& step, bool many_stay, LeafBoxes<D>& boxes) {
  StepMemory<D>& memory = step.memory;
  if (many_stay) {
    find_leavers(step, boxes);
    stream(step.tree, memory.leaver_pass, boxes, memory.stream_memory, step.pool());
  } else {
    stream(step.tree, boxes, memory.stream_memory, step.pool());
  }
}

#define KERF_INSTANTIATE(D)                         \
  template bool may_stay<D>(const StepContext<D>&); \
  template void place_boxes<D>(const StepContext<D>&, bool, LeafBoxes<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
