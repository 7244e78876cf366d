#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/given_id.h"
#include "core/query/condition_number.h"

namespace kerf {

/// The values that an expression can name. Those up to `undecided` are known at the end of each step, the
/// others belong to an event.
enum class Variable : std::uint8_t {
  step,
  objects,
  changed,
  pairs,
  height,
  leaves,
  entries,
  redundancy,
  refused,
  deferred,
  placed,
  step_time,
  place_time,
  sort_time,
  schedule_time,
  operate_time,
  sweep_time,
  missed,
  extra,
  twice,
  ignored,
  undecided,
  event,
  op,
  kind,
  phase,
  node,
  object,
  population,
  balance,
  straddlers,
  depth,
};

/// Something that happens in a step or event.
enum class Happening : std::uint8_t {
  pair_is,       ///< pair(i,j)
  pair_enters,   ///< pair(i,j) enters: it is a pair, but was none a step before
  pair_leaves,   ///< pair(i,j) leaves
  plane_moves,   ///< plane(nK) moves: its partitioner was set or shifted
  node_changes,  ///< node(nK): an operator acted on it
  object_moves,  ///< object(i) moves: it was placed in other leaves
};

/// One part of an expression; its operands are other parts.
struct ExpressionPart {
  enum class Kind : std::uint8_t {
    number,
    variable,
    median,
    happening,
    negate,
    is_not,
    multiply,
    divide,
    add,
    subtract,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    unequal,
    both,
    either,
  };
  Kind kind = Kind::number;
  ConditionNumber number{};
  Variable variable = Variable::step;
  Happening happening = Happening::pair_is;
  GivenId a{};  ///< the node of a happening, or the object by its name
  GivenId b{};
  std::size_t left = 0;  ///< index of an operand; that of `negate` and `is_not`, too
  std::size_t right = 0;
};

/// A condition on a moment of a run, such as `op==merge && depth>8`. See docs/DEBUGGING.md.
class Expression {
 public:
  /// Throws std::invalid_argument that shows the place, and what is allowed there.
  static Expression parse(std::string_view text);
  /// The same for a text that may also be a number, such as `100*redundancy`: a value to watch.
  static Expression parse_value(std::string_view text);

  [[nodiscard]] std::span<const ExpressionPart> parts() const { return parts_; }
  [[nodiscard]] const ExpressionPart& root() const { return parts_.back(); }
  [[nodiscard]] const std::string& text() const { return text_; }

  /// Whether it must be evaluated at each event; else only at the ends of steps.
  [[nodiscard]] bool asks_events() const;
  /// Whether the recording alone cannot answer it: it needs the tree, its pairs or the oracle.
  [[nodiscard]] bool asks_pairs() const;
  [[nodiscard]] bool asks_oracle() const;
  [[nodiscard]] bool asks_depth() const;

 private:
  [[nodiscard]] bool has(bool (*wanted)(const ExpressionPart&)) const;

  std::string text_;
  std::vector<ExpressionPart> parts_;  ///< operands before their operators
};

}  // namespace kerf
