#include "frames/python/recorded_rows.h"

#include <algorithm>
#include <array>
#include <limits>
#include <variant>

#include "core/base/overloaded.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

/// Signed, so that numpy's differences and means of it are as expected.
std::int64_t whole(std::uint64_t count) { return static_cast<std::int64_t>(count); }

PythonEvent empty_event(const Event& event) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  PythonEvent row{};
  row.id = whole(event.id);
  row.step = static_cast<std::int32_t>(event.step);
  row.kind = static_cast<std::int8_t>(event.body.index());
  row.op = row.reason = row.phase = -1;
  row.node = row.generation = row.object = row.count = -1;
  row.population = row.left = row.right = row.direction = -1;
  row.old_offset = row.new_offset = kNone;
  return row;
}

void set_node(PythonEvent& event, Operator op, NodeRef node) {
  event.op = static_cast<std::int8_t>(op);
  event.node = node.node.value;
  event.generation = node.generation;
}

void set_acted(PythonEvent& event, const OperatorActed& acted) {
  set_node(event, acted.op, acted.node);
  event.population = acted.before.population;
  event.left = acted.after.left;
  event.right = acted.after.right;
  event.direction = acted.direction;
  event.old_offset = acted.old_offset;
  event.new_offset = acted.new_offset;
}

PythonStep to_python(const StepRow& row) {
  const Statistics& tree = row.statistics;
  return {.step = row.step,
          .objects = tree.objects,
          .changed = whole(row.changed),
          .pairs = whole(row.pairs),
          .first_event = whole(row.first_event),
          .events = whole(row.events),
          .leaves = tree.leaves,
          .height = tree.height,
          .entries = whole(tree.entries),
          .redundancy = tree.redundancy,
          .placed = whole(tree.placed),
          .refused = whole(tree.refused),
          .deferred = tree.deferred,
          .seconds = row.seconds(),
          .state_hash = row.state_hash,
          .pairs_hash = row.pairs_hash};
}

}  // namespace

std::span<const char* const> event_kind_names() {
  static constexpr std::array<const char*, std::variant_size_v<EventBody>> kNames{
      "phase", "placed", "scheduled", "acted", "refused", "deferred", "all_placed"};
  return kNames;
}

void register_rows() {
  PYBIND11_NUMPY_DTYPE(PythonStep, step, objects, changed, pairs, first_event, events, leaves, height,
                       entries, redundancy, placed, refused, deferred, seconds, state_hash, pairs_hash);
  PYBIND11_NUMPY_DTYPE(PythonEvent, id, step, kind, op, reason, phase, node, generation, object, count,
                       population, left, right, direction, old_offset, new_offset);
}

py::array step_array(std::span<const StepRow> rows) {
  py::array_t<PythonStep> array(static_cast<py::ssize_t>(rows.size()));
  std::ranges::transform(rows, array.mutable_data(), [](const StepRow& row) { return to_python(row); });
  return array;
}

PythonEvent to_python(const Event& event) {
  PythonEvent row = empty_event(event);
  std::visit(Overloaded{
                 [&](const PhaseBegan& e) { row.phase = static_cast<std::int8_t>(e.phase); },
                 [&](const ObjectPlaced& e) {
                   row.object = e.object.value;
                   row.count = e.leaves;
                 },
                 [&](const OperatorScheduled& e) { set_node(row, e.op, e.node); },
                 [&](const OperatorActed& e) { set_acted(row, e); },
                 [&](const OperatorRefused& e) {
                   set_node(row, e.op, e.node);
                   row.reason = static_cast<std::int8_t>(e.reason);
                 },
                 [&](const EventsDeferred& e) { row.count = e.count; },
                 [&](const AllPlaced& e) { row.count = e.objects; },
             },
             event.body);
  return row;
}

}  // namespace kerf::python
