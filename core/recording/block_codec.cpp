#include "core/recording/block_codec.h"

#include <algorithm>

#include "core/base/float_mode.h"
#include "core/recording/compression.h"
#include "core/recording/event_codec.h"

namespace kerf {
namespace {

/// Whether an object came, went or, as `moved` says, got another box.
bool is_change(RequestKind kind, bool moved) {
  return moved || kind == RequestKind::remove || is_insert(kind);
}

/// The number of values that a call stores of each object: none for a removal.
template <int D>
std::size_t stored_channels(RequestKind kind, VolumeKind volume) {
  if (kind == RequestKind::remove) return 0;
  return has_volume(kind) ? channel_count<D>(volume) : 2 * D;
}

template <int D>
using Channels = std::array<Scalar, 2 * D + kMaxExtra<D>>;

template <int D>
void put_box(const Box<D>& box, Channels<D>& values) {
  for (int axis = 0; axis < D; ++axis) {
    values[static_cast<std::size_t>(2 * axis)] = box.min[axis];
    values[static_cast<std::size_t>(2 * axis + 1)] = box.max[axis];
  }
}

template <int D>
Box<D> get_box(const Channels<D>& values) {
  Box<D> box;
  for (int axis = 0; axis < D; ++axis) {
    box.min[axis] = values[static_cast<std::size_t>(2 * axis)];
    box.max[axis] = values[static_cast<std::size_t>(2 * axis + 1)];
  }
  return box;
}

constexpr std::size_t kLeastOfStep = 2;  ///< bytes of a step in a block: no calls and no events

void put_calls(const std::vector<Call>& calls, ByteWriter& out) {
  out.varint(calls.size());
  for (const Call& call : calls) {
    out.u8(static_cast<std::uint8_t>(call.kind));
    if (is_insert(call.kind)) out.u8(static_cast<std::uint8_t>(call.mobility));
    out.varint(call.count);
  }
}

std::vector<Call> get_calls(ByteReader& in) {
  constexpr std::size_t kLeast = 2;  // bytes of a call: its kind and its count
  constexpr std::uint8_t kKinds = static_cast<std::uint8_t>(RequestKind::remove) + 1;
  std::vector<Call> calls(in.count(kLeast));
  for (Call& call : calls) {
    call.kind = static_cast<RequestKind>(in.choice(kKinds));
    if (is_insert(call.kind)) call.mobility = in.choice(2) == 0 ? Mobility::moving : Mobility::fixed;
    call.count = in.number();
  }
  return calls;
}

/// How many objects the calls insert. They cannot name more than `objects`: those that are there or, in a
/// block, the bytes that are left for their numbers.
std::uint64_t inserts_in(const std::vector<Call>& calls, std::size_t objects) {
  std::uint64_t inserts = 0;
  std::uint64_t all = 0;
  for (const Call& call : calls) {
    all += call.count;
    inserts += is_insert(call.kind) ? call.count : 0;
  }
  if (all > objects) fail_damaged("its calls name more objects than it has");
  return inserts;
}

/// The columns of a block while it is read.
struct Columns {
  ByteReader calls;
  ByteReader objects;
  ByteReader events;
  std::vector<ByteReader> lengths;
  BitReader bits;

