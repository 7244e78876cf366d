#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/query/expression.h"
#include "core/replay/position.h"
#include "core/replay/replayer.h"

namespace kerf {

/// Which change of a value to look for. A value that does not exist at a moment, such as the depth of no
/// node, is no change; nor is the very first value, unless it is true.
enum class Change : std::uint8_t { any, becomes_true };

/// Finds the moments of a recorded run at which an expression holds: after events if it is about events, else
/// at the ends of steps. It uses recorded data first and replays the run only where that does not suffice.
///
/// Everything throws std::runtime_error if the recording is damaged, and std::invalid_argument for an
/// expression that it cannot answer (see `check`).
template <int D>
class Search {
 public:
  /// Called with each step; when it returns false the search ends without a result.
  using Progress = std::function<bool(std::uint32_t)>;

  explicit Search(std::shared_ptr<RecordingReader<D>> recording);

  /// Of a part of a recording that has answered the expressions: where it lacks what they name, they do not
  /// hold.
  void take_all() { takes_all_ = true; }
  /// Throws std::invalid_argument for an expression about an object that the recording does not have, or
  /// about the other engine's pairs of an import that has none.
  void check(const Expression& expression);

  /// The first moment after `from`; none if there is none.
  std::optional<Position> forward(const Expression& expression, const Position& from,
                                  const Progress& progress = {});
  /// The last moment before `from`.
  std::optional<Position> backward(const Expression& expression, const Position& from,
                                   const Progress& progress = {});

  /// The same for moments at which the value differs from that of the moment before.
  std::optional<Position> forward_change(const Expression& expression, const Position& from, Change change,
                                         const Progress& progress = {});
  std::optional<Position> backward_change(const Expression& expression, const Position& from, Change change,
                                          const Progress& progress = {});

  /// The value of an expression right after an event or at the end of a step; none for a value that does
  /// not exist there, and for everything before the first step.
  ConditionNumber value(const Expression& expression, const Position& at);

 private:
  /// The first or the last of a step's moments between two.
  struct Range {
    Position after;
    Position before;
    bool wants_last = false;
  };

  struct ValueAt {
    Position position;
    ConditionNumber value;
  };
  std::vector<ValueAt> values_in(const Expression& expression, std::uint32_t step);
  std::optional<ConditionNumber> last_value(const Expression& expression, const Position& up_to);

  template <class Visit>
  void visit_events(const Expression& expression, std::uint32_t step, Visit visit);
  void check_object(const GivenId& id);
  [[nodiscard]] std::uint32_t most_objects() const;
  [[nodiscard]] std::vector<Pair> pairs_now(const Expression& expression) const;
  [[nodiscard]] bool needs_replay(const Expression& expression) const;
  std::optional<Position> in_step(const Expression& expression, std::uint32_t step, const Range& range);
  std::optional<Position> in_events(const Expression& expression, std::uint32_t step, const Range& range);
  std::optional<Position> at_end(const Expression& expression, std::uint32_t step, const Range& range);

  std::shared_ptr<RecordingReader<D>> recording_;
  std::unique_ptr<Replayer<D>> replayer_;  ///< null until it is needed
  std::vector<std::optional<double>> medians_;
  std::optional<std::uint32_t> object_bound_;  ///< none: not asked yet
  bool takes_all_ = false;
  std::optional<bool> has_judgement_;  ///< whether `missed` and the like are known; none: not asked yet
};

}  // namespace kerf
