#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/given_names.h"
#include "core/base/ids.h"

namespace kerf {

/// The five operators of the paper, in the order in which Algorithm 1 processes them.
enum class Operator : std::uint8_t { balance, shift_split, split, swap, merge };
inline constexpr int kOperatorCount = 5;
std::string_view to_string(Operator op);

/// The quality of a partitioner over the objects tested against it (paper section 3.2).
struct Quality {
  std::uint32_t population = 0;  ///< objects tested
  std::uint32_t left = 0;        ///< of them stored left
  std::uint32_t right = 0;       ///< of them stored right
  friend constexpr bool operator==(const Quality&, const Quality&) = default;
};

/// An operator acted on `node`. `before` and `after` are the quality of its partitioner (empty for a leaf).
struct OperatorActed {
  Operator op = Operator::split;
  NodeRef node;
  Quality before;
  Quality after;
  std::uint32_t direction = 0;  ///< index in the direction set of the partitioner concerned
  float old_offset = 0;
  float new_offset = 0;
  friend bool operator==(const OperatorActed&, const OperatorActed&) = default;
};

/// Algorithm 1 put an operator into the event list.
struct OperatorScheduled {
  Operator op = Operator::split;
  NodeRef node;
  friend bool operator==(const OperatorScheduled&, const OperatorScheduled&) = default;
};

/// Why a scheduled or evaluated operator did not act.
enum class Refusal : std::uint8_t {
  dead_node,       ///< the node has died or been used again since
  not_needed,      ///< the condition that called for it is gone
  no_partitioner,  ///< no candidate meets the goodness criteria
  height,          ///< the height cap
  entries,         ///< the cap on entries
  list_full,       ///< the event list is full
  decided,         ///< a decision refuses it (see Decision)
};
inline constexpr int kRefusalCount = 7;
std::string_view to_string(Refusal refusal);

struct OperatorRefused {
  Operator op = Operator::split;
  NodeRef node;
  Refusal reason = Refusal::dead_node;
  friend bool operator==(const OperatorRefused&, const OperatorRefused&) = default;
};

/// Events left for a later step when the budget was spent.
struct EventsDeferred {
  std::uint32_t count = 0;
  friend bool operator==(const EventsDeferred&, const EventsDeferred&) = default;
};

/// An object changed leaves because it moved, came or went.
struct ObjectPlaced {
  ObjectId object;
  std::uint32_t leaves = 0;  ///< leaves that hold it now; 0: removed or quarantined
  friend bool operator==(const ObjectPlaced&, const ObjectPlaced&) = default;
};

/// So many objects left their leaves that all were placed anew in one pass.
struct AllPlaced {
  std::uint32_t objects = 0;
  friend bool operator==(const AllPlaced&, const AllPlaced&) = default;
};

/// A phase of a step begins.
enum class Phase : std::uint8_t { place, sort, schedule, operate, sweep };
inline constexpr int kPhaseCount = 5;
std::string_view to_string(Phase phase);
struct PhaseBegan {
  Phase phase = Phase::place;
  friend bool operator==(const PhaseBegan&, const PhaseBegan&) = default;
};

using EventBody = std::variant<PhaseBegan, ObjectPlaced, OperatorScheduled, OperatorActed, OperatorRefused,
                               EventsDeferred, AllPlaced>;

/// One thing that happened. Ids count up from 0 over the life of a broad phase and are the same in every run.
struct Event {
  std::uint64_t id = 0;
  std::uint32_t step = 0;
  EventBody body;
  friend bool operator==(const Event&, const Event&) = default;
};

/// One line for logs and captions, for example "e17 step 20 split n5: 65 -> 65 (33 | 34)".
std::string describe(const Event& event, const GivenNames& names);

}  // namespace kerf
