#include "core/bsp/common_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/base/tuning.h"
#include "core/bsp/sample_place.h"
#include "core/objects/skin.h"

namespace kerf {
namespace {

template <int D>
struct SampledMotion {
  Vector<D> by;
  float size = 0;
};

/// The middle one of the motions along each axis. The sample is not empty.
template <int D>
Vector<D> median(std::span<const SampledMotion<D>> sample) {
  std::vector<Scalar> along(sample.size());
  Vector<D> middle;
  for (int axis = 0; axis < D; ++axis) {
    std::ranges::transform(sample, along.begin(), [axis](const auto& motion) { return motion.by[axis]; });
    const auto at = along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2);
    std::ranges::nth_element(along, at);
    middle[axis] = *at;
  }
  return middle;
}

/// The farthest that a vector goes along an axis.
template <int D>
float reach_of(const Vector<D>& by) {
  float most = 0;
  for (const Scalar value : by.value) most = std::max(most, std::abs(value));
  return most;
}

}  // namespace

template <int D>
std::optional<Vector<D>> common_motion(const Requests<D>& requests, const ObjectTable<D>& tree, bool keeps) {
  if (requests.kind() != VolumeKind::box || !requests.exceed(tuning::kLeastShareAlike)) return std::nullopt;
  const std::span<const ObjectId> changed = requests.changed();
  const ObjectTable<D>& latest = requests.latest();
  std::vector<SampledMotion<D>> sample;
  const auto count = static_cast<std::uint32_t>(std::min(tuning::kMotionSample, changed.size()));
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::size_t at = sample_place(k, changed.size());
    const ObjectId object = changed[at];
    if (!latest.is_placed(object) || !tree.is_placed(object)) continue;
    const Box<D> before = keeps ? requests.before()[at].unpack() : tree.box(object);
    const Box<D> now = latest.box(object);
    sample.push_back({now.min - before.min, size_and_speed(now, before).size});
  }
  if (sample.empty()) return std::nullopt;
  const Vector<D> by = median<D>(sample);
  const float reach = reach_of(by);
  const auto alike = std::ranges::count_if(sample, [&](const SampledMotion<D>& motion) {
    return reach >= motion.size && reach_of(motion.by - by) <= tuning::kAlike * motion.size;
  });
  const bool are_alike = static_cast<float>(alike) >= tuning::kLeastShareAlike * static_cast<float>(count);
  return are_alike && std::isfinite(reach) ? std::optional(by) : std::nullopt;
}

template <int D>
void shift_planes(Tree<D>& tree, const Vector<D>& by) {
  for_each_node(tree, tree.root(), [&](NodeId id) {
    Plane<D>& plane = tree[id].plane;
    const Scalar offset = plane.offset + dot(plane.normal, by);
    if (!tree[id].is_leaf() && std::isfinite(offset)) plane.offset = offset;
  });
}

#define KERF_INSTANTIATE(D)                                                                            \
  template std::optional<Vector<D>> common_motion<D>(const Requests<D>&, const ObjectTable<D>&, bool); \
  template void shift_planes<D>(Tree<D>&, const Vector<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
