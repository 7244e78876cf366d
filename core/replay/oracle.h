#pragma once

#include <span>
#include <vector>

#include "core/objects/object_table.h"
#include "core/recording/theirs.h"

namespace kerf {

/// The pairs of a table by the definition, sorted: each object against each.
template <int D>
std::vector<Pair> oracle_pairs(const ObjectTable<D>& objects);

/// The pairs in ascending order, and so the objects of each.
std::vector<Pair> sorted_pairs(std::span<const Pair> reported);
/// Takes out of sorted pairs what is there again, and returns it.
std::vector<Pair> take_repeated(std::vector<Pair>& pairs);

/// Reported pairs compared with the true ones; each list is sorted.
struct PairJudgement {
  std::vector<Pair> missed;     ///< true, but not reported
  std::vector<Pair> extra;      ///< reported, but not true
  std::vector<Pair> twice;      ///< reported again, once for each time
  std::vector<Pair> ignored;    ///< of another engine: no fault, by what it does by design
  std::vector<Pair> undecided;  ///< of another engine: they touch only in the digits that were written
  [[nodiscard]] bool is_exact() const { return missed.empty() && extra.empty() && twice.empty(); }
};

/// `truth` is sorted; the reported pairs come in any order, each pair's objects too.
PairJudgement judge_pairs(std::span<const Pair> reported, std::span<const Pair> truth);

/// The judgement of another engine's pairs in lists.
PairJudgement by_verdict(std::span<const JudgedPair> judged);

}  // namespace kerf
