#include "core/broad_phase/sort_and_sweep.h"

#include <array>
#include <utility>
#include <vector>

#include "core/geometry/sort_key.h"

namespace kerf {

template <int D>
int SortAndSweep<D>::widest_axis() const {
  std::array<double, D> sum{};
  std::array<double, D> squares{};
  for (const ObjectId object : this->placed()) {
    const Vector<D> center = this->table().box(object).center();
    for (int i = 0; i < D; ++i) {
      sum[static_cast<std::size_t>(i)] += center[i];
      squares[static_cast<std::size_t>(i)] += static_cast<double>(center[i]) * center[i];
    }
  }
  const auto count = static_cast<double>(this->placed().size());
  std::size_t widest = 0;
  for (std::size_t i = 0; i < D; ++i) {
    squares[i] -= sum[i] * sum[i] / count;
    if (squares[i] > squares[widest]) widest = i;
  }
  return static_cast<int>(widest);
}

template <int D>
void SortAndSweep<D>::find_pairs(PairList& pairs) {
  order_.items.clear();
  if (this->placed().empty()) return;
  const int axis = axis_ = widest_axis();
  for (const ObjectId object : this->placed())
    order_.items.push_back({sort_key(this->table().box(object).min[axis]), object.value});
  order_.sort();
  lanes_.resize(order_.items.size());
  for (std::size_t k = 0; k < order_.items.size(); ++k) {
    const ObjectId object{order_.items[k].value};
    Box<D> box = this->table().box(object);
    std::swap(box.min[0], box.min[axis]);
    std::swap(box.max[0], box.max[axis]);
    lanes_.set(k, box, object, this->table().is_fixed(object) ? 1 : 0);
  }
  sweep_lanes(lanes_, pairs);
}

template <int D>
void SortAndSweep<D>::describe(StructureParts<D>& parts) const {
  parts.kind = "order along an axis";
  std::vector<ObjectId> sorted;
  AxisList list{axis_, {}};
  for (const RadixSort::Item& item : order_.items) {
    const ObjectId object{item.value};
    sorted.push_back(object);
    list.ends.push_back({this->table().box(object).min[axis_], object, false});
  }
  tell_sweep(
      sorted, axis_, [this](ObjectId object) { return this->table().box(object); }, parts);
  parts.end_tested();
  parts.lists.push_back(std::move(list));
  parts.bytes = bytes_of(order_.items) * 2 + bytes_of(lanes_.object) + bytes_of(lanes_.apart);
  for (std::size_t axis = 0; axis < D; ++axis)
    *parts.bytes += bytes_of(lanes_.min[axis]) + bytes_of(lanes_.max[axis]);
}

template class SortAndSweep<2>;
template class SortAndSweep<3>;

}  // namespace kerf
