#include "core/broad_phase/all_pairs.h"

namespace kerf {

template <int D>
void AllPairs<D>::find_pairs(PairList& pairs) {
  lanes_.resize(this->placed().size());
  std::size_t place = 0;
  for (const ObjectId object : this->placed())
    lanes_.set(place++, this->table().box(object), object, this->table().is_fixed(object) ? 1 : 0);
  test_lanes(lanes_, 0, lanes_.size, pairs);
}

template class AllPairs<2>;
template class AllPairs<3>;

}  // namespace kerf
