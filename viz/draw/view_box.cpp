#include "viz/draw/view_box.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace kerf {
namespace {

constexpr Scalar kFarthestView = 1e19F;
constexpr Scalar kGrowth = 0.12F;  ///< more than is needed

template <int D>
Box<D> padded(Box<D> box) {
  const Vector<D> extent = box.extent();
  const Scalar largest = *std::ranges::max_element(extent.value);
  const Scalar least = std::max(largest * 0.05F, 1e-3F);
  for (int i = 0; i < D; ++i) {
    const Scalar missing = std::max(0.0F, least - extent[i]) / 2;
    box.min[i] -= missing;
    box.max[i] += missing;
  }
  return box;
}

}  // namespace

template <int D>
void ViewBox<D>::update(std::span<const Body<D>> bodies) {
  if (fixed_) return;
  const std::optional<Box<D>> seen = box_of_interest(bodies, framing_);
  if (!seen) return;
  if (!box_) box_ = padded(*seen);
  const Box<D> needed = join(*box_, *seen);
  const Vector<D> extent = needed.extent();
  for (int i = 0; i < D; ++i) {
    if (needed.min[i] < box_->min[i]) box_->min[i] = needed.min[i] - kGrowth * extent[i];
    if (needed.max[i] > box_->max[i]) box_->max[i] = needed.max[i] + kGrowth * extent[i];
  }
}

template <int D>
void ViewBox<D>::fix(const Box<D>& box) {
  bool good = is_valid(box);
  for (int i = 0; i < D; ++i) good &= box.min[i] >= -kFarthestView && box.max[i] <= kFarthestView;
  if (!good)
    throw std::invalid_argument("a view box needs finite bounds with min <= max on each axis, below 1e19");
  box_ = padded(box);
  fixed_ = true;
}

template <int D>
Box<D> ViewBox<D>::box() const {
  if (box_) return *box_;
  Box<D> unit;
  for (int i = 0; i < D; ++i) unit.max[i] = 1;
  return unit;
}

template class ViewBox<2>;
template class ViewBox<3>;

}  // namespace kerf
