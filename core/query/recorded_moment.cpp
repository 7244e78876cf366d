#include "core/query/recorded_moment.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/median.h"
#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"
#include "core/trace/event_facts.h"
#include "core/tree/partitioner.h"

namespace kerf {
namespace {

constexpr ConditionNumber kNothing{};

ConditionNumber phase_time(const StepRow& row, Phase phase) {
  return ConditionNumber::measured(row.statistics.phase_seconds[static_cast<std::size_t>(phase)]);
}

ConditionNumber acted_number(const OperatorActed& acted, Variable variable) {
  if (variable == Variable::population) return ConditionNumber::of(acted.before.population);
  if (acted.after.left + acted.after.right == 0) return kNothing;  // a leaf has no partitioner
  if (variable == Variable::balance) return ConditionNumber::measured(double{balance(acted.after)});
  return ConditionNumber::of(redundancy(acted.after));
}

}  // namespace

ConditionNumber row_number(const StepRow& row, Variable variable) {
  const Statistics& s = row.statistics;
  switch (variable) {
    case Variable::step:
      return ConditionNumber::of(row.step);
    case Variable::objects:
      return ConditionNumber::of(s.objects);
    case Variable::changed:
      return ConditionNumber::of(row.changed);
    case Variable::pairs:
      return ConditionNumber::of(row.pairs);
    case Variable::height:
      return ConditionNumber::of(s.height);
    case Variable::leaves:
      return ConditionNumber::of(s.leaves);
    case Variable::entries:
      return ConditionNumber::of(s.entries);
    case Variable::redundancy:
      return ConditionNumber::measured(s.redundancy);
    case Variable::refused:
      return ConditionNumber::of(s.refused);
    case Variable::deferred:
      return ConditionNumber::of(s.deferred);
    case Variable::placed:
      return ConditionNumber::of(s.placed);
    case Variable::step_time:
      return ConditionNumber::measured(row.seconds());
    case Variable::place_time:
      return phase_time(row, Phase::place);
    case Variable::sort_time:
      return phase_time(row, Phase::sort);
    case Variable::schedule_time:
      return phase_time(row, Phase::schedule);
    case Variable::operate_time:
      return phase_time(row, Phase::operate);
    case Variable::sweep_time:
      return phase_time(row, Phase::sweep);
    default:
      return kNothing;
  }
}

ConditionNumber event_number(const Event& event, Variable variable) {
  switch (variable) {
    case Variable::event:
      return ConditionNumber::of(event.id);
    case Variable::op: {
      const auto deed = deed_of(event);
      return deed ? ConditionNumber::measured(static_cast<double>(deed->op)) : kNothing;
    }
    case Variable::kind:
      return ConditionNumber::of(event.body.index());
    case Variable::phase: {
      const auto phase = phase_of(event);
      return phase ? ConditionNumber::measured(static_cast<double>(*phase)) : kNothing;
    }
    case Variable::node: {
      const auto node = node_of(event);
      return node ? ConditionNumber::of(node->node.value) : kNothing;
    }
    case Variable::object: {
      const auto object = object_of(event);
      return object ? ConditionNumber::of(object->value) : kNothing;
    }
    case Variable::population:
    case Variable::balance:
    case Variable::straddlers: {
      const auto* const acted = acted_of(event);
      return acted == nullptr ? kNothing : acted_number(*acted, variable);
    }
    default:
      return kNothing;
  }
}

double row_median(std::span<const StepRow> rows, Variable variable) {
  if (rows.empty()) return kNothing.nearest;
  std::vector<double> values;
  for (const StepRow& row : rows) values.push_back(row_number(row, variable).nearest);
  return median(std::move(values));
}

template <int D>
RecordedMoment<D>::RecordedMoment(const RecordingReader<D>& recording, std::uint32_t step, const Event* event,
                                  const Bsp<D, Watch>* tree, const std::vector<Pair>* before,
                                  std::vector<std::optional<double>>& medians)
    : recording_(recording), step_(step), event_(event), tree_(tree), before_(before), medians_(medians) {}

template <int D>
ConditionNumber RecordedMoment<D>::number(Variable variable) const {
  const GivenNames& names = recording_.info().names;
  if (variable == Variable::step) return ConditionNumber::of(names.step_number(step_));
  if (variable >= Variable::missed && variable <= Variable::undecided) return judged(variable);
  if (variable < Variable::event) return row_number(recording_.row(step_), variable);
  if (event_ == nullptr) return kNothing;
  if (const auto object = object_of(*event_); object && variable == Variable::object)
    return ConditionNumber::of(names.object_id(*object));
  if (variable != Variable::depth) return event_number(*event_, variable);
  const auto node = node_of(*event_);
  if (!node || tree_ == nullptr || !tree_->tree().is_alive(*node)) return kNothing;
  return ConditionNumber::of(tree_->tree()[node->node].depth);
}

/// Another engine's pairs if the recording has some, else the tree's.
template <int D>
ConditionNumber RecordedMoment<D>::judged(Variable variable) const {
  if (!judgement_) judgement_ = recording_.their_step(step_);
  if (!judgement_) {
    if (tree_ == nullptr || event_ != nullptr) return kNothing;
    const PairJudgement judgement = judge_pairs(tree_->pairs(), oracle_pairs(tree_->objects()));
    judgement_ = TheirStep{
        tree_->pairs().size(), judgement.missed.size(), judgement.extra.size(), judgement.twice.size(), 0, 0};
  }
  if (variable == Variable::missed) return ConditionNumber::of(judgement_->missed);
  if (variable == Variable::extra) return ConditionNumber::of(judgement_->extra);
  if (variable == Variable::twice) return ConditionNumber::of(judgement_->twice);
  return ConditionNumber::of(variable == Variable::ignored ? judgement_->ignored : judgement_->undecided);
}

template <int D>
ConditionNumber RecordedMoment<D>::median(Variable variable) const {
  if (variable == Variable::step) return ConditionNumber::of(median_step());
  constexpr auto kRowVariables = static_cast<std::size_t>(Variable::missed);
  medians_.resize(kRowVariables);
  std::optional<double>& median = medians_[static_cast<std::size_t>(variable)];
  if (!median) median = row_median(recording_.rows(), variable);
  return ConditionNumber::measured(*median);
}

/// As the other engine calls its steps, which rise.
template <int D>
long double RecordedMoment<D>::median_step() const {
  const GivenNames& names = recording_.info().names;
  const std::uint32_t steps = recording_.steps();
  return (names.step_number((steps + 1) / 2) + names.step_number(steps / 2 + 1)) / 2;
}

template <int D>
bool RecordedMoment<D>::is_pair(const Pair& pair) const {
  return std::ranges::any_of(tree_->pairs(),
                             [&](const Pair& other) { return make_pair(other.a, other.b) == pair; }) &&
         (!recording_.info().imported || overlap_as_given(recording_, step_, tree_->objects(), pair));
}

template <int D>
bool RecordedMoment<D>::happens(const ExpressionPart& happening) const {
  if (happening.happening <= Happening::pair_leaves) {
    if (tree_ == nullptr || event_ != nullptr) return false;
    const GivenNames& names = recording_.info().names;
    const auto a = names.find_object(happening.a);
    const auto b = names.find_object(happening.b);
    if (!a || !b) return false;
    const Pair pair = make_pair(*a, *b);
    const bool is = is_pair(pair);
    if (happening.happening == Happening::pair_is) return is;
    const bool was = before_ != nullptr && std::ranges::binary_search(*before_, pair);
    return happening.happening == Happening::pair_enters ? is && !was : was && !is;
  }
  if (event_ == nullptr) return false;
  if (happening.happening == Happening::object_moves) {
    const auto object = object_of(*event_);
    return object && recording_.info().names.object_id(*object) == happening.a;
  }
  const auto* const acted = acted_of(*event_);
  if (acted == nullptr || GivenId::of(acted->node.node.value) != happening.a) return false;
  const bool sets_plane = acted->op != Operator::merge && acted->op != Operator::swap;
  return happening.happening == Happening::node_changes || sets_plane;
}

template class RecordedMoment<2>;
template class RecordedMoment<3>;

}  // namespace kerf
