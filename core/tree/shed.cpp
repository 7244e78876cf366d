#include "core/tree/shed.h"

#include "core/base/short_stack.h"
#include "core/base/tuning.h"
#include "core/tree/criteria.h"
#include "core/tree/merge.h"

namespace kerf {
namespace {

template <int D>
bool exceeds(const Tree<D>& tree, float entries_an_object) {
  return static_cast<double>(tree.entries()) > static_cast<double>(entries_an_object) * tree.objects();
}

/// Merges the topmost nodes that have more than `share` of their objects on both sides.
template <int D>
void merge_straddled(Tree<D>& tree, float share, std::vector<OperatorActed>& events) {
  ShortStack<NodeId> todo(tree.root());
  while (!todo.empty()) {
    const NodeId id = todo.pop();
    if (tree[id].is_leaf()) continue;
    const Quality q = quality(tree, id);
    if (static_cast<float>(redundancy(q)) > share * static_cast<float>(q.population)) {
      events.push_back(merge(tree, id));
    } else {
      todo.push(tree[id].right);
      todo.push(tree[id].left);
    }
  }
}

}  // namespace

template <int D>
std::vector<OperatorActed> shed_entries(Tree<D>& tree, const Config& config) {
  std::vector<OperatorActed> events;
  if (!exceeds(tree, 2 * config.max_entries)) return events;
  for (float share = config.repair_redundancy; exceeds(tree, config.max_entries); share /= 2)
    merge_straddled(tree, share < tuning::kLeastStraddling ? 0 : share, events);
  return events;
}

template std::vector<OperatorActed> shed_entries<2>(Tree<2>&, const Config&);
template std::vector<OperatorActed> shed_entries<3>(Tree<3>&, const Config&);

}  // namespace kerf
