#include "viz/draw/box_of_interest.h"

#include <algorithm>
#include <vector>

#include "viz/draw/draw_context.h"

namespace kerf {
namespace {

constexpr Scalar kFarthest = 1e9F;  ///< larger coordinates are no scene that a picture could show ...
constexpr Scalar kLastThing =
    1e18F;  ///< ... unless everything is asked for: beyond that nothing can be computed
constexpr Scalar kReach =
    0.5F;  ///< around what is fixed, in its sizes, where moving objects are still of interest
constexpr Scalar kReachUp = 2.0F;   ///< likewise upwards, from where they fall
constexpr Scalar kNearBulk = 1.0F;  ///< around the bulk, in its sizes: what is left of what reaches too far
constexpr Scalar kReachOfMoving =
    2.0F;  ///< likewise, how far what moves may reach: walls of a drum around a heap
constexpr Scalar kReachOfFixed =
    100.0F;                        ///< likewise, for what is fixed: a floor may be much larger than the crowd
constexpr std::size_t kBulk = 10;  ///< one in so many is not of it, at either end
constexpr std::size_t kMiddle = 4;
constexpr std::size_t kFewest = 4;  ///< of fewer bodies none is more usual than another
constexpr std::size_t kSample = 4096;
constexpr int kUp = 1;

template <int D>
Scalar longest_side(const Box<D>& box) {
  const Vector<D> extent = box.extent();
  return std::max(0.0F, *std::ranges::max_element(extent.value));
}

template <int D>
bool is_within(const Body<D>& body, Scalar farthest) {
  bool all = is_drawable(body);
  for (int i = 0; i < D; ++i) all &= body.box.min[i] >= -farthest && body.box.max[i] <= farthest;
  return all;
}

template <int D>
Box<D> widened(Box<D> box, Scalar by) {
  for (int i = 0; i < D; ++i) {
    box.min[i] -= by;
    box.max[i] += by;
  }
  return box;
}

template <int D>
Box<D> intersection(Box<D> a, const Box<D>& b) {
  for (int i = 0; i < D; ++i) {
    a.min[i] = std::max(a.min[i], b.min[i]);
    a.max[i] = std::min(a.max[i], b.max[i]);
  }
  return a;
}

/// At most kSample of them, spread over all.
template <int D>
std::vector<Box<D>> sample_boxes(std::span<const Body<D>> bodies) {
  const std::size_t stride = bodies.size() / kSample + 1;
  std::vector<Box<D>> boxes;
  for (std::size_t k = 0; k < bodies.size(); k += stride)
    if (is_within(bodies[k], kFarthest)) boxes.push_back(bodies[k].box);
  return boxes;
}

/// On each axis what remains without one in `share` of the smallest ends and of the largest.
template <int D>
Box<D> box_between(const std::vector<Box<D>>& boxes, std::size_t share) {
  const std::size_t left_out = std::max<std::size_t>(1, boxes.size() / share);
  std::vector<Scalar> ends(boxes.size());
  const auto ranked = [&ends](std::size_t rank) {
    const auto place = ends.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(ends.begin(), place, ends.end());
    return *place;
  };
  Box<D> between;
  for (int i = 0; i < D; ++i) {
    std::ranges::transform(boxes, ends.begin(), [i](const Box<D>& box) { return box.min[i]; });
    between.min[i] = ranked(left_out);
    std::ranges::transform(boxes, ends.begin(), [i](const Box<D>& box) { return box.max[i]; });
    between.max[i] = ranked(boxes.size() - 1 - left_out);
  }
  return between;
}

/// Where most bodies are.
template <int D>
struct Crowd {
  Box<D> bulk;
  Box<D> middle;  ///< half of them
  Scalar size = 0;

  /// What counts of a box: all of it, the part near the bulk if it reaches too far, or nothing.
  [[nodiscard]] std::optional<Box<D>> part_that_counts(const Box<D>& box, Scalar reach) const {
    if (contains(widened(bulk, reach * size), box)) return box;
    const Box<D> near = widened(bulk, kNearBulk * size);
    return overlaps(near, box) ? std::optional(intersection(near, box)) : std::nullopt;
  }
};

template <int D>
std::optional<Crowd<D>> find_crowd(std::span<const Body<D>> bodies) {
  const std::vector<Box<D>> boxes = sample_boxes(bodies);
  if (boxes.size() < kFewest) return std::nullopt;
  Crowd<D> crowd{box_between(boxes, kBulk), box_between(boxes, kMiddle)};
  crowd.size = longest_side(crowd.bulk);
  return crowd.size > 0 ? std::optional(crowd) : std::nullopt;
}

template <int D>
std::optional<Box<D>> box_of_fixed(std::span<const Body<D>> bodies, const std::optional<Crowd<D>>& crowd) {
  std::optional<Box<D>> fixed;
  for (const Body<D>& body : bodies) {
    if (body.mobility != Mobility::fixed || !is_within(body, kFarthest)) continue;
    const auto part = crowd ? crowd->part_that_counts(body.box, kReachOfFixed) : std::optional(body.box);
    if (part) fixed = fixed ? join(*fixed, *part) : *part;
  }
  return fixed;
}

/// Where moving objects count: around what is fixed.
template <int D>
Box<D> region_around(const Box<D>& fixed) {
  Box<D> region = fixed;
  const Scalar size = longest_side(fixed);
  for (int i = 0; i < D; ++i) {
    region.min[i] -= kReach * size;
    region.max[i] += (i == kUp ? kReachUp : kReach) * size;
  }
  return region;
}

template <int D>
std::optional<Box<D>> box_of_most(std::span<const Body<D>> bodies) {
  const auto crowd = find_crowd(bodies);
  std::optional<Box<D>> all = box_of_fixed(bodies, crowd);
  std::optional<Box<D>> region;
  if (all) region = region_around(*all);
  if (region && crowd && !contains(*region, crowd->middle)) region.reset();
  const auto part_of = [&](const Box<D>& box) -> std::optional<Box<D>> {
    if (region) return overlaps(*region, box) ? std::optional(box) : std::nullopt;
    return crowd ? crowd->part_that_counts(box, kReachOfMoving) : std::optional(box);
  };
  for (const Body<D>& body : bodies) {
    if (body.mobility == Mobility::fixed || !is_within(body, kFarthest)) continue;
    if (const auto part = part_of(body.box)) all = all ? join(*all, *part) : *part;
  }
  return all;
}

template <int D>
std::optional<Box<D>> box_of_everything(std::span<const Body<D>> bodies) {
  std::optional<Box<D>> all;
  for (const Body<D>& body : bodies)
    if (is_within(body, kLastThing)) all = all ? join(*all, body.box) : body.box;
  return all;
}

}  // namespace

template <int D>
std::optional<Box<D>> box_of_interest(std::span<const Body<D>> bodies, Framing framing) {
  return framing == Framing::everything ? box_of_everything(bodies) : box_of_most(bodies);
}

template <int D>
std::uint32_t count_outside(std::span<const Body<D>> bodies, const Box<D>& box) {
  const auto is_outside = [&](const Body<D>& body) { return is_drawable(body) && !overlaps(box, body.box); };
  return static_cast<std::uint32_t>(std::ranges::count_if(bodies, is_outside));
}

template std::optional<Box<2>> box_of_interest<2>(std::span<const Body<2>>, Framing);
template std::optional<Box<3>> box_of_interest<3>(std::span<const Body<3>>, Framing);
template std::uint32_t count_outside<2>(std::span<const Body<2>>, const Box<2>&);
template std::uint32_t count_outside<3>(std::span<const Body<3>>, const Box<3>&);

}  // namespace kerf
