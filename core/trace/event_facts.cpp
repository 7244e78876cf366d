#include "core/trace/event_facts.h"

#include "core/base/overloaded.h"

namespace kerf {

std::optional<Deed> deed_of(const Event& event) {
  using Answer = std::optional<Deed>;
  return std::visit(Overloaded{
                        [](const OperatorScheduled& e) {
                          return Answer({e.op, e.node});
                        },
                        [](const OperatorActed& e) {
                          return Answer({e.op, e.node});
                        },
                        [](const OperatorRefused& e) {
                          return Answer({e.op, e.node});
                        },
                        NothingFor<Answer, PhaseBegan, ObjectPlaced, EventsDeferred, AllPlaced>(),
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
  using Answer = std::optional<Phase>;
  return std::visit(
      Overloaded{
          [](const PhaseBegan& e) { return Answer(e.phase); },
          NothingFor<Answer, ObjectPlaced, OperatorScheduled, OperatorActed, OperatorRefused, EventsDeferred,
                     AllPlaced>(),
      },
      event.body);
}

const ObjectPlaced* placed_of(const Event& event) {
  using Answer = const ObjectPlaced*;
  return std::visit(
      Overloaded{
          [](const ObjectPlaced& e) -> Answer { return &e; },
          NothingFor<Answer, PhaseBegan, OperatorScheduled, OperatorActed, OperatorRefused, EventsDeferred,
                     AllPlaced>(),
      },
      event.body);
}

const OperatorActed* acted_of(const Event& event) {
  using Answer = const OperatorActed*;
  return std::visit(
      Overloaded{
          [](const OperatorActed& e) -> Answer { return &e; },
          NothingFor<Answer, PhaseBegan, ObjectPlaced, OperatorScheduled, OperatorRefused, EventsDeferred,
                     AllPlaced>(),
      },
      event.body);
}

const OperatorRefused* refused_of(const Event& event) {
  using Answer = const OperatorRefused*;
  return std::visit(
      Overloaded{
          [](const OperatorRefused& e) -> Answer { return &e; },
          NothingFor<Answer, PhaseBegan, ObjectPlaced, OperatorScheduled, OperatorActed, EventsDeferred,
                     AllPlaced>(),
      },
      event.body);
}

const OperatorScheduled* scheduled_of(const Event& event) {
  using Answer = const OperatorScheduled*;
  return std::visit(
      Overloaded{
          [](const OperatorScheduled& e) -> Answer { return &e; },
          NothingFor<Answer, PhaseBegan, ObjectPlaced, OperatorActed, OperatorRefused, EventsDeferred,
                     AllPlaced>(),
      },
      event.body);
}

}  // namespace kerf
