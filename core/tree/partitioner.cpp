#include "core/tree/partitioner.h"

#include <algorithm>
#include <cmath>

#include "core/base/tuning.h"
#include "core/kernels/sort_scalars.h"
#include "core/tree/criteria.h"

namespace kerf {
namespace {

/// The offset furthest from both neighbours in the gap [low, high): objects may then move a little without
/// crossing. Rounding may end on `high`, which belongs to the other side; then the low end serves
/// (HARD_CASES.md S5).
Scalar middle(Scalar low, Scalar high) {
  const Scalar mid = low * 0.5F + high * 0.5F;
  return mid >= low && mid < high ? mid : low;
}

/// The places where a partitioner may lie along its normal: between two neighbouring ends of objects nothing
/// changes, so each end stands for the gap above it.
class Gaps {
 public:
  explicit Gaps(std::span<const Interval> intervals)
      : count_(static_cast<std::uint32_t>(intervals.size())), los_(count_), his_(count_) {
    std::ranges::transform(intervals, los_.begin(), &Interval::lo);
    std::ranges::transform(intervals, his_.begin(), &Interval::hi);
    sort_scalars(los_);
    sort_scalars(his_);
  }

  /// Advances to the first gap for which the predicate holds; it must hold for all gaps above that one, too.
  template <class Predicate>
  void go_before(const Predicate& holds) {
    const auto is_before = [&](Scalar end) {
      return !holds({count_, ends_up_to(los_, end), count_ - ends_up_to(his_, end)});
    };
    begun_ = static_cast<std::uint32_t>(std::ranges::partition_point(los_, is_before) - los_.begin());
    ended_ = static_cast<std::uint32_t>(std::ranges::partition_point(his_, is_before) - his_.begin());
  }
  [[nodiscard]] bool at_end() const { return ended_ == count_; }
  /// Into the next gap. Pre: not at the end.
  void advance() {
    low_ = next_end();
    while (begun_ < count_ && los_[begun_] <= low_) ++begun_;
    while (ended_ < count_ && his_[ended_] <= low_) ++ended_;
  }
  /// Of a plane in this gap.
  [[nodiscard]] Quality quality() const { return {count_, begun_, count_ - ended_}; }
  /// None if a plane in this gap is not good.
  [[nodiscard]] std::optional<ReferencePoint> point(const Config& config) const {
    if (!is_good(quality(), config)) return std::nullopt;
    const Scalar offset = middle(low_, next_end());
    if (!std::isfinite(offset)) return std::nullopt;
    return ReferencePoint{offset, quality()};
  }

 private:
  static std::uint32_t ends_up_to(const std::vector<Scalar>& ends, Scalar end) {
    return static_cast<std::uint32_t>(std::ranges::upper_bound(ends, end) - ends.begin());
  }
  [[nodiscard]] Scalar next_end() const {
    return begun_ < count_ ? std::min(los_[begun_], his_[ended_]) : his_[ended_];
  }

  std::uint32_t count_;
  std::vector<Scalar> los_;
  std::vector<Scalar> his_;
  std::uint32_t begun_ = 0;
  std::uint32_t ended_ = 0;
  Scalar low_ = 0;
};

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
  if (intervals.empty()) return std::nullopt;
  Gaps gaps(intervals);
  const auto is_high = [](const Quality& q) { return q.left >= q.right; };
  gaps.go_before(is_high);
  gaps.advance();
  // No score exceeds its balance, and balance falls to both sides of the middle. So the score at the middle
  // excludes all but the gaps near it.
  const std::optional<ReferencePoint> fair = gaps.point(config);
  const float least = std::max(config.min_balance, fair ? score(fair->quality) : 0);
  const auto is_near = [least](const Quality& q) { return balance(q) >= least; };
  gaps.go_before([&](const Quality& q) { return is_high(q) || is_near(q); });

  std::optional<ReferencePoint> best;
  while (!gaps.at_end()) {
    gaps.advance();
    if (is_high(gaps.quality()) && !is_near(gaps.quality())) break;
    const std::optional<ReferencePoint> point = gaps.point(config);
    if (point && (!best || score(point->quality) > score(best->quality))) best = point;
  }
  return best;
}

std::optional<ReferencePoint> good_reference_point(std::span<const Interval> intervals,
                                                   const Config& config) {
  if (intervals.size() > tuning::kManySamples * config.sample) {
    std::vector<Interval> some;
    some.reserve(config.sample);
    for (std::size_t k = 0; k < config.sample; ++k)
      some.push_back(intervals[k * intervals.size() / config.sample]);
    if (const std::optional<ReferencePoint> point = best_reference_point(some, config)) {
      const Quality quality = measure(intervals, point->offset);
      if (is_good(quality, config)) return ReferencePoint{point->offset, quality};
    }
  }
  return best_reference_point(intervals, config);
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
  const Config here = config_at(tree, leaf, config);
  const std::vector<Entry>& entries = tree[leaf].entries;
  const std::vector<ObjectId> sampled = sampled_objects(tree, leaf, here);
  const bool exact = sampled.size() == entries.size();
  const std::uint32_t tries = directions_tried(tree, leaf, here);

  std::vector<Candidate> candidates;
  std::vector<Interval> scratch;
  for (std::uint32_t direction = 0; direction < tries; ++direction) {
    if (auto candidate = best_along<D>(tree, direction, sampled, here, scratch)) {
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
  candidates.resize(std::min(candidates.size(), tuning::kConfirmed));
  for (const Candidate& candidate : candidates) {
    auto confirmed = all.size() > tuning::kManySamples * sampled.size()
                         ? judge<D>(tree, candidate, all, here, scratch)
                         : best_along<D>(tree, candidate.direction, all, here, scratch);
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
