#include "core/bsp/motions.h"

#include <algorithm>

#include "core/base/sample_place.h"
#include "core/base/tuning.h"
#include "core/objects/skin.h"

namespace kerf {
namespace {

/// Sums up the motions of objects.
class MotionSample {
 public:
  explicit MotionSample(const Config& config) : follows_fast_(config.restless) {}
  template <int D>
  void add(const PackedBox<D>& box, const PackedBox<D>& before) {
    const SizeAndSpeed motion = size_and_speed(box, before);
    if (follows_fast_ && motion.is_fast()) {
      ++sum_.fast;
    } else {
      sum_.speed += motion.relative_speed();
    }
    ++count_;
  }
  /// So many objects for each of those that were added.
  void add_standing(float each) { count_ *= 1 + each; }
  [[nodiscard]] Motions motions() const {
    return count_ == 0 ? Motions{} : Motions{sum_.speed / count_, sum_.fast / count_};
  }

 private:
  bool follows_fast_;
  Motions sum_;
  float count_ = 0;
};

}  // namespace

template <int D>
Motions sample_motions(const Requests<D>& requests, const ObjectTable<D>& tree, const Config& config,
                       std::uint32_t step, std::uint32_t count) {
  const ObjectTable<D>& latest = requests.latest();
  const std::span<const ObjectId> changed = requests.changed();
  const bool most_left = latest.bound() > tuning::kIdsPerCopy * latest.size();
  const std::size_t places = most_left ? changed.size() : tree.bound();
  MotionSample sample(config);
  const std::uint32_t first = count * step;
  for (std::uint32_t k = 0; k < std::min<std::size_t>(count, places); ++k) {
    const std::size_t place = sample_place(first + k, places);
    const ObjectId object = most_left ? changed[place] : ObjectId{static_cast<std::uint32_t>(place)};
    if (tree.is_placed(object) && latest.is_placed(object))
      sample.add(latest.packed(object), tree.packed(object));
  }
  if (most_left && !changed.empty() && latest.size() > changed.size())
    sample.add_standing(static_cast<float>(latest.size() - changed.size()) /
                        static_cast<float>(changed.size()));
  return sample.motions();
}

template <int D>
Leaving sample_leaving(const Requests<D>& requests, const Config& config) {
  const ObjectTable<D>& latest = requests.latest();
  const std::span<const ObjectId> changed = requests.changed();
  Leaving leaving;
  leaving.share = static_cast<float>(changed.size()) / static_cast<float>(latest.size() + 1);
  if (leaving.share <= tuning::kHotShare) return leaving;
  const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(tuning::kMotionSample, changed.size()));
  MotionSample sample(config);
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::size_t at = sample_place(k, changed.size());
    const ObjectId object = changed[at];
    if (latest.is_placed(object)) sample.add(latest.packed(object), requests.before()[at]);
  }
  leaving.motions = sample.motions();
  return leaving;
}

template <int D>
bool most_jump(const ObjectTable<D>& latest, const ObjectTable<D>& tree) {
  std::uint32_t jumped = 0;
  std::uint32_t count = 0;
  for (std::uint32_t k = 0; k < std::min(tuning::kJumpSample, tree.bound()); ++k) {
    const ObjectId object{static_cast<std::uint32_t>(sample_place(k, tree.bound()))};
    if (!tree.is_placed(object) || !latest.is_placed(object)) continue;
    const auto [size, speed] = size_and_speed(latest.packed(object), tree.packed(object));
    jumped += speed > tuning::kJumpSizes * size ? 1 : 0;
    ++count;
  }
  return 2 * jumped > count;
}

#define KERF_INSTANTIATE(D)                                                                    \
  template Motions sample_motions<D>(const Requests<D>&, const ObjectTable<D>&, const Config&, \
                                     std::uint32_t, std::uint32_t);                            \
  template Leaving sample_leaving<D>(const Requests<D>&, const Config&);                       \
  template bool most_jump<D>(const ObjectTable<D>&, const ObjectTable<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
