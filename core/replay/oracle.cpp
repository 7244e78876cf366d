#include "core/replay/oracle.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include "core/broad_phase/all_pairs.h"
#include "core/broad_phase/brute_force.h"

namespace kerf {

template <int D>
std::vector<Pair> oracle_pairs(const ObjectTable<D>& objects) {
  std::unique_ptr<BroadPhase<D>> oracle;
  if (objects.kind() == VolumeKind::box) {
    oracle = std::make_unique<AllPairs<D>>();
  } else {
    oracle = std::make_unique<BruteForce<D>>(objects.kind());
  }
  for (std::uint32_t id = 0; id < objects.bound(); ++id) {
    if (!objects.is_placed({id})) continue;
    const Mobility mobility = objects.is_fixed({id}) ? Mobility::fixed : Mobility::moving;
    (void)oracle->insert(ObjectId{id}, objects.volume({id}), mobility);
  }
  oracle->step();
  std::vector<Pair> pairs;
  for (const Pair& pair : oracle->pairs()) pairs.push_back(make_pair(pair.a, pair.b));
  std::ranges::sort(pairs);
  return pairs;
}

PairJudgement judge_pairs(std::span<const Pair> reported, std::span<const Pair> truth) {
  std::vector<Pair> sorted;
  for (const Pair& pair : reported) sorted.push_back(make_pair(pair.a, pair.b));
  std::ranges::sort(sorted);
  PairJudgement judgement;
  for (std::size_t k = 1; k < sorted.size(); ++k)
    if (sorted[k] == sorted[k - 1]) judgement.twice.push_back(sorted[k]);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
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
  }
  return judgement;
}

template std::vector<Pair> oracle_pairs<2>(const ObjectTable<2>&);
template std::vector<Pair> oracle_pairs<3>(const ObjectTable<3>&);

}  // namespace kerf
