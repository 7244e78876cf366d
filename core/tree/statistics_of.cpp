#include "core/tree/statistics_of.h"

#include <algorithm>

namespace kerf {

template <int D>
Statistics statistics_of(const Tree<D>& tree, const Scheduler<D>& scheduler) {
  Statistics s;
  s.objects = tree.objects();
  s.entries = tree.entries();
  s.redundancy = s.objects == 0 ? 0 : static_cast<double>(s.entries) / s.objects - 1;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (!tree[id].is_leaf()) return;
    ++s.leaves;
    s.height = std::max(s.height, tree[id].depth);
  });
  s.operators = scheduler.acted();
  s.refused = scheduler.refused();
  s.deferred = scheduler.pending();
  return s;
}

template Statistics statistics_of(const Tree<2>&, const Scheduler<2>&);
template Statistics statistics_of(const Tree<3>&, const Scheduler<3>&);

}  // namespace kerf
