#include "core/related/self_organising_tree.h"

namespace kerf {

template <int D>
void SelfOrganisingTree<D>::arrange() {
  static_cast<void>(this->take_in(this->take_changes()));
  organise(this->cuts().root());
}

template <int D>
void SelfOrganisingTree<D>::organise(Index node) {
  CutTree<D>& tree = this->cuts();
  tree[node].tests *= kForget;
  tree[node].updates *= kForget;
  if (tree[node].is_leaf()) {
    const auto entries = static_cast<double>(tree[node].entries.size());
    const bool pays = tree[node].tests > kPriceOfCut * entries && tree[node].depth < CutTree<D>::kDeepest &&
                      tree[node].entries.size() > CutTree<D>::kCrowded / 2;
    if (!pays) return;
    const auto cut = tree.median_cut(node);
    if (cut.axis >= 0) tree.divide(node, cut);
    return;
  }
  const Index below = tree[node].below;
  const Index above = tree[node].above;
  organise(below);
  organise(above);
  if (!tree[below].is_leaf() || !tree[above].is_leaf()) return;
  const auto a = static_cast<double>(tree[below].entries.size());
  const auto b = static_cast<double>(tree[above].entries.size());
  const double saved = a * b;  // comparisons across the cut
  const double paid = kPriceOfUpdate * (tree[below].updates + tree[above].updates);
  if (saved <= paid && a + b <= static_cast<double>(CutTree<D>::kCrowded)) tree.collapse(node);
}

template class SelfOrganisingTree<2>;
template class SelfOrganisingTree<3>;

}  // namespace kerf
