#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/recording/look.h"

namespace kerf::test {

/// Gives every object of a tree a shape that fits into its box however it is turned, and turns most of them a
/// little in each step. All kinds of shapes take part; a shape changes with the size of its box, and bricks
/// breathe. For
/// Recorder::show.
template <int D>
class CrowdShapes {
 public:
  /// The tree must live as long.
  explicit CrowdShapes(const Bsp<D, EventLog>& tree) : tree_(tree) {}

  Appearance<D> appearance(ObjectId object);

 private:
  const Bsp<D, EventLog>& tree_;
  std::map<std::pair<std::uint32_t, int>, Shape<D>> shapes_;  ///< by kind and binary size
  std::map<ObjectId, Shape<D>> breathing_;
};

/// A body's axes, turned by that angle: in 3D about an axis that is not one of them.
template <int D>
std::array<Vector<D>, D> turned_axes(double angle);

/// Every kind of shape, none of which reaches farther from its origin than `radius`.
template <int D>
std::vector<Shape<D>> all_shapes(Scalar radius);

/// `play_crowd`, recorded with CrowdShapes.
template <int D>
void record_shaped_crowd(const std::filesystem::path& path, std::uint32_t steps);

}  // namespace kerf::test
