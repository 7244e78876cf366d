#include "core/broad_phase/brute_force.h"

namespace kerf {

template <int D>
Status BruteForce<D>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  return objects_.insert(object, box, mobility);
}

template <int D>
Status BruteForce<D>::move(ObjectId object, const Box<D>& box) {
  return objects_.move(object, box);
}

template <int D>
Status BruteForce<D>::remove(ObjectId object) {
  return objects_.remove(object);
}

template <int D>
void BruteForce<D>::step() {
  pairs_.clear();
  std::vector<ObjectId> placed;
  for (std::uint32_t id = 0; id < objects_.bound(); ++id)
    if (objects_.is_placed({id})) placed.push_back({id});
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Box<D> box = objects_.box(placed[i]);
    const bool fixed = objects_.is_fixed(placed[i]);
    for (std::size_t j = i + 1; j < placed.size(); ++j) {
      if (!overlaps(box, objects_.box(placed[j]))) continue;
      if (!(fixed && objects_.is_fixed(placed[j]))) pairs_.push_back({placed[i], placed[j]});
    }
  }
}

template class BruteForce<2>;
template class BruteForce<3>;

}  // namespace kerf
