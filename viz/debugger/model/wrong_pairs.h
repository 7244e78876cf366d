#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/recording_reader.h"
#include "core/recording/theirs.h"
#include "core/replay/position.h"
#include "viz/debugger/model/selection.h"

namespace kerf {

/// A pair that another engine got wrong in a step.
struct WrongPair {
  std::uint32_t step = 0;
  Pair pair;
  PairVerdict verdict = PairVerdict::missed;
  friend auto operator<=>(const WrongPair&, const WrongPair&) = default;
};

/// Those of the whole run, by step, pair and verdict, as a recording has them; what the engine leaves out by
/// design, and what is undecided, is not among them.
template <int D>
std::vector<WrongPair> find_wrong_pairs(const RecordingReader<D>& recording);

/// "pair 5,6 extra at step 7"
std::string to_text(const WrongPair& wrong, const GivenNames& names);

/// Goes through the wrong pairs of a run, one after another.
class WrongPairWalk {
 public:
  /// The number of the wrong pair at which the user is: it is selected, in its step; none at another place.
  [[nodiscard]] std::optional<std::size_t> here(const std::vector<WrongPair>& all, const Position& position,
                                                const Selection& selection) const;
  /// The number of the next or the previous one; of those of a step at whose end none is selected, the first
  /// is the next, the last the previous. None if there is none.
  [[nodiscard]] std::optional<std::size_t> beside(const std::vector<WrongPair>& all, const Position& position,
                                                  const Selection& selection, bool forwards) const;
  /// The user has gone there.
  void arrive(std::size_t k) { at_ = k; }

 private:
  std::size_t at_ = 0;  ///< a pair can be wrong in a step more than once: this is the one last gone to
};

/// How many wrong pairs a step has.
struct Alarm {
  std::uint32_t step = 0;
  std::uint64_t missed = 0;
  std::uint64_t extra = 0;
  std::uint64_t twice = 0;
  [[nodiscard]] bool is_wrong() const { return missed + extra + twice > 0; }
};

}  // namespace kerf
