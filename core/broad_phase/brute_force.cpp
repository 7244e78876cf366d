#include "core/broad_phase/brute_force.h"

namespace kerf {

template <int D>
void BruteForce<D>::step() {
  pairs_.clear();
  std::vector<ObjectId> placed;
  for (std::uint32_t id = 0; id < objects_.bound(); ++id)
    if (objects_.is_placed({id})) placed.push_back({id});
  for (std::size_t i = 0; i < placed.size(); ++i)
    for (std::size_t j = i + 1; j < placed.size(); ++j)
      if (objects_.is_pair(placed[i], placed[j])) pairs_.push_back({placed[i], placed[j]});
}

template <int D>
void BruteForce<D>::describe(StructureParts<D>& parts) const {
  std::uint64_t placed = 0;
  for (std::uint32_t id = 0; id < objects_.bound(); ++id) placed += objects_.is_placed({id}) ? 1U : 0U;
  tell_each_with_each(placed, parts);
}

template class BruteForce<2>;
template class BruteForce<3>;

}  // namespace kerf
