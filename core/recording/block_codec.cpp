#include "core/recording/block_codec.h"

#include <algorithm>

#include "core/recording/compression.h"
#include "core/recording/event_codec.h"

namespace kerf {
namespace {

/// The numbers that a call stores of each object: none of what is removed.
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

void put_calls(const std::vector<Call>& calls, ByteWriter& out) {
  out.varint(calls.size());
  for (const Call& call : calls) {
    out.u8(static_cast<std::uint8_t>(call.kind));
    if (is_insert(call.kind)) out.u8(static_cast<std::uint8_t>(call.mobility));
    out.varint(call.count);
  }
}

std::vector<Call> get_calls(ByteReader& in) {
  std::vector<Call> calls(in.count());
  for (Call& call : calls) {
    const std::uint8_t kind = in.u8();
    if (kind > static_cast<std::uint8_t>(RequestKind::remove))
      throw std::runtime_error("the recording is damaged: it has a request of no known kind");
    call.kind = static_cast<RequestKind>(kind);
    if (is_insert(call.kind)) call.mobility = in.u8() == 0 ? Mobility::moving : Mobility::fixed;
    call.count = static_cast<std::uint32_t>(in.varint());
  }
  return calls;
}

/// The columns of a block while it is read.
struct Columns {
  ByteReader calls;
  ByteReader objects;
  ByteReader events;
  std::vector<ByteReader> lengths;
  BitReader bits;
};

template <int D>
void get_volumes(Columns& columns, VolumeKind kind, VolumePredictor<D>& predictor,
                 StepRequests<D>& requests) {
  std::uint32_t last = 0;
  Channels<D> values{};
  std::array<std::uint8_t, 2 * D + kMaxExtra<D>> lengths{};
  for (const Call& call : requests.calls) {
    const std::size_t count = stored_channels<D>(call.kind, kind);
    for (std::uint32_t k = 0; k < call.count; ++k) {
      last += static_cast<std::uint32_t>(unzigzag(static_cast<std::uint32_t>(columns.objects.varint())));
      requests.objects.push_back({last});
      for (std::size_t channel = 0; channel < count; ++channel)
        lengths[channel] = columns.lengths[channel].u8();
      values.fill(0);
      predictor.decode({last}, std::span(lengths).first(count), columns.bits, std::span(values).first(count));
      requests.boxes.push_back(get_box<D>(values));
      if (has_volume(call.kind))
        requests.extra.insert(requests.extra.end(), values.begin() + 2 * D, values.begin() + count);
    }
  }
}

}  // namespace

template <int D>
BlockEncoder<D>::BlockEncoder(VolumeKind kind)
    : kind_(kind), predictor_(kind), lengths_(channel_count<D>(kind)) {}

template <int D>
std::uint64_t BlockEncoder<D>::add(const StepRequests<D>& requests, std::span<const Event> events) {
  ++steps_;
  put_calls(requests.calls, calls_);
  put_events(events, events_);
  return add_volumes(requests);
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
      objects_.varint(zigzag(static_cast<std::int32_t>(object.value - last)));
      last = object.value;
      put_box<D>(requests.boxes[k], values);
      std::copy_n(extra, count > 2 * D ? count - 2 * D : 0, values.begin() + 2 * D);
      extra += count > 2 * D ? count - 2 * D : 0;
      const bool moved = predictor_.encode(object, std::span(values).first(count), lengths_, bits_);
      changed += moved || call.kind == RequestKind::remove || is_insert(call.kind) ? 1 : 0;
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
  calls_.clear();
  objects_.clear();
  events_.clear();
  steps_ = 0;
  return compress(block.bytes());
}

template <int D>
void BlockDecoder<D>::read(std::span<const std::uint8_t> block, std::uint32_t first_step,
                           std::uint64_t first_event, std::vector<RecordedStep<D>>& steps) {
  const Bytes bytes = decompress(block);
  ByteReader in(bytes);
  const std::size_t count = in.count();
  Columns columns{ByteReader(in.blob()), ByteReader(in.blob()), ByteReader(in.blob()), {}, BitReader({})};
  for (std::size_t channel = 0; channel < channel_count<D>(kind_); ++channel)
    columns.lengths.emplace_back(in.blob());
  columns.bits = BitReader(in.blob());
  for (std::size_t k = 0; k < count; ++k) {
    RecordedStep<D> step;
    step.requests.calls = get_calls(columns.calls);
    get_volumes(columns, kind_, predictor_, step.requests);
    step.events = get_events(columns.events, first_step + static_cast<std::uint32_t>(k), first_event);
    first_event += step.events.size();
    steps.push_back(std::move(step));
  }
}

template class BlockEncoder<2>;
template class BlockEncoder<3>;
template class BlockDecoder<2>;
template class BlockDecoder<3>;

}  // namespace kerf
