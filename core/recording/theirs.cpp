#include "core/recording/theirs.h"

namespace kerf {

TheirStep& TheirStep::operator+=(const TheirStep& other) {
  pairs += other.pairs;
  missed += other.missed;
  extra += other.extra;
  twice += other.twice;
  ignored += other.ignored;
  undecided += other.undecided;
  return *this;
}

TheirStep sum_of(std::uint64_t pairs, std::span<const JudgedPair> judged) {
  TheirStep sum;
  sum.pairs = pairs;
  for (const JudgedPair& one : judged) {
    if (is_ignored(one.verdict)) ++sum.ignored;
    if (one.verdict == PairVerdict::missed) ++sum.missed;
    if (one.verdict == PairVerdict::extra) ++sum.extra;
    if (one.verdict == PairVerdict::twice) ++sum.twice;
    if (one.verdict == PairVerdict::undecided) ++sum.undecided;
  }
  return sum;
}

}  // namespace kerf
