#include "core/broad_phase/brute_force.h"

namespace kerf {

template <int D>
void BruteForce<D>::step() {
  pairs_.clear();
  std::vector<ObjectId> placed;
  for_each_placed(objects_, [&](ObjectId object) { placed.push_back(object); });
  for (std::size_t i = 0; i < placed.size(); ++i)
    for (std::size_t j = i + 1; j < placed.size(); ++j)
      if (objects_.is_pair(placed[i], placed[j])) pairs_.push_back({placed[i], placed[j]});
}

template <int D>
void BruteForce<D>::describe(StructureParts<D>& parts) const {
  std::uint64_t placed = 0;
  for_each_placed(objects_, [&](ObjectId) { ++placed; });
  tell_each_with_each(placed, parts);
}

template class BruteForce<2>;
template class BruteForce<3>;

}  // namespace kerf
