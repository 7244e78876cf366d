#include "viz/draw/view_box.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace kerf {
namespace {

constexpr Scalar kFarthestView = 1e19F;
constexpr Scalar kGrowth = 0.12F;       ///< more than is needed
constexpr Scalar kWorthIt = 0.8F;       ///< of the longest side: else a floor is shown whole
constexpr Scalar kAroundAction = 0.2F;  ///< of what never moves, in the size of what does

template <int D>
Scalar longest(const Box<D>& box) {
  const Vector<D> extent = box.extent();
  return *std::ranges::max_element(extent.value);
}

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
  std::optional<Box<D>> seen = box_of_interest(bodies, framing_);
  if (!seen && !box_) {  // nothing is near enough to be of interest: then all of it is
    seen = box_of_interest(bodies, Framing::everything);
    if (seen) framing_ = Framing::everything;
  }
  needed_ = seen;
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
  needed_.reset();
  fixed_ = true;
}

template <int D>
Box<D> ViewBox<D>::box() const {
  if (box_) return *box_;
  Box<D> unit;
  for (int i = 0; i < D; ++i) unit.max[i] = 1;
  return unit;
}

template <int D>
void SceneBox<D>::update(std::span<const Body<D>> bodies) {
  all_.update(bodies);
  if (D == 2 || framing_ == Framing::everything) return;
  std::vector<Body<D>> moving;
  std::ranges::copy_if(bodies, std::back_inserter(moving),
                       [](const Body<D>& body) { return body.mobility == Mobility::moving; });
  if (!box_of_interest<D>(moving, framing_)) return;
  action_.update(moving);
  has_action_ = true;
}

template <int D>
Box<D> SceneBox<D>::box() const {
  const Box<D> all = all_.box();
  if (!has_action_) return all;
  const Box<D> action = action_.box();
  const Scalar around = kAroundAction * longest(action);
  Box<D> box = all;
  for (int i = 0; i < D; ++i) {
    box.min[i] = std::max(box.min[i], action.min[i] - around);
    box.max[i] = std::min(box.max[i], action.max[i] + around);
  }
  return longest(box) < kWorthIt * longest(all) ? box : all;
}

template class SceneBox<2>;
template class SceneBox<3>;
template class ViewBox<2>;
template class ViewBox<3>;

}  // namespace kerf
