#pragma once

#include <array>
#include <cstdint>

#include "core/base/tuning.h"
#include "core/bsp/mode.h"
#include "core/bsp/motions.h"

namespace kerf {

/// What is known before a step. Only the sample that belongs to the present mode is read.
struct Evidence {
  bool bytes = false;  ///< leaves may be swept by bytes
  bool skins = false;  ///< pairs of fat boxes may be kept
  Motions motions;     ///< while leaves are swept: of all objects
  Leaving leaving;     ///< while pairs are kept: of the objects that left their fat boxes
  bool shift = false;  ///< nearly all objects moved alike: how they move beside that is not known
  bool rows = false;   ///< the world is small and little moves: its pairs may be bits
};

/// Decides before each step in which mode it finds its pairs, by the table of transitions (docs/MODES.md).
/// Nothing changes the mode within a step.
///
/// Keeping pays while few objects leave their fat boxes, since to look one up again costs much more than to
/// sweep over it. An object that becomes too fast for a skin leaves once and is followed from then on; where
/// there are many such objects, leaves are swept all the same. At the first step no speed is known: leaves
/// are swept, which takes less time and memory.
class ModeChooser {
 public:
  explicit ModeChooser(int dimension) : dimension_(dimension) {}

  [[nodiscard]] Mode mode() const { return mode_; }
  /// Counts the evidence and takes the transition that is due.
  void decide(const Evidence& evidence);
  /// The transition that the last decision took, an element of kTransitions; null if the mode stayed.
  [[nodiscard]] const Transition* taken() const { return taken_; }
  /// Counts for the next decision: what the present step costs with kept pairs, over what it would cost if
  /// all leaves were swept.
  void count_cost(float cost);
  /// Whether the next decision has no need of a sample: keeping was too costly.
  [[nodiscard]] bool regrets() const { return regrets_; }

  /// Whether pairs have been rows of bits for so long that more such steps are not counted.
  [[nodiscard]] bool has_settled_on_rows() const {
    return mode_ == Mode::swept && taken_ == nullptr && rows_ == tuning::kRowSteps;
  }

  /// What it remembers beside the mode, as numbers for a keyframe.
  using Memory = std::array<std::uint32_t, 4>;
  [[nodiscard]] Memory memory() const;
  void resume(Mode mode, const Memory& memory);

 private:
  void count(const Evidence& evidence);
  void forget();
  void count_leaving(const Leaving& leaving);
  void count_motions(const Motions& motions);
  [[nodiscard]] bool holds(Condition condition, const Evidence& evidence) const;
  [[nodiscard]] bool are_mild(const Motions& motions) const;
  void enter(Mode mode);
  void begin_period();

  int dimension_;
  Mode mode_ = Mode::ordered;
  const Transition* taken_ = nullptr;
  bool regrets_ = false;        ///< keeping was too costly in the last step
  bool crowded_ = false;        ///< the last regret was for restless objects, and they are still many
  std::uint32_t steps_ = 0;     ///< decided since the mode changed
  std::uint32_t against_ = 0;   ///< steps in a row that count for a change
  std::uint32_t rows_ = 0;      ///< steps in a row in which rows paid, as far as they count
  std::uint32_t patience_ = 0;  ///< how many of them it takes to keep pairs; 0: no speed was known yet
};

}  // namespace kerf
