#include "viz/debugger/model/debugger_model.h"

namespace kerf {

/// An import has the verdicts on all of its steps.
void DebuggerModel::take_verdicts() {
  alarms_.clear();
  wrong_steps_.clear();
  walk_ = {};
  for (const auto& [step, sum] : run_->their_steps()) {
    const Alarm alarm{step, sum.missed, sum.extra, sum.twice};
    if (alarm.is_wrong()) wrong_steps_.insert(wrong_steps_.end(), step);
    alarms_.emplace_hint(alarms_.end(), step, alarm);
  }
}

const Alarm& DebuggerModel::ask_oracle() {
  const std::uint32_t step = run_->position().step;
  const auto asked = alarms_.find(step);
  if (asked != alarms_.end()) return asked->second;
  const PairJudgement& judgement = run_->judgement();
  const Alarm alarm{step, judgement.missed.size(), judgement.extra.size(), judgement.twice.size()};
  if (alarm.is_wrong()) wrong_steps_.insert(step);
  return alarms_.emplace(step, alarm).first->second;
}

std::optional<std::size_t> DebuggerModel::wrong_pair() {
  return walk_.here(run_->wrong_pairs(), run_->position(), selection_);
}

void DebuggerModel::go_to_wrong_pair(std::size_t k) {
  const WrongPair wrong = run_->wrong_pairs()[k];
  walk_.arrive(k);
  go(Position::end_of(wrong.step));
  select(wrong.pair);
  say("error " + std::to_string(k + 1) + " of " + std::to_string(run_->wrong_pairs().size()) + ": " +
      to_text(wrong, run_->names()));
}

bool DebuggerModel::go_to_error(bool forwards) {
  const std::string way = forwards ? "further on" : "further back";
  if (run_->has_theirs()) {
    const auto& all = run_->wrong_pairs();
    const auto found = walk_.beside(all, run_->position(), selection_, forwards);
    if (found) go_to_wrong_pair(*found);
    if (!found) say(all.empty() ? "the other engine's pairs have no error" : "there is no error " + way);
    return found.has_value();
  }
  const auto found = find_kind(EventKind::alarm, forwards, {});
  if (!found) {
    say("none of the steps about which the oracle was asked has an error " + way);
    return false;
  }
  go(*found);
  say("error at " + to_string(*found, run_->names()));
  return true;
}

}  // namespace kerf
