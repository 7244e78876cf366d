#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/config.h"
#include "core/trace/event.h"
#include "core/tree/placement.h"
#include "core/tree/tree.h"

namespace kerf {

// The three quantities of paper section 3.2.

/// Number of objects tested against the partitioner.
constexpr std::uint32_t population(const Quality& q) { return q.population; }
/// Objects on the side with fewer over objects on the side with more; 1 if there are none.
float balance(const Quality& q);
/// Number of objects stored on both sides.
constexpr std::uint32_t redundancy(const Quality& q) { return q.left + q.right - q.population; }

/// The paper's goodness criteria: balanced enough, few enough straddlers, and both children smaller than the
/// node.
bool is_good(const Quality& q, const Config& config);
/// The value that a choice maximises: balance less the share of straddlers. At most 1.
float score(const Quality& q);

/// A place for a partitioner along a fixed direction.
struct ReferencePoint {
  Scalar offset = 0;
  Quality quality;
};

/// A candidate of a split with a good point.
struct Candidate {
  std::uint32_t direction = 0;
  Scalar offset = 0;
  Quality quality;  ///< over the sample, or over all objects if `exact`
  bool exact = false;
};

/// Counts one object of the population on its sides.
constexpr void count(Sides sides, Quality& q) {
  q.left += sides.left ? 1U : 0U;
  q.right += sides.right ? 1U : 0U;
}
/// Quality of the plane that divides the intervals at `offset`.
Quality measure(std::span<const Interval> intervals, Scalar offset);

/// The good reference point with the best score among the gaps of the projected objects (paper figure 4), the
/// lowest of equals, or none if no point is good. The intervals may come in any order. O(n log n).
std::optional<ReferencePoint> best_reference_point(std::span<const Interval> intervals, const Config& config);

/// The same point, or, of many objects, that of `config.sample` of them if it is good for all (paper section
/// 4.1: a subset is projected and sorted).
std::optional<ReferencePoint> good_reference_point(std::span<const Interval> intervals, const Config& config);

/// Candidate planes that a split of a leaf with `objects` objects tries: candidate_factor * sqrt(objects),
/// within the set's size.
std::uint32_t candidate_count(std::uint32_t objects, std::uint32_t directions, const Config& config);

/// The objects of a leaf on which candidates are judged first: all, or `config.sample` of them, spread over
/// its list.
template <int D>
std::vector<ObjectId> sampled_objects(const Tree<D>& tree, NodeId leaf, const Config& config);

/// How many directions of the set, from its beginning, a split of the leaf tries.
template <int D>
std::uint32_t directions_tried(const Tree<D>& tree, NodeId leaf, const Config& config);

/// The best partitioner for a leaf among the candidate directions, judged on a sample and confirmed on all
/// its objects (paper sections 3.2 and 4.1), or none.
template <int D>
std::optional<Candidate> choose_partitioner(const Tree<D>& tree, NodeId leaf, const Config& config);

}  // namespace kerf
