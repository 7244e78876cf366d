#include "core/tree/ballot.h"

#include <algorithm>

#include "core/tree/criteria.h"

namespace kerf {
namespace {

/// The best point of these intervals, good or not; none if no point divides them.
std::optional<ReferencePoint> best_point(std::span<const Interval> intervals, Config config) {
  config.min_balance = 0;
  config.max_redundancy = 1;
  return best_reference_point(intervals, config);
}

Ballot judge(const Quality& quality, const Config& config) {
  if (is_good(quality, config)) return Ballot::beaten;
  return balance(quality) < config.min_balance ? Ballot::unbalanced : Ballot::redundant;
}

BallotEntry candidate(std::uint32_t direction, std::span<const Interval> intervals, const Config& config) {
  if (const auto good = best_reference_point(intervals, config))
    return {direction, good->offset, good->quality, false, Ballot::beaten};
  if (const auto point = best_point(intervals, config))
    return {direction, point->offset, point->quality, false, judge(point->quality, config)};
  const auto count = static_cast<std::uint32_t>(intervals.size());
  return {direction, 0, {count, count, count}, false, Ballot::undividing};
}

template <int D>
std::vector<Interval> project(const Tree<D>& tree, std::uint32_t direction,
                              std::span<const ObjectId> objects) {
  std::vector<Interval> intervals;
  for (const ObjectId object : objects) intervals.push_back(tree.project(direction, object));
  return intervals;
}

/// Puts the operator's own choice into the ballot. Good candidates before it in the order were tried on all
/// objects and failed.
void mark_chosen(const std::optional<Candidate>& chosen, std::vector<BallotEntry>& entries) {
  for (BallotEntry& entry : entries) {
    if (entry.result != Ballot::beaten) continue;
    if (chosen && entry.direction == chosen->direction) {
      entry = {chosen->direction, chosen->offset, chosen->quality, true, Ballot::chosen};
      return;
    }
    entry.result = Ballot::unconfirmed;
  }
}

template <int D>
std::vector<BallotEntry> ballot_of_split(const Tree<D>& tree, NodeId leaf, const Config& config) {
  const std::vector<ObjectId> objects = sampled_objects(tree, leaf, config);
  const bool exact = objects.size() == tree[leaf].entries.size();
  std::vector<BallotEntry> entries;
  for (std::uint32_t direction = 0; direction < directions_tried(tree, leaf, config); ++direction) {
    entries.push_back(candidate(direction, project(tree, direction, objects), config));
    entries.back().exact = exact;
  }
  std::ranges::stable_sort(entries, [](const BallotEntry& a, const BallotEntry& b) {
    const bool a_is_good = a.result == Ballot::beaten;
    const bool b_is_good = b.result == Ballot::beaten;
    if (a_is_good != b_is_good) return a_is_good;
    return score(a.quality) > score(b.quality);
  });
  mark_chosen(choose_partitioner(tree, leaf, config), entries);
  std::stable_partition(entries.begin(), entries.end(),
                        [](const BallotEntry& entry) { return entry.result == Ballot::chosen; });
  return entries;
}

/// The one direction along which a partitioner may be shifted.
template <int D>
std::vector<BallotEntry> ballot_of_shift(const Tree<D>& tree, NodeId node, const Config& config) {
  std::vector<ObjectId> objects;
  for (const Stored& stored : collect(tree, node)) objects.push_back(stored.object);
  BallotEntry entry = candidate(tree[node].direction, project(tree, tree[node].direction, objects), config);
  entry.exact = true;
  if (entry.result == Ballot::beaten) entry.result = Ballot::chosen;
  return {entry};
}

}  // namespace

std::string_view to_string(Ballot ballot) {
  switch (ballot) {
    case Ballot::chosen:
      return "chosen";
    case Ballot::beaten:
      return "good, but another scores better";
    case Ballot::unbalanced:
      return "refused: unbalanced";
    case Ballot::redundant:
      return "refused: cuts too many";
    case Ballot::undividing:
      return "refused: no point divides the objects";
    case Ballot::unconfirmed:
      return "refused: good for the sample, not for all objects";
    case Ballot::overruled:
      return "chosen without the decision";
  }
  return "";
}

std::string result_text(const BallotEntry& entry) {
  return (entry.taken ? "taken by a decision; by itself " : "") + std::string(to_string(entry.result));
}

template <int D>
std::vector<BallotEntry> ballot(const Tree<D>& tree, Operator op, NodeId node, const Config& config) {
  const Config here = config_at(tree, node, config);
  if (op == Operator::split) return ballot_of_split(tree, node, here);
  if (op == Operator::shift_split || op == Operator::balance) return ballot_of_shift(tree, node, here);
  return {};
}

template std::vector<BallotEntry> ballot<2>(const Tree<2>&, Operator, NodeId, const Config&);
template std::vector<BallotEntry> ballot<3>(const Tree<3>&, Operator, NodeId, const Config&);

}  // namespace kerf
