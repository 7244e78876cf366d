#include "core/trace/event_facts.h"

#include "core/base/overloaded.h"

namespace kerf {
namespace {

/// The event as one kind; null if it is one of the others, which are all named.
template <class Kind, class... Others>
const Kind* only(const Event& event) {
  using Answer = const Kind*;
  return std::visit(Overloaded{[](const Kind& e) -> Answer { return &e; }, NothingFor<Answer, Others...>()},
                    event.body);
}

}  // namespace

std::optional<Deed> deed_of(const Event& event) {
  const auto deed = [](const auto& e) { return std::optional(Deed{e.op, e.node}); };
  return std::visit(
      Overloaded{
          [&](const OperatorScheduled& e) { return deed(e); },
          [&](const OperatorActed& e) { return deed(e); },
          [&](const OperatorRefused& e) { return deed(e); },
          NothingFor<std::optional<Deed>, PhaseBegan, ObjectPlaced, EventsDeferred, AllPlaced>(),
      },
      event.body);
}

std::optional<NodeRef> node_of(const Event& event) {
  const auto deed = deed_of(event);
  return deed ? std::optional(deed->node) : std::nullopt;
}

std::optional<ObjectId> object_of(const Event& event) {
  const auto* const placed = placed_of(event);
  return placed == nullptr ? std::nullopt : std::optional(placed->object);
}

std::optional<Phase> phase_of(const Event& event) {
  const auto* const began = only<PhaseBegan, ObjectPlaced, OperatorScheduled, OperatorActed, OperatorRefused,
                                 EventsDeferred, AllPlaced>(event);
  return began == nullptr ? std::nullopt : std::optional(began->phase);
}

const ObjectPlaced* placed_of(const Event& event) {
  return only<ObjectPlaced, PhaseBegan, OperatorScheduled, OperatorActed, OperatorRefused, EventsDeferred,
              AllPlaced>(event);
}

const OperatorActed* acted_of(const Event& event) {
  return only<OperatorActed, PhaseBegan, ObjectPlaced, OperatorScheduled, OperatorRefused, EventsDeferred,
              AllPlaced>(event);
}

const OperatorRefused* refused_of(const Event& event) {
  return only<OperatorRefused, PhaseBegan, ObjectPlaced, OperatorScheduled, OperatorActed, EventsDeferred,
              AllPlaced>(event);
}

const OperatorScheduled* scheduled_of(const Event& event) {
  return only<OperatorScheduled, PhaseBegan, ObjectPlaced, OperatorActed, OperatorRefused, EventsDeferred,
              AllPlaced>(event);
}

}  // namespace kerf
