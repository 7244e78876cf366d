#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/config.h"
#include "core/geometry/direction_set.h"
#include "core/geometry/plane.h"
#include "core/geometry/slabs.h"
#include "core/geometry/volume.h"

namespace kerf {

/// Projects volumes of one kind on the directions of a set. Two volumes that overlap by `volumes_overlap`
/// have overlapping intervals for every direction, as exactness in free directions requires (DESIGN.md,
/// "Other volumes").
template <int D>
class Projector {
 public:
  Projector(DirectionSet<D> directions, VolumeKind kind);

  [[nodiscard]] const DirectionSet<D>& directions() const { return directions_; }
  [[nodiscard]] VolumeKind kind() const { return kind_; }

  /// `extra` points to the numbers that the kind stores beside the box.
  [[nodiscard]] Interval operator()(std::uint32_t direction, const Box<D>& box, const Scalar* extra) const {
    if (kind_ == VolumeKind::box) return project(direction, directions_[direction], box);
    return project_extra(direction, box, extra);
  }

 private:
  [[nodiscard]] Interval project_extra(std::uint32_t direction, const Box<D>& box, const Scalar* extra) const;

  DirectionSet<D> directions_;
  VolumeKind kind_;
  std::vector<double> lengths_;   ///< of the directions, rounded up
  std::vector<SlabSum<D>> sums_;  ///< of the directions, for DOPs
};

/// The projector of a configuration: its direction set has a quarter of the size in 2D. The last few
/// are kept and shared. Throws std::invalid_argument when the configuration cannot work, or D dimensions have
/// no such volumes.
template <int D>
std::shared_ptr<const Projector<D>> make_projector(const Config& config, VolumeKind kind);

}  // namespace kerf