  [[nodiscard]] bool empty() const {
    return calls.empty() && objects.empty() && events.empty() && bits.empty() &&
           std::ranges::all_of(lengths, &ByteReader::empty);
  }
};

/// Returns how many of the objects came, went or got another box.
template <int D>
std::uint64_t get_volumes(Columns& columns, VolumeKind kind, const NumberRoom& room,
                          VolumePredictor<D>& predictor, StepRequests<D>& requests) {
  constexpr std::uint8_t kLengths = 33;
  std::uint64_t changed = 0;
  std::uint32_t last = 0;
  Channels<D> values{};
  std::array<std::uint8_t, 2 * D + kMaxExtra<D>> lengths{};
  for (const Call& call : requests.calls) {
    const std::size_t count = stored_channels<D>(call.kind, kind);
    for (std::uint32_t k = 0; k < call.count; ++k) {
      last += static_cast<std::uint32_t>(unzigzag(columns.objects.number()));
      if (!room.has({last})) fail_damaged("it names an object " + std::to_string(last));
      requests.objects.push_back({last});
      for (std::size_t channel = 0; channel < count; ++channel)
        lengths[channel] = columns.lengths[channel].choice(kLengths);
      values.fill(0);
      const bool moved = predictor.decode({last}, std::span(lengths).first(count), columns.bits,
                                          std::span(values).first(count));
      changed += is_change(call.kind, moved) ? 1 : 0;
      requests.boxes.push_back(get_box<D>(values));
      if (has_volume(call.kind))
        requests.extra.insert(requests.extra.end(), values.begin() + 2 * D, values.begin() + count);
    }
  }
  return changed;
}

}  // namespace

template <int D>
BlockEncoder<D>::BlockEncoder(VolumeKind kind)
    : kind_(kind), predictor_(kind), lengths_(channel_count<D>(kind)) {}

template <int D>
std::uint64_t BlockEncoder<D>::add(const StepRequests<D>& requests, std::span<const Event> events,
                                   std::span<const Look<D>> looks) {
  const DefaultFloats floats;
  ++steps_;
  put_calls(requests.calls, calls_);
  put_events(events, events_);
  room_.insert(inserts_in(requests.calls, requests.objects.size()));
  const std::uint64_t changed = add_volumes(requests);
  looks_.add(requests, looks);
  return changed;
}

template <int D>
std::uint64_t BlockEncoder<D>::add_volumes(const StepRequests<D>& requests) {
  std::uint64_t changed = 0;
  std::uint32_t last = 0;
  std::size_t k = 0;
  const Scalar* extra = requests.extra.data();
  Channels<D> values{};
  for (const Call& call : requests.calls) {
    const std::size_t count = stored_channels<D>(call.kind, kind_);
    for (const std::size_t end = k + call.count; k < end; ++k) {
      const ObjectId object = requests.objects[k];
      if (!room_.has(object))
        throw std::runtime_error(
            "object " + std::to_string(object.value) +
            " cannot be recorded: its number is far above how many objects there are; number them from 0 up");
      objects_.varint(zigzag(static_cast<std::int32_t>(object.value - last)));
      last = object.value;
      put_box<D>(requests.boxes[k], values);
      std::copy_n(extra, count > 2 * D ? count - 2 * D : 0, values.begin() + 2 * D);
      extra += count > 2 * D ? count - 2 * D : 0;
      const bool moved = predictor_.encode(object, std::span(values).first(count), lengths_, bits_);
      changed += is_change(call.kind, moved) ? 1 : 0;
    }
  }
  return changed;
}

template <int D>
Bytes BlockEncoder<D>::take() {
  ByteWriter block;
  block.varint(steps_);
  block.blob(calls_.bytes());
  block.blob(objects_.bytes());
  block.blob(events_.bytes());
  for (Bytes& column : lengths_) {
    block.blob(column);
    column.clear();
  }
  block.blob(bits_.take());
  looks_.take(block);
  calls_.clear();
  objects_.clear();
  events_.clear();
  steps_ = 0;
  return compress(block.bytes());
}

template <int D>
void BlockDecoder<D>::read(std::span<const std::uint8_t> block, std::span<const StepRow> rows,
                           std::vector<RecordedStep<D>>& steps) {
  const DefaultFloats floats;
  const Bytes bytes = decompress(block);
  ByteReader in(bytes);
  if (in.count(kLeastOfStep) != rows.size()) fail_damaged("it has other steps than its row says");
  Columns columns{ByteReader(in.blob()), ByteReader(in.blob()), ByteReader(in.blob()), {}, BitReader({})};
  for (std::size_t channel = 0; channel < channel_count<D>(kind_); ++channel)
    columns.lengths.emplace_back(in.blob());
  columns.bits = BitReader(in.blob());
  looks_.open(in);
  for (const StepRow& row : rows) {
    RecordedStep<D> step;
    step.requests.calls = get_calls(columns.calls);
    room_.insert(inserts_in(step.requests.calls, columns.objects.left()));
    step.changed = get_volumes(columns, kind_, room_, predictor_, step.requests);
    step.looks = looks_.read(step.requests);
    step.events = get_events(columns.events, row);
    steps.push_back(std::move(step));
  }
  if (!in.empty() || !columns.empty() || !looks_.empty()) fail_damaged("a block holds more than its steps");
}

template class BlockEncoder<2>;
template class BlockEncoder<3>;
template class BlockDecoder<2>;
template class BlockDecoder<3>;

}  // namespace kerf
