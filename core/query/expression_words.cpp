#include "core/query/expression_words.h"

#include <algorithm>
#include <array>

#include "core/trace/event.h"

namespace kerf {
namespace {

constexpr std::array kVariables{
    VariableWord{Variable::step, "step", "number of the step"},
    VariableWord{Variable::objects, "objects", "objects that have a place in the tree"},
    VariableWord{Variable::changed, "changed", "objects that came, went or got another box in the step"},
    VariableWord{Variable::pairs, "pairs", "pairs that the step reported"},
    VariableWord{Variable::height, "height", "depth of the deepest leaf"},
    VariableWord{Variable::leaves, "leaves", "leaves of the tree"},
    VariableWord{Variable::entries, "entries", "entries in all leaves"},
    VariableWord{Variable::redundancy, "redundancy", "entries / objects - 1"},
    VariableWord{Variable::refused, "refused", "operators refused since the beginning"},
    VariableWord{Variable::deferred, "deferred", "events waiting for a later step"},
    VariableWord{Variable::placed, "placed", "objects that changed leaves in the step"},
    VariableWord{Variable::step_time, "step_time", "seconds that the broad phase took"},
    VariableWord{Variable::place_time, "place_time", "of them for placing"},
    VariableWord{Variable::sort_time, "sort_time", "of them for sorting"},
    VariableWord{Variable::schedule_time, "schedule_time", "of them for scheduling"},
    VariableWord{Variable::operate_time, "operate_time", "of them for operators"},
    VariableWord{Variable::sweep_time, "sweep_time", "of them for sweeping"},
    VariableWord{Variable::missed, "missed",
                 "pairs that the tree missed, by the oracle; of an import, that they missed"},
    VariableWord{Variable::extra, "extra", "reported pairs that do not overlap"},
    VariableWord{Variable::twice, "twice", "pairs reported again"},
    VariableWord{Variable::ignored, "ignored", "pairs of an import that are no fault, by what was declared"},
    VariableWord{Variable::undecided, "undecided",
                 "pairs of an import that touch only in the digits that were written"},
    VariableWord{Variable::event, "event", "number of the event"},
    VariableWord{Variable::op, "op", "balance, shift_split, split, swap or merge"},
    VariableWord{Variable::kind, "kind", "phase, placed, scheduled, acted, refused, deferred or all_placed"},
    VariableWord{Variable::phase, "phase", "place, sort, schedule, operate or sweep, as it begins"},
    VariableWord{Variable::node, "node", "number of the operator's node"},
    VariableWord{Variable::object, "object", "number of the object that was placed"},
    VariableWord{Variable::population, "population", "objects below the node, before the operator"},
    VariableWord{Variable::balance, "balance", "of the node's partitioner, after the operator"},
    VariableWord{Variable::straddlers, "straddlers", "objects on both sides of it, after the operator"},
    VariableWord{Variable::depth, "depth", "of the operator's node; the root has 0"},
};

constexpr double value_of(Operator op) { return static_cast<double>(op); }
constexpr double value_of(Phase phase) { return static_cast<double>(phase); }

template <class Kind>
constexpr double number_of() {
  return static_cast<double>(EventBody(Kind{}).index());
}

constexpr std::array kValues{
    NamedValue{Variable::op, "balance", value_of(Operator::balance)},
    NamedValue{Variable::op, "shift_split", value_of(Operator::shift_split)},
    NamedValue{Variable::op, "split", value_of(Operator::split)},
    NamedValue{Variable::op, "swap", value_of(Operator::swap)},
    NamedValue{Variable::op, "merge", value_of(Operator::merge)},
    NamedValue{Variable::phase, "place", value_of(Phase::place)},
    NamedValue{Variable::phase, "sort", value_of(Phase::sort)},
    NamedValue{Variable::phase, "schedule", value_of(Phase::schedule)},
    NamedValue{Variable::phase, "operate", value_of(Phase::operate)},
    NamedValue{Variable::phase, "sweep", value_of(Phase::sweep)},
    NamedValue{Variable::kind, "phase", number_of<PhaseBegan>()},
    NamedValue{Variable::kind, "placed", number_of<ObjectPlaced>()},
    NamedValue{Variable::kind, "scheduled", number_of<OperatorScheduled>()},
    NamedValue{Variable::kind, "acted", number_of<OperatorActed>()},
    NamedValue{Variable::kind, "refused", number_of<OperatorRefused>()},
    NamedValue{Variable::kind, "deferred", number_of<EventsDeferred>()},
    NamedValue{Variable::kind, "all_placed", number_of<AllPlaced>()},
};
static_assert(std::ranges::count(kValues, Variable::kind, &NamedValue::of) == std::variant_size_v<EventBody>,
              "a kind of event has no word");

}  // namespace

std::span<const VariableWord> variable_words() { return kVariables; }
std::span<const NamedValue> named_values() { return kValues; }

}  // namespace kerf
