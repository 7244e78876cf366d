#include "core/related/shifting_cuts.h"

#include <algorithm>
#include <utility>

namespace kerf {

template <int D>
void ShiftingCuts<D>::arrange() {
  const auto changes = this->take_changes();
  const bool is_due = rebuilt_every_ != 0 && age_ >= rebuilt_every_;
  const bool has_no_cut = this->cuts()[this->cuts().root()].is_leaf();
  ++age_;
  if (is_due || has_no_cut) {
    age_ = 1;
    return this->rebuild();
  }
  if (changes.is_empty()) return;
  this->cuts().remove_all();
  shift(this->cuts().root(), this->placed());
}

template <int D>
void ShiftingCuts<D>::shift(Index node, std::vector<ObjectId> objects) {
  CutTree<D>& tree = this->cuts();
  if (tree[node].is_leaf()) {
    std::vector<Index> leaves;
    for (const ObjectId object : objects) tree.insert(node, object, this->table().box(object), leaves);
    return;
  }
  const int axis = tree[node].axis;
  double sum = 0;
  for (const ObjectId object : objects) sum += double{this->table().box(object).center()[axis]};
  const Scalar mean =
      objects.empty() ? tree[node].cut : static_cast<Scalar>(sum / static_cast<double>(objects.size()));
  tree.move_cut(node, mean);
  const Scalar cut = tree[node].cut;
  std::vector<ObjectId> below;
  std::vector<ObjectId> above;
  for (const ObjectId object : objects) {
    if (this->table().box(object).min[axis] < cut) below.push_back(object);
    if (this->table().box(object).max[axis] >= cut) above.push_back(object);
  }
  objects = {};
  shift(tree[node].below, std::move(below));
  shift(tree[node].above, std::move(above));
}

template class ShiftingCuts<2>;
template class ShiftingCuts<3>;

}  // namespace kerf
