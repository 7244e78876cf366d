#include "viz/draw/view_box.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "viz/draw/draw_context.h"

namespace kerf {
namespace {

constexpr Scalar kFarthest = 1e9F;  ///< larger coordinates belong to no scene that a picture could show
constexpr Scalar kReach =
    0.5F;  ///< around the fixed objects, in their sizes, where moving objects still matter
constexpr Scalar kReachUp = 2.0F;  ///< likewise upwards, from where they fall
constexpr Scalar kGrowth = 0.12F;  ///< more than needed
constexpr int kUp = 1;

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

template <int D>
bool is_near(const Body<D>& body) {
  bool all = is_drawable(body);
  for (int i = 0; i < D; ++i) all &= body.box.min[i] >= -kFarthest && body.box.max[i] <= kFarthest;
  return all;
}

/// Where moving objects count: around the fixed objects; everywhere if there are none.
template <int D>
Box<D> region_of_interest(const Box<D>& fixed) {
  Box<D> region = fixed;
  const Vector<D> extent = fixed.extent();
  const Scalar largest = std::max(0.0F, *std::ranges::max_element(extent.value));
  for (int i = 0; i < D; ++i) {
    region.min[i] -= kReach * largest;
    region.max[i] += (i == kUp ? kReachUp : kReach) * largest;
  }
  return region;
}

template <int D>
std::optional<Box<D>> box_of_interest(std::span<const Body<D>> bodies) {
  Box<D> fixed = Box<D>::empty();
  bool any_fixed = false;
  for (const Body<D>& body : bodies) {
    if (body.mobility != Mobility::fixed || !is_near(body)) continue;
    fixed = join(fixed, body.box);
    any_fixed = true;
  }
  Box<D> all = fixed;
  bool any = any_fixed;
  const Box<D> region = any_fixed ? region_of_interest(fixed) : Box<D>{};
  for (const Body<D>& body : bodies) {
    if (body.mobility == Mobility::fixed || !is_near(body)) continue;
    if (any_fixed && !overlaps(region, body.box)) continue;
    all = join(all, body.box);
    any = true;
  }
  return any ? std::optional(all) : std::nullopt;
}

}  // namespace

template <int D>
void ViewBox<D>::update(std::span<const Body<D>> bodies) {
  if (fixed_) return;
  const std::optional<Box<D>> seen = box_of_interest(bodies);
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
  for (int i = 0; i < D; ++i) good &= box.min[i] >= -kFarthest && box.max[i] <= kFarthest;
  if (!good)
    throw std::invalid_argument("a view box needs finite bounds with min <= max on each axis, below 1e9");
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
