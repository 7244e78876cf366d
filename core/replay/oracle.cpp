#include "core/replay/oracle.h"

#include <algorithm>
#include <iterator>

#include "core/base/float_mode.h"
#include "core/base/poll.h"
#include "core/kernels/lanes.h"

namespace kerf {
namespace {

/// Some boxes are tested before the next ones, so that all pairs are not held twice. The pairs come sorted,
/// as the ids rise.
template <int D>
std::vector<Pair> pairs_of_boxes(const ObjectTable<D>& objects, const std::vector<ObjectId>& placed) {
  constexpr std::size_t kAtOnce = 64;
  Lanes<D> lanes;
  lanes.resize(placed.size());
  for (std::size_t k = 0; k < placed.size(); ++k)
    lanes.set(k, objects.box(placed[k]), placed[k], objects.is_fixed(placed[k]) ? 1 : 0);
  std::vector<Pair> pairs;
  PairList some;
  for (std::size_t first = 0; first < lanes.size; first += kAtOnce) {
    poll();
    some.clear();
    test_lanes(lanes, first, std::min(first + kAtOnce, lanes.size), some);
    pairs.insert(pairs.end(), some.pairs().begin(), some.pairs().end());
  }
  return pairs;
}

template <int D>
std::vector<Pair> pairs_of_volumes(const ObjectTable<D>& objects, const std::vector<ObjectId>& placed) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    poll();
    for (std::size_t j = i + 1; j < placed.size(); ++j)
      if (objects.is_pair(placed[i], placed[j])) pairs.push_back({placed[i], placed[j]});
  }
  return pairs;
}

}  // namespace

template <int D>
std::vector<Pair> oracle_pairs(const ObjectTable<D>& objects) {
  const DefaultFloats floats;
  std::vector<ObjectId> placed;
  for_each_placed(objects, [&](ObjectId object) { placed.push_back(object); });
  return objects.kind() == VolumeKind::box ? pairs_of_boxes(objects, placed)
                                           : pairs_of_volumes(objects, placed);
}

std::vector<Pair> sorted_pairs(std::span<const Pair> reported) {
  std::vector<Pair> pairs;
  pairs.reserve(reported.size());
  for (const Pair& pair : reported) pairs.push_back(make_pair(pair.a, pair.b));
  std::ranges::sort(pairs);
  return pairs;
}

std::vector<Pair> take_repeated(std::vector<Pair>& pairs) {
  std::vector<Pair> repeated;
  for (std::size_t k = 1; k < pairs.size(); ++k)
    if (pairs[k] == pairs[k - 1]) repeated.push_back(pairs[k]);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return repeated;
}

PairJudgement judge_pairs(std::span<const Pair> reported, std::span<const Pair> truth) {
  std::vector<Pair> sorted = sorted_pairs(reported);
  PairJudgement judgement;
  judgement.twice = take_repeated(sorted);
  std::ranges::set_difference(truth, sorted, std::back_inserter(judgement.missed));
  std::ranges::set_difference(sorted, truth, std::back_inserter(judgement.extra));
  return judgement;
}

PairJudgement by_verdict(std::span<const JudgedPair> judged) {
  PairJudgement judgement;
  for (const auto& [pair, verdict] : judged) {
    if (is_ignored(verdict)) judgement.ignored.push_back(pair);
    if (verdict == PairVerdict::missed) judgement.missed.push_back(pair);
    if (verdict == PairVerdict::extra) judgement.extra.push_back(pair);
    if (verdict == PairVerdict::twice) judgement.twice.push_back(pair);
    if (verdict == PairVerdict::undecided) judgement.undecided.push_back(pair);
  }
  return judgement;
}

template std::vector<Pair> oracle_pairs<2>(const ObjectTable<2>&);
template std::vector<Pair> oracle_pairs<3>(const ObjectTable<3>&);

}  // namespace kerf
