#include "core/bsp/common_motion.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/sample_place.h"
#include "core/base/tuning.h"
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
float longest_component(const Vector<D>& by) {
  float most = 0;
  for (const Scalar value : by.value) most = std::max(most, std::abs(value));
  return most;
}

/// The motions of the objects of a sample.
template <int D>
class ShiftSample {
 public:
  ShiftSample(const Requests<D>& requests, const ObjectTable<D>& tree, bool keeps)
      : requests_(requests), tree_(tree), keeps_(keeps) {}
  [[nodiscard]] std::uint32_t size() const {
    return static_cast<std::uint32_t>(
        std::min<std::size_t>(tuning::kMotionSample, requests_.changed().size()));
  }
  /// None for an object that comes or goes.
  [[nodiscard]] std::optional<SampledMotion<D>> operator[](std::uint32_t k) const {
    const std::size_t at = sample_place(k, requests_.changed().size());
    const ObjectId object = requests_.changed()[at];
    if (!requests_.latest().is_placed(object) || !tree_.is_placed(object)) return std::nullopt;
    const Box<D> before = keeps_ ? requests_.before()[at].unpack() : tree_.box(object);
    const Box<D> now = requests_.latest().box(object);
    return SampledMotion<D>{now.min - before.min, size_and_speed(now, before).size};
  }

 private:
  const Requests<D>& requests_;
  const ObjectTable<D>& tree_;
  bool keeps_;
};

/// Whether the way is so long that motions alike are no chance.
template <int D>
bool is_far(const SampledMotion<D>& motion, float reach) {
  return reach > tuning::kLeastWay * motion.size;
}

/// Whether an object moved by the vector, or nearly.
template <int D>
bool is_alike(const SampledMotion<D>& motion, const Vector<D>& by, float tolerance = 1) {
  const bool was_shifted = longest_component(by) >= tuning::kWayOfShift * motion.size;
  return longest_component(motion.by - by) <= tolerance * (was_shifted ? 1 : tuning::kAlike) * motion.size;
}

/// False after a few objects if most of them move slowly or each its own way, as in nearly every step.
template <int D>
bool may_be_common(const ShiftSample<D>& sample) {
  Vector<D> by;
  std::uint32_t votes = 0;
  std::uint32_t others = 0;
  for (std::uint32_t k = 0; k < sample.size(); ++k) {
    const auto motion = sample[k];
    if (!motion || !is_far(*motion, longest_component(motion->by))) {
      ++others;
    } else if (votes == 0) {
      by = motion->by;
      votes = 1;
    } else if (is_alike(*motion, by, 2)) {
      ++votes;
    } else {
      --votes;
      ++others;
    }
    if (others > 2 + k / 3) return false;
  }
  return true;
}

}  // namespace

template <int D>
std::optional<Vector<D>> common_motion(const Requests<D>& requests, const ObjectTable<D>& placed,
                                       bool keeps) {
  if (requests.kind() != VolumeKind::box || !requests.changed_exceed(tuning::kLeastShareAlike))
    return std::nullopt;
  const ShiftSample<D> sample(requests, placed, keeps);
  if (!may_be_common(sample)) return std::nullopt;
  std::vector<SampledMotion<D>> motions;
  for (std::uint32_t k = 0; k < sample.size(); ++k)
    if (const auto motion = sample[k]) motions.push_back(*motion);
  if (motions.empty()) return std::nullopt;
  const Vector<D> by = median<D>(motions);
  const float reach = longest_component(by);
  const auto alike = std::ranges::count_if(
      motions, [&](const SampledMotion<D>& motion) { return is_far(motion, reach) && is_alike(motion, by); });
  const bool are_alike =
      static_cast<float>(alike) >= tuning::kLeastShareAlike * static_cast<float>(sample.size());
  return are_alike && std::isfinite(reach) ? std::optional(by) : std::nullopt;
}

template <int D>
void shift_planes(Tree<D>& tree, const Vector<D>& by) {
  for_each_node(tree, tree.root(), [&](NodeId id) {
    Plane<D>& plane = tree[id].plane;
    const Scalar offset = shifted_offset(plane, by);
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
