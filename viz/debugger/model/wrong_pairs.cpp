#include "viz/debugger/model/wrong_pairs.h"

#include <algorithm>

namespace kerf {
namespace {

bool is_at(const WrongPair& wrong, const Position& position, const Selection& selection) {
  return wrong.step == position.step && Selection(wrong.pair) == selection;
}

}  // namespace

template <int D>
std::vector<WrongPair> find_wrong_pairs(const RecordingReader<D>& recording) {
  std::vector<WrongPair> all;
  for (const auto& [step, sum] : recording.their_steps()) {
    if (sum.missed + sum.extra + sum.twice == 0) continue;
    for (const auto& [pair, verdict] : recording.judged_pairs(step))
      if (is_fault(verdict)) all.push_back({step, pair, verdict});
  }
  std::ranges::sort(all);
  return all;
}

std::string to_text(const WrongPair& wrong, const GivenNames& names) {
  const std::string verdict(to_string(wrong.verdict));
  return "pair " + names.pair(wrong.pair) + " " + verdict + " at step " + names.step(wrong.step);
}

std::optional<std::size_t> WrongPairWalk::here(const std::vector<WrongPair>& all, const Position& position,
                                               const Selection& selection) const {
  if (at_ < all.size() && is_at(all[at_], position, selection)) return at_;
  const auto first = std::ranges::lower_bound(all, position.step, {}, &WrongPair::step);
  const auto last = std::ranges::upper_bound(all, position.step, {}, &WrongPair::step);
  const auto found =
      std::find_if(first, last, [&](const WrongPair& wrong) { return is_at(wrong, position, selection); });
  return found == last ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
}

std::optional<std::size_t> WrongPairWalk::beside(const std::vector<WrongPair>& all, const Position& position,
                                                 const Selection& selection, bool forwards) const {
  const auto end_of = [](const WrongPair& wrong) { return Position::end_of(wrong.step); };
  const auto now = here(all, position, selection);
  if (forwards) {
    const auto next = std::ranges::lower_bound(all, position, {}, end_of) - all.begin();
    const std::size_t k = now ? *now + 1 : static_cast<std::size_t>(next);
    return k < all.size() ? std::optional(k) : std::nullopt;
  }
  const auto later = std::ranges::upper_bound(all, position, {}, end_of) - all.begin();
  const std::size_t k = now ? *now : static_cast<std::size_t>(later);
  return k > 0 ? std::optional(k - 1) : std::nullopt;
}

template std::vector<WrongPair> find_wrong_pairs<2>(const RecordingReader<2>&);
template std::vector<WrongPair> find_wrong_pairs<3>(const RecordingReader<3>&);

}  // namespace kerf
