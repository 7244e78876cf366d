#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <span>

#include "core/recording/recording_info.h"
#include "core/trace/event.h"

namespace kerf::python {

/// What `Recording.rows` has of a step.
struct PythonStep {
  std::int64_t step;
  std::int64_t objects;
  std::int64_t changed;
  std::int64_t pairs;
  std::int64_t first_event;
  std::int64_t events;
  std::int64_t leaves;
  std::int64_t height;
  std::int64_t entries;
  double redundancy;
  std::int64_t placed;
  std::int64_t refused;
  std::int64_t deferred;
  double seconds;
  std::uint64_t state_hash;
  std::uint64_t pairs_hash;
};

/// What `Recording.events` has of an event; -1 stands for what its kind does not have.
struct PythonEvent {
  std::int64_t id;
  std::int32_t step;
  std::int8_t kind;    ///< index in EventBody
  std::int8_t op;      ///< Operator
  std::int8_t reason;  ///< Refusal
  std::int8_t phase;   ///< Phase
  std::int64_t node;
  std::int64_t generation;
  std::int64_t object;
  std::int64_t count;       ///< leaves of an object, events deferred, objects placed
  std::int64_t population;  ///< of an operator that acted, before
  std::int64_t left;        ///< objects left of the partitioner, after
  std::int64_t right;
  std::int64_t direction;
  float old_offset;  ///< NaN for what has none
  float new_offset;
};

/// The names of an event's kinds, in the order of EventBody.
std::span<const char* const> event_kind_names();

/// Makes both known to numpy.
void register_rows();

pybind11::array step_array(std::span<const StepRow> rows);
PythonEvent to_python(const Event& event);

}  // namespace kerf::python
