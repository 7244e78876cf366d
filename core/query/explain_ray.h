#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/replay/replayer.h"
#include "core/spatial/query.h"
#include "core/spatial/tree_walk.h"

namespace kerf {

/// A node that a ray looked at.
template <int D>
struct RayVisit {
  NodeVisit visit;
  std::uint32_t depth = 0;
  bool is_leaf = false;
  Plane<D> plane;  ///< inner: its partitioner
  Box<D> bounds;   ///< of the boxes stored below
};

/// How the tree finds the first object that a ray hits at the end of a step, and what the ray hits beyond it.
template <int D>
struct RayExplanation {
  std::uint32_t step = 0;
  Ray<D> ray;
  QueryStatus status = QueryStatus::ok;
  std::uint32_t objects = 0;        ///< that can be hit
  std::vector<Hit> hits;            ///< all, ordered by t
  std::vector<RayVisit<D>> visits;  ///< until the first is known, in this order
};

/// Throws std::runtime_error for a step that the recording does not have.
template <int D>
RayExplanation<D> explain_ray(Replayer<D>& replayer, std::uint32_t step, const Ray<D>& ray);

/// Why a ray does not reach a box: which axis it has left, or does not come to, before another.
template <int D>
std::string apart_text(const Ray<D>& ray, const Box<D>& box);

/// The explanation in sentences, a line each.
template <int D>
std::string to_text(const RayExplanation<D>& explanation, const GivenNames& names);

}  // namespace kerf
