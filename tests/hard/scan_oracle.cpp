#include "tests/hard/scan_oracle.h"

#include <algorithm>

namespace kerf::test {

/// The axis along which boxes are shortest against the range of their lower ends.
template <int D>
int ScanOracle<D>::best_axis(const std::vector<ObjectId>& placed) const {
  int best = 0;
  double least = 0;
  for (int axis = 0; axis < D; ++axis) {
    double low = 0;
    double high = 0;
    double extents = 0;
    for (const ObjectId object : placed) {
      const Box<D>& box = this->objects_.box(object);
      const auto at = static_cast<double>(box.min[axis]);
      low = object == placed.front() ? at : std::min(low, at);
      high = object == placed.front() ? at : std::max(high, at);
      extents += static_cast<double>(box.max[axis]) - at;
    }
    const double share = high > low ? extents / (high - low) : static_cast<double>(placed.size());
    if (axis == 0 || share < least) {
      best = axis;
      least = share;
    }
  }
  return best;
}

template <int D>
void ScanOracle<D>::step() {
  const ObjectTable<D>& objects = this->objects_;
  std::vector<Pair>& pairs = this->pairs_;
  std::vector<ObjectId> placed;
  for_each_placed(objects, [&](ObjectId object) { placed.push_back(object); });
  const int axis = best_axis(placed);
  std::sort(placed.begin(), placed.end(),
            [&](ObjectId a, ObjectId b) { return objects.box(a).min[axis] < objects.box(b).min[axis]; });
  pairs.clear();
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Scalar end = objects.box(placed[i]).max[axis];
    for (std::size_t j = i + 1; j < placed.size() && objects.box(placed[j]).min[axis] <= end; ++j)
      if (objects.is_pair(placed[i], placed[j])) pairs.push_back(make_pair(placed[i], placed[j]));
  }
  std::sort(pairs.begin(), pairs.end());
}

template class ScanOracle<2>;
template class ScanOracle<3>;

}  // namespace kerf::test
