#include "core/bsp/mode_chooser.h"

#include <algorithm>

namespace kerf {

void ModeChooser::decide(const Evidence& evidence) {
  count(evidence);
  const auto* const due = std::ranges::find_if(kTransitions, [&](const Transition& transition) {
    return transition.from == mode_ && holds(transition.condition, evidence);
  });
  const bool knows_motions =
      mode_ == Mode::swept && evidence.bytes && evidence.skins && !evidence.shift && !evidence.rows;
  taken_ = due == kTransitions.end() ? nullptr : due;
  if (taken_ != nullptr) enter(taken_->to);
  if (knows_motions) patience_ = std::max(patience_, tuning::kFirstPatience);
}

bool ModeChooser::holds(Condition condition, const Evidence& evidence) const {
  switch (condition) {
    case Condition::bytes_on:
      return evidence.bytes;
    case Condition::bytes_off:
      return !evidence.bytes;
    case Condition::skins_off:
      return !evidence.skins;
    case Condition::keeping_is_costly:
      return regrets_;
    case Condition::many_leave:
      return against_ >= tuning::kHotSteps;
    case Condition::uproar:
      return steps_ >= tuning::kLearningSteps && evidence.leaving.share > tuning::kHopelessShare &&
             !are_mild(evidence.leaving.motions);
    case Condition::rows_pay:
      return rows_ >= tuning::kRowSteps;
    case Condition::slow_at_first:
      return evidence.skins && !evidence.shift && !evidence.rows && patience_ == 0 &&
             are_mild(evidence.motions);
    case Condition::slow_for_long:
      return evidence.skins && !evidence.rows &&
             against_ >= (crowded_ ? tuning::kLongestPatience : std::max(patience_, tuning::kFirstPatience));
  }
  return false;
}

/// Without skins nothing is remembered: the first motions that are known later decide at once.
void ModeChooser::count(const Evidence& evidence) {
  rows_ = evidence.rows ? std::min(rows_ + 1, tuning::kRowSteps) : 0;
  if (mode_ == Mode::ordered || !evidence.bytes || !evidence.skins) {
    forget();
  } else if (mode_ == Mode::swept) {
    if (!evidence.shift && !evidence.rows) count_motions(evidence.motions);
  } else if (!regrets_) {
    count_leaving(evidence.leaving);
  }
}

void ModeChooser::forget() {
  regrets_ = crowded_ = false;
  steps_ = against_ = patience_ = 0;
}

/// A few steps must count for sweeping, and in the beginning for more, while skins learn how thick they must
/// be.
void ModeChooser::count_leaving(const Leaving& leaving) {
  ++steps_;
  const float cost = leaving.share * (1 - (1 - tuning::kFastCost) * leaving.motions.fast);
  const bool is_hot = cost > (steps_ < tuning::kLearningSteps ? tuning::kHopelessShare : tuning::kHotShare);
  against_ = is_hot ? against_ + 1 : 0;
}

void ModeChooser::count_motions(const Motions& motions) {
  ++steps_;
  if (motions.fast < tuning::kFewFast) crowded_ = false;
  const bool few_are_fast = motions.fast < tuning::many_fast(dimension_);
  against_ = few_are_fast && motions.speed < tuning::kCoolSpeed ? against_ + 1 : 0;
}

/// Whether skins would last, as far as one step shows.
bool ModeChooser::are_mild(const Motions& motions) const {
  return motions.fast < tuning::many_fast(dimension_) && motions.speed < tuning::kMildSpeed;
}

/// Where too many objects are restless, the next try is far away, until they are few.
void ModeChooser::count_cost(float cost) {
  if (cost < tuning::kCostlyKeeping) return;
  begin_period();
  regrets_ = true;
  crowded_ = true;
}

void ModeChooser::enter(Mode mode) {
  if (!regrets_) begin_period();
  regrets_ = false;
  mode_ = mode;
}

/// Each time that keeping ends before it has paid, the wait for the next time doubles.
void ModeChooser::begin_period() {
  if (mode_ == Mode::kept && steps_ < tuning::kPaidSteps)
    patience_ = std::min(2 * patience_, tuning::kLongestPatience);
  if (mode_ == Mode::kept && steps_ >= tuning::kPaidWellSteps) patience_ = tuning::kShortPatience;
  steps_ = 0;
  against_ = 0;
}

ModeChooser::Memory ModeChooser::memory() const {
  const bool keeps = mode_ == Mode::kept && !regrets_;
  return {(keeps ? 1U : 0U) | (crowded_ ? 2U : 0U) | rows_ << 2U, steps_, against_, patience_};
}

void ModeChooser::resume(Mode mode, const Memory& memory) {
  mode_ = mode;
  taken_ = nullptr;
  regrets_ = mode == Mode::kept && (memory[0] & 1U) == 0;
  crowded_ = (memory[0] & 2U) != 0;
  rows_ = std::min(memory[0] >> 2U, tuning::kRowSteps);
  steps_ = memory[1];
  against_ = memory[2];
  patience_ = memory[3];
}

}  // namespace kerf
