#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/query/evaluate.h"
#include "core/recording/recording_info.h"
#include "core/replay/replayer.h"

namespace kerf {

/// The value of a variable in a step's row; none if the row does not have it.
ConditionNumber row_number(const StepRow& row, Variable variable);
/// The value of a variable in an event; none if the event does not have it.
ConditionNumber event_number(const Event& event, Variable variable);
/// The median over all steps; NaN if there are none. Only for variables of rows.
double row_median(std::span<const StepRow> rows, Variable variable);

/// A moment of a recording, with the tree beside it where it has been replayed.
template <int D>
class RecordedMoment final : public Moment {
 public:
  /// `tree` may be null: then there is no depth and no pair. `event` is null at the end of a step. `before`
  /// has the pairs of the step before, sorted; of an import those that overlap as they were given.
  RecordedMoment(const RecordingReader<D>& recording, std::uint32_t step, const Event* event,
                 const Bsp<D, Watch>* tree, const std::vector<Pair>* before,
                 std::vector<std::optional<double>>& medians);

  [[nodiscard]] ConditionNumber number(Variable variable) const override;
  [[nodiscard]] ConditionNumber median(Variable variable) const override;
  [[nodiscard]] bool happens(const ExpressionPart& happening) const override;

 private:
  [[nodiscard]] ConditionNumber judged(Variable variable) const;
  [[nodiscard]] long double median_step() const;
  [[nodiscard]] bool is_pair(const Pair& pair) const;

  const RecordingReader<D>& recording_;
  std::uint32_t step_;
  const Event* event_;
  const Bsp<D, Watch>* tree_;
  const std::vector<Pair>* before_;
  std::vector<std::optional<double>>& medians_;  ///< by variable; kept between moments
  mutable std::optional<TheirStep> judgement_;   ///< of the oracle, computed once
};

}  // namespace kerf
