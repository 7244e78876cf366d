#include "core/related/reinserting_tree.h"

namespace kerf {

template <int D>
void ReinsertingTree<D>::arrange() {
  const auto changes = this->take_changes();
  if (changes.is_empty()) return;
  const auto leaves = this->take_in(changes);
  for (const Index leaf : leaves) this->cuts().divide_crowded(leaf);
  remove_empty(this->cuts().root());
}

template <int D>
void ReinsertingTree<D>::remove_empty(Index node) {
  CutTree<D>& tree = this->cuts();
  if (tree[node].is_leaf()) return;
  const Index below = tree[node].below;
  const Index above = tree[node].above;
  remove_empty(below);
  remove_empty(above);
  const auto is_empty = [&](Index child) { return tree[child].is_leaf() && tree[child].entries.empty(); };
  if (is_empty(below) && is_empty(above)) tree.collapse(node);
}

template class ReinsertingTree<2>;
template class ReinsertingTree<3>;

}  // namespace kerf
