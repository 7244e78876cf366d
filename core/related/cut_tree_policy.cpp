#include "core/related/cut_tree_policy.h"

#include <algorithm>

namespace kerf {

template <int D>
typename CutTreePolicy<D>::Changes CutTreePolicy<D>::take_changes() {
  Changes changes;
  known_.resize(this->table().bound(), 0);
  for (std::uint32_t k = 0; k < known_.size(); ++k) {
    const ObjectId object{k};
    const bool is_there = this->table().is_placed(object);
    if (!is_there && known_[k] != 0) changes.gone.push_back(object);
    if (is_there && known_[k] == 0) changes.come.push_back(object);
    if (is_there && known_[k] != 0 && !(this->table().box(object) == tree_.box(object)))
      changes.moved.push_back(object);
    known_[k] = is_there ? 1 : 0;
  }
  return changes;
}

template <int D>
void CutTreePolicy<D>::rebuild() {
  tree_.clear();
  std::vector<Index> leaves;
  for (const ObjectId object : this->placed())
    tree_.insert(tree_.root(), object, this->table().box(object), leaves);
  tree_.divide_crowded(tree_.root());
}

template <int D>
std::vector<typename CutTreePolicy<D>::Index> CutTreePolicy<D>::take_in(const Changes& changes) {
  std::vector<Index> leaves;
  for (const ObjectId object : changes.gone) tree_.remove(tree_.root(), object);
  for (const ObjectId object : changes.moved) tree_.remove(tree_.root(), object);
  for (const std::vector<ObjectId>* const objects : {&changes.moved, &changes.come})
    for (const ObjectId object : *objects)
      tree_.insert(tree_.root(), object, this->table().box(object), leaves);
  std::ranges::sort(leaves);
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  return leaves;
}

template <int D>
void CutTreePolicy<D>::find_pairs(PairList& pairs) {
  candidates_ = tree_.find_pairs(pairs, [&](ObjectId object) { return this->table().is_fixed(object); });
}

template class CutTreePolicy<2>;
template class CutTreePolicy<3>;

}  // namespace kerf
