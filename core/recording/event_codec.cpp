#include "core/recording/event_codec.h"

#include <type_traits>
#include <utility>

namespace kerf {
namespace {

// One pair of functions for each kind of event: `visit_fields` names the fields once for writing and reading.

struct FieldWriter {
  ByteWriter& out;
  void operator()(std::uint32_t x) const { out.varint(x); }
  void operator()(float x) const { out.f32(x); }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(Enum x) const { out.u8(static_cast<std::uint8_t>(x)); }
};

/// The number of values of an enumeration.
constexpr std::uint8_t count_of(Operator /*kind*/) { return kOperatorCount; }
constexpr std::uint8_t count_of(Phase /*kind*/) { return kPhaseCount; }
constexpr std::uint8_t count_of(Refusal /*kind*/) { return kRefusalCount; }

struct FieldReader {
  ByteReader& in;
  void operator()(std::uint32_t& x) const { x = in.number(); }
  void operator()(float& x) const { x = in.f32(); }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(Enum& x) const { x = static_cast<Enum>(in.choice(count_of(x))); }
};

void visit_fields(auto& ref, const auto& field) requires requires { ref.generation; }
{
  field(ref.node.value);
  field(ref.generation);
}
void visit_fields(auto& quality, const auto& field) requires requires { quality.right; }
{
  field(quality.population);
  field(quality.left);
  field(quality.right);
}

template <class Body>
void visit_body(Body& body, const auto& field) {
  using Plain = std::remove_const_t<Body>;
  if constexpr (requires { body.op; }) {
    field(body.op);
    visit_fields(body.node, field);
  }
  if constexpr (std::is_same_v<Plain, PhaseBegan>) {
    field(body.phase);
  } else if constexpr (std::is_same_v<Plain, ObjectPlaced>) {
    field(body.object.value);
    field(body.leaves);
  } else if constexpr (std::is_same_v<Plain, EventsDeferred>) {
    field(body.count);
  } else if constexpr (std::is_same_v<Plain, AllPlaced>) {
    field(body.objects);
  } else if constexpr (std::is_same_v<Plain, OperatorRefused>) {
    field(body.reason);
  } else if constexpr (std::is_same_v<Plain, OperatorActed>) {
    visit_fields(body.before, field);
    visit_fields(body.after, field);
    field(body.direction);
    field(body.old_offset);
    field(body.new_offset);
  } else {
    static_assert(std::is_same_v<Plain, OperatorScheduled>, "a kind of event that is not written");
  }
}

/// A default event body of the given alternative.
template <std::size_t... Index>
EventBody make_body(std::size_t index, std::index_sequence<Index...> /*all*/) {
  EventBody body;
  ((index == Index ? static_cast<void>(body.emplace<Index>()) : static_cast<void>(0)), ...);
  return body;
}

}  // namespace

void put_events(std::span<const Event> events, ByteWriter& out) {
  out.varint(events.size());
  for (const Event& event : events) {
    out.u8(static_cast<std::uint8_t>(event.body.index()));
    std::visit([&](const auto& body) { visit_body(body, FieldWriter{out}); }, event.body);
  }
}

std::vector<Event> get_events(ByteReader& in, const StepRow& row) {
  constexpr std::size_t kKinds = std::variant_size_v<EventBody>;
  constexpr std::size_t kLeast = 2;  // bytes of an event: its kind and one field
  const std::size_t count = in.count(kLeast);
  if (count != row.events) fail_damaged("a step has other events in its block than its row says");
  std::vector<Event> events(count);
  std::uint64_t id = row.first_event;
  for (Event& event : events) {
    event.id = id++;
    event.step = row.step;
    event.body = make_body(in.choice(kKinds), std::make_index_sequence<kKinds>());
    std::visit([&](auto& body) { visit_body(body, FieldReader{in}); }, event.body);
  }
  return events;
}

}  // namespace kerf
