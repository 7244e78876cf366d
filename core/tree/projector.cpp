#include "core/tree/projector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/float_mode.h"

namespace kerf {
namespace {

// Widenings, far above the rounding of doubles on float input and far below the precision of a float.
constexpr double kRelative = 0x1p-42;
// The overlap test of oriented boxes takes their axes for face normals. Axes within kAxisTolerance of
// orthonormal cause an error of that size; the slack is three times that.
constexpr double kSkew = 3 * kAxisTolerance;

struct Center {
  double position = 0;
  double magnitude = 0;  ///< sum of the absolute products: what the rounding error is relative to
};

template <int D>
Center project_center(const Vector<D>& normal, const Scalar* center) {
  Center result;
  for (int i = 0; i < D; ++i) {
    const double product = static_cast<double>(normal[i]) * static_cast<double>(center[i]);
    result.position += product;
    result.magnitude += std::abs(product);
  }
  return result;
}

Interval around(const Center& center, double reach) {
  const double wide = reach * (1 + kRelative) + center.magnitude * kRelative;
  return {round_down(center.position - wide), round_up(center.position + wide)};
}

template <int D>
double oriented_reach(const Vector<D>& normal, double length, const Scalar* axes, const Scalar* half) {
  double reach = 0;
  for (int k = 0; k < D; ++k) {
    const double along = project_center<D>(normal, axes + k * D).position;
    reach += (std::abs(along) + kSkew * length) * static_cast<double>(half[k]);
  }
  return reach;
}

/// A slab of a DOP: the axes' are the box's, the others follow in pairs.
template <int D>
Interval slab_ends(std::uint32_t slab, const Box<D>& box, const Scalar* extra) {
  if (slab < D) return {box.min[static_cast<int>(slab)], box.max[static_cast<int>(slab)]};
  const Scalar* ends = extra + std::size_t{2} * (slab - D);
  return {ends[0], ends[1]};
}

template <int D>
Interval project_slabs(const SlabSum<D>& sum, const Box<D>& box, const Scalar* extra) {
  Interval result;
  for (std::size_t k = 0; k < D; ++k) {
    const Interval ends = slab_ends(sum.slab[k], box, extra);
    result.lo = result.lo + sum.weight[k] * (sum.flip[k] ? -ends.hi : ends.lo);
    result.hi = result.hi + sum.weight[k] * (sum.flip[k] ? -ends.lo : ends.hi);
  }
  return result;
}

/// The most recent projectors. Repulsion takes some ten milliseconds, and for many directions seconds, in
/// which no other thread waits; comparisons of runs make many trees of one configuration.
template <int D>
class MadeProjectors {
 public:
  std::shared_ptr<const Projector<D>> get(std::uint32_t size, std::uint64_t seed, VolumeKind kind) {
    if (auto known = find(size, seed, kind)) return known;
    auto projector = std::make_shared<const Projector<D>>(DirectionSet<D>(size, seed), kind);
    const std::scoped_lock lock(mutex_);
    made_[next_++ % made_.size()] = {size, seed, projector};
    return projector;
  }

 private:
  std::shared_ptr<const Projector<D>> find(std::uint32_t size, std::uint64_t seed, VolumeKind kind) {
    const std::scoped_lock lock(mutex_);
    const auto known = std::ranges::find_if(made_, [&](const Made& made) {
      return made.size == size && made.seed == seed && made.projector->kind() == kind;
    });
    return known == made_.end() ? nullptr : known->projector;
  }

  struct Made {
    std::uint32_t size = 0;
    std::uint64_t seed = 0;
    std::shared_ptr<const Projector<D>> projector;
  };
  std::mutex mutex_;
  std::array<Made, 8> made_;
  std::size_t next_ = 0;
};

}  // namespace

template <int D>
Projector<D>::Projector(DirectionSet<D> directions, VolumeKind kind)
    : directions_(std::move(directions)), kind_(kind) {
  for (const Vector<D>& direction : directions_.all()) {
    double squares = 0;
    for (int i = 0; i < D; ++i)
      squares += static_cast<double>(direction[i]) * static_cast<double>(direction[i]);
    lengths_.push_back(std::sqrt(squares) * (1 + kRelative));
    if (slab_directions<D>(kind_).size() > D) sums_.push_back(sum_of_slabs(kind_, direction));
  }
}

template <int D>
Interval Projector<D>::project_extra(std::uint32_t direction, const Box<D>& box, const Scalar* extra) const {
  const Vector<D>& normal = directions_[direction];
  const double length = lengths_[direction];
  if (kind_ == VolumeKind::sphere)
    return around(project_center<D>(normal, extra), length * static_cast<double>(extra[D]));
  if (kind_ == VolumeKind::oriented_box)
    return around(project_center<D>(normal, extra),
                  oriented_reach<D>(normal, length, extra + D, extra + D + D * D));
  return project_slabs(sums_[direction], box, extra);
}

template <int D>
std::shared_ptr<const Projector<D>> make_projector(const Config& config, VolumeKind kind) {
  check(config);
  if (std::ranges::find(volume_kinds<D>(), kind) == volume_kinds<D>().end())
    throw std::invalid_argument("there is no volume '" + std::string(to_string(kind)) + "' in " +
                                std::to_string(D) + "D");
  const DefaultFloats floats;  // the result is kept, and shared
  const std::uint32_t size = D == 3 ? config.directions : std::max<std::uint32_t>(D, config.directions / 4);
  static MadeProjectors<D> made;
  return made.get(size, config.seed, kind);
}

template class Projector<2>;
template class Projector<3>;
template std::shared_ptr<const Projector<2>> make_projector<2>(const Config&, VolumeKind);
template std::shared_ptr<const Projector<3>> make_projector<3>(const Config&, VolumeKind);

}  // namespace kerf
