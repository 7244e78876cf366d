#pragma once

#include <optional>

#include "core/trace/event.h"

namespace kerf {

// What an event says, asked one question at a time. Each answer is found by a visit that names every kind of
// event: a new kind does not compile before each question has an answer for it.

/// An operator at a node: scheduled, refused or done.
struct Deed {
  Operator op = Operator::split;
  NodeRef node;
};

std::optional<Deed> deed_of(const Event& event);
std::optional<NodeRef> node_of(const Event& event);
/// The object that was placed by itself.
std::optional<ObjectId> object_of(const Event& event);
/// The phase that begins.
std::optional<Phase> phase_of(const Event& event);

/// Null unless that is what happened. Valid as long as the event.
const ObjectPlaced* placed_of(const Event& event);
const OperatorActed* acted_of(const Event& event);
const OperatorRefused* refused_of(const Event& event);
const OperatorScheduled* scheduled_of(const Event& event);
const ObjectPlaced* placed_of(Event&&) = delete;
const OperatorActed* acted_of(Event&&) = delete;
const OperatorRefused* refused_of(Event&&) = delete;
const OperatorScheduled* scheduled_of(Event&&) = delete;

inline bool has_acted(const Event& event) { return acted_of(event) != nullptr; }
inline bool begins_phase(const Event& event) { return phase_of(event).has_value(); }
/// An operator acted or was refused.
inline bool is_outcome(const Event& event) { return has_acted(event) || refused_of(event) != nullptr; }

}  // namespace kerf
