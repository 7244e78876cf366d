#include "viz/debugger/model/event_kinds.h"

#include "core/base/overloaded.h"

namespace kerf {

EventKind kind_of_event(const Event& event) {
  return std::visit(Overloaded{
                        [](const PhaseBegan&) { return EventKind::phase; },
                        [](const ObjectPlaced&) { return EventKind::placed; },
                        [](const OperatorScheduled&) { return EventKind::scheduled; },
                        [](const OperatorActed& acted) { return kind_of(acted.op); },
                        [](const OperatorRefused&) { return EventKind::refused; },
                        [](const EventsDeferred&) { return EventKind::deferred; },
                        [](const AllPlaced&) { return EventKind::placed; },
                    },
                    event.body);
}

}  // namespace kerf
