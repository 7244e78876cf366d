#include "frames/sequence/side_by_side.h"

#include <numeric>
#include <utility>

#include "frames/rivals/step_timer.h"

namespace kerf {

template <int D>
SideBySide<D>::SideBySide(std::vector<std::unique_ptr<BroadPhase<D>>> all)
    : all_(std::move(all)), times_(all_.size()) {}

template <int D>
Status SideBySide<D>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  requests_.add_insert(object, box, mobility);
  return table_.insert(object, box, mobility);
}

template <int D>
Status SideBySide<D>::move(ObjectId object, const Box<D>& box) {
  requests_.add_move(object, box);
  return table_.move(object, box);
}

template <int D>
Status SideBySide<D>::remove(ObjectId object) {
  requests_.add_remove(object);
  return table_.remove(object);
}

template <int D>
void SideBySide<D>::step() {
  for (std::size_t k = 0; k < all_.size(); ++k) {
    const StepTimer timer(true);
    apply(requests_, *all_[k]);
    all_[k]->step();
    const double time = timer.milliseconds();
    if (times_[k].size() < kSteps) {
      times_[k].push_back(time);
    } else {
      times_[k][steps_ % kSteps] = time;
    }
  }
  requests_.clear();
  ++steps_;
}

template <int D>
double SideBySide<D>::milliseconds(std::size_t k) const {
  const std::vector<double>& times = times_[k];
  return times.empty() ? 0 : std::accumulate(times.begin(), times.end(), 0.0) / double(times.size());
}

template class SideBySide<2>;
template class SideBySide<3>;

}  // namespace kerf
