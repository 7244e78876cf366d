#include "core/tree/partitioner.h"

#include <algorithm>
#include <cmath>

#include "core/kernels/sort_scalars.h"

namespace kerf {
namespace {

/// A sampled candidate is confirmed on all objects; that many of the best get the chance.
constexpr std::size_t kConfirmed = 4;
/// In leaves of so many samples the sample's offset is taken; else the best offset of all objects is found.
constexpr std::size_t kManySamples = 32;

/// The offset furthest from both neighbours in the gap [low, high): objects may then move a little without
/// crossing. Rounding may end on `high`, which belongs to the other side; then the low end serves
/// (HARD_CASES.md S5).
Scalar middle(Scalar low, Scalar high) {
  const Scalar mid = low * 0.5F + high * 0.5F;
  return mid >= low && mid < high ? mid : low;
}

/// Every k-th entry, at most `sample` of them: the leaf's list is ordered, so the sample is spread like the
/// objects.
std::vector<ObjectId> sample_objects(const std::vector<Entry>& entries, std::size_t sample) {
  const std::size_t take = std::min(entries.size(), sample);
  std::vector<ObjectId> objects;
  objects.reserve(take);
  for (std::size_t k = 0; k < take; ++k) objects.push_back(entries[k * entries.size() / take].object);
  return objects;
}

template <int D>
std::optional<Candidate> best_along(const Tree<D>& tree, std::uint32_t direction,
                                    std::span<const ObjectId> objects, const Config& config,
                                    std::vector<Interval>& scratch) {
  scratch.clear();
  for (const ObjectId object : objects) scratch.push_back(tree.project(direction, object));
  const std::optional<ReferencePoint> point = best_reference_point(scratch, config);
  if (!point) return std::nullopt;
  return Candidate{direction, point->offset, point->quality, false};
}

/// The candidate's partitioner judged on all objects, or none if it is not good for them.
template <int D>
std::optional<Candidate> judge(const Tree<D>& tree, const Candidate& candidate,
                               std::span<const ObjectId> objects, const Config& config,
                               std::vector<Interval>& scratch) {
  scratch.clear();
  for (const ObjectId object : objects) scratch.push_back(tree.project(candidate.direction, object));
  const Quality quality = measure(scratch, candidate.offset);
  if (!is_good(quality, config)) return std::nullopt;
  return Candidate{candidate.direction, candidate.offset, quality, true};
}

}  // namespace

float balance(const Quality& q) {
  const std::uint32_t more = std::max(q.left, q.right);
  return more == 0 ? 1.0F : static_cast<float>(std::min(q.left, q.right)) / static_cast<float>(more);
}

bool is_good(const Quality& q, const Config& config) {
  const bool both_shrink = q.left < q.population && q.right < q.population;
  return both_shrink && balance(q) >= config.min_balance &&
         static_cast<float>(redundancy(q)) <= config.max_redundancy * static_cast<float>(q.population);
}

float score(const Quality& q) {
  if (q.population == 0) return 0;
  return balance(q) - static_cast<float>(redundancy(q)) / static_cast<float>(q.population);
}

Quality measure(std::span<const Interval> intervals, Scalar offset) {
  Quality q{static_cast<std::uint32_t>(intervals.size()), 0, 0};
  for (const Interval& interval : intervals) count(classify(interval, offset), q);
  return q;
}

std::optional<ReferencePoint> best_reference_point(std::span<const Interval> intervals,
                                                   const Config& config) {
  std::vector<Scalar> los;
  std::vector<Scalar> his;
  for (const Interval& interval : intervals) {
    los.push_back(interval.lo);
    his.push_back(interval.hi);
  }
  sort_scalars(los);
  sort_scalars(his);

  // Between two neighbouring ends of objects nothing changes, so each end stands for the gap above it.
  std::optional<ReferencePoint> best;
  const auto count = static_cast<std::uint32_t>(intervals.size());
  std::uint32_t begun = 0;
  std::uint32_t ended = 0;
  while (ended < count) {
    const Scalar low = begun < count ? std::min(los[begun], his[ended]) : his[ended];
    while (begun < count && los[begun] <= low) ++begun;
    while (ended < count && his[ended] <= low) ++ended;
    const Quality quality{count, begun, count - ended};
    if (!is_good(quality, config) || (best && score(quality) <= score(best->quality))) continue;
    const Scalar high = begun < count ? std::min(los[begun], his[ended]) : his[ended];
    const Scalar offset = middle(low, high);
    if (std::isfinite(offset)) best = ReferencePoint{offset, quality};
  }
  return best;
}

std::uint32_t candidate_count(std::uint32_t objects, std::uint32_t directions, const Config& config) {
  const float wanted = std::ceil(config.candidate_factor * std::sqrt(static_cast<float>(objects)));
  return std::clamp(static_cast<std::uint32_t>(wanted), 1U, directions);
}

template <int D>
std::vector<ObjectId> sampled_objects(const Tree<D>& tree, NodeId leaf, const Config& config) {
  return sample_objects(tree[leaf].entries, config.sample);
}

template <int D>
std::uint32_t directions_tried(const Tree<D>& tree, NodeId leaf, const Config& config) {
  const auto objects = static_cast<std::uint32_t>(tree[leaf].entries.size());
  const std::uint32_t allowed = config.free_directions ? tree.directions().size() : D;
  return std::max<std::uint32_t>(D, candidate_count(objects, allowed, config));
}

template <int D>
std::optional<Candidate> choose_partitioner(const Tree<D>& tree, NodeId leaf, const Config& config) {
  const std::vector<Entry>& entries = tree[leaf].entries;
  const std::vector<ObjectId> sampled = sampled_objects(tree, leaf, config);
  const bool exact = sampled.size() == entries.size();
  const std::uint32_t tries = directions_tried(tree, leaf, config);

  std::vector<Candidate> candidates;
  std::vector<Interval> scratch;
  for (std::uint32_t direction = 0; direction < tries; ++direction) {
    if (auto candidate = best_along<D>(tree, direction, sampled, config, scratch)) {
      candidate->exact = exact;
      candidates.push_back(*candidate);
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return score(a.quality) > score(b.quality);
  });
  if (candidates.empty()) return std::nullopt;
  if (exact) return candidates.front();

  const std::vector<ObjectId> all = sample_objects(entries, entries.size());
  candidates.resize(std::min(candidates.size(), kConfirmed));
  for (const Candidate& candidate : candidates) {
    auto confirmed = all.size() > kManySamples * sampled.size()
                         ? judge<D>(tree, candidate, all, config, scratch)
                         : best_along<D>(tree, candidate.direction, all, config, scratch);
    if (confirmed) {
      confirmed->exact = true;
      return confirmed;
    }
  }
  return std::nullopt;
}

#define KERF_INSTANTIATE(D)                                                                 \
  template std::vector<ObjectId> sampled_objects<D>(const Tree<D>&, NodeId, const Config&); \
  template std::uint32_t directions_tried<D>(const Tree<D>&, NodeId, const Config&);        \
  template std::optional<Candidate> choose_partitioner<D>(const Tree<D>&, NodeId, const Config&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
