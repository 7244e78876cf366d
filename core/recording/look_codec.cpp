#include "core/recording/look_codec.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "core/recording/compression.h"

namespace kerf {
namespace {

/// What a request changes in the look of its object.
enum class Kind : std::uint8_t {
  same,
  turned,
  turned_about,  ///< and another component is left out
  reshaped
};
constexpr std::uint8_t kKinds = 4;

constexpr std::uint8_t kMostBits = 18;  ///< of a difference

template <int D>
constexpr std::uint8_t kComponents = D == 2 ? 1 : 4;

unsigned bits_in(std::uint32_t x) { return static_cast<unsigned>(std::bit_width(x)); }

/// Shapes are counted from 1, so that none is 0.
std::uint32_t counted_from_one(std::uint32_t shape) { return shape + 1; }

/// Objects that come have new shapes, and these have rising numbers.
void put_shape(std::uint32_t shape, std::uint32_t& last, ByteWriter& out) {
  out.varint(zigzag(static_cast<std::int32_t>(counted_from_one(shape) - last)));
  last = counted_from_one(shape);
}

std::uint32_t get_shape(ByteReader& in, std::uint32_t& last) {
  last += static_cast<std::uint32_t>(unzigzag(in.number()));
  return last - 1;
}

template <int D>
std::uint8_t get_component(ByteReader& in) {
  return in.choice(kComponents<D>);
}

/// In bits, of all parts.
template <int D>
unsigned error_of(const TurnParts<D>& foretold, const TurnParts<D>& parts) {
  unsigned bits = 0;
  for (std::size_t k = 0; k < parts.size(); ++k)
    bits += bits_in(zigzag(difference<D>(foretold[k], parts[k])));
  return bits;
}

}  // namespace

template <int D>
void LookPredictor<D>::restart(const Looks<D>& looks) {
  tracks_.assign(looks.bound(), {});
  for (std::uint32_t id = 0; id < looks.bound(); ++id) {
    tracks_[id].now = looks.of({id});
    tracks_[id].before = tracks_[id].now.turn;
  }
}

template <int D>
auto LookPredictor<D>::track(ObjectId object) -> Track& {
  if (object.index() >= tracks_.size()) tracks_.resize(object.index() + 1);
  return tracks_[object.index()];
}

template <int D>
Looks<D> LookPredictor<D>::looks() const {
  Looks<D> looks;
  for (std::uint32_t id = 0; id < tracks_.size(); ++id)
    if (tracks_[id].now.shape != kNoShape) looks.set({id}, tracks_[id].now);
  return looks;
}

template <int D>
TurnParts<D> LookPredictor<D>::foretell(const Track& track, std::uint8_t left_out) {
  if (track.error[0] <= track.error[1]) return parts_of(track.now.turn, left_out);
  return parts_after(track.now.turn, track.before, left_out);
}

template <int D>
void LookPredictor<D>::learn(Track& track, const Turn<D>& turn) {
  const TurnParts<D> parts = parts_of(turn, turn.left_out);
  const std::array foretold{parts_of(track.now.turn, turn.left_out),
                            parts_after(track.now.turn, track.before, turn.left_out)};
  for (std::size_t rule = 0; rule < foretold.size(); ++rule) {
    const unsigned bits = error_of<D>(foretold[rule], parts);
    track.error[rule] = static_cast<std::uint8_t>((track.error[rule] + 2 * bits) / 2);
  }
  track.before = track.now.turn;
  track.now.turn = turn;
}

template <int D>
void LookEncoder<D>::add(const StepRequests<D>& requests, std::span<const Look<D>> looks) {
  if (looks.size() < requests.objects.size()) return;
  std::size_t k = 0;
  for (const Call& call : requests.calls)
    for (const std::size_t end = k + call.count; k < end; ++k) {
      auto& track = predictor_.track(requests.objects[k]);
      if (call.kind == RequestKind::remove) {
        LookPredictor<D>::reset(track, kNoShape);
      } else {
        add(track, looks[k]);
      }
    }
}

template <int D>
void LookEncoder<D>::add(typename LookPredictor<D>::Track& track, const Look<D>& look) {
  Kind kind = Kind::same;
  if (look.shape != track.now.shape)
    kind = Kind::reshaped;
  else if (look.turn != track.now.turn)
    kind = look.turn.left_out == track.now.turn.left_out ? Kind::turned : Kind::turned_about;
  kinds_.u8(static_cast<std::uint8_t>(kind));
  if (kind == Kind::reshaped) {
    put_shape(look.shape, last_shape_, numbers_);
    LookPredictor<D>::reset(track, look.shape);
    if (look.shape == kNoShape) return;
  }
  if (kind == Kind::reshaped || kind == Kind::turned_about) numbers_.u8(look.turn.left_out);
  if (kind == Kind::same) {
    track.before = track.now.turn;
    return;
  }
  add_turn(track, look.turn);
  if (kind == Kind::reshaped) track.before = look.turn;
}

template <int D>
void LookEncoder<D>::add_turn(typename LookPredictor<D>::Track& track, const Turn<D>& turn) {
  const TurnParts<D> foretold = LookPredictor<D>::foretell(track, turn.left_out);
  const TurnParts<D> parts = parts_of(turn, turn.left_out);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::uint32_t off = zigzag(difference<D>(foretold[k], parts[k]));
    const unsigned length = bits_in(off);
    lengths_[k].u8(static_cast<std::uint8_t>(length));
    if (length > 1) bits_.put(off ^ (1U << (length - 1)), length - 1);  // the highest bit is known to be set
  }
  LookPredictor<D>::learn(track, turn);
}

template <int D>
void LookEncoder<D>::take(ByteWriter& block) {
  block.blob(kinds_.bytes());
  block.blob(numbers_.bytes());
  kinds_.clear();
  numbers_.clear();
  for (ByteWriter& lengths : lengths_) {
    block.blob(lengths.bytes());
    lengths.clear();
  }
  block.blob(bits_.take());
  last_shape_ = 0;
}

template <int D>
void LookDecoder<D>::open(ByteReader& block) {
  kinds_ = ByteReader(block.blob());
  numbers_ = ByteReader(block.blob());
  lengths_.clear();
  for (std::size_t k = 0; k < Turn<D>::kParts; ++k) lengths_.emplace_back(block.blob());
  bits_ = BitReader(block.blob());
  has_looks_ = !kinds_.empty();
  last_shape_ = 0;
}

template <int D>
bool LookDecoder<D>::empty() const {
  return kinds_.empty() && numbers_.empty() && bits_.empty() &&
         std::ranges::all_of(lengths_, &ByteReader::empty);
}

template <int D>
std::vector<LookChange<D>> LookDecoder<D>::read(const StepRequests<D>& requests) {
  std::vector<LookChange<D>> changes;
  std::size_t k = 0;
  for (const Call& call : requests.calls)
    for (const std::size_t end = k + call.count; k < end; ++k) {
      const ObjectId object = requests.objects[k];
      if (call.kind != RequestKind::remove) {
        if (has_looks_) read_one(object, changes);
        continue;
      }
      auto& track = predictor_.track(object);
      if (track.now.shape != kNoShape) changes.push_back({object, {}});
      LookPredictor<D>::reset(track, kNoShape);
    }
  return changes;
}

template <int D>
void LookDecoder<D>::read_one(ObjectId object, std::vector<LookChange<D>>& changes) {
  auto& track = predictor_.track(object);
  const auto kind = static_cast<Kind>(kinds_.choice(kKinds));
  if (kind == Kind::same) {
    track.before = track.now.turn;
    return;
  }
  std::uint8_t left_out = track.now.turn.left_out;
  if (kind == Kind::reshaped) {
    LookPredictor<D>::reset(track, get_shape(numbers_, last_shape_));
    if (track.now.shape == kNoShape) {
      changes.push_back({object, track.now});
      return;
    }
  }
  if (kind != Kind::turned) left_out = get_component<D>(numbers_);
  const Turn<D> turn = read_turn(track, left_out);
  LookPredictor<D>::learn(track, turn);
  if (kind == Kind::reshaped) track.before = turn;
  changes.push_back({object, track.now});
}

template <int D>
Turn<D> LookDecoder<D>::read_turn(typename LookPredictor<D>::Track& track, std::uint8_t left_out) {
  TurnParts<D> differences{};
  for (std::size_t k = 0; k < differences.size(); ++k) {
    const unsigned length = lengths_[k].choice(kMostBits + 1);
    std::uint32_t off = length == 0 ? 0 : 1U << (length - 1);
    if (length > 1) off |= bits_.get(length - 1);
    differences[k] = unzigzag(off);
  }
  return make_turn<D>(left_out, LookPredictor<D>::foretell(track, left_out), differences);
}

template <int D>
Bytes encode_looks(const Looks<D>& looks) {
  std::uint32_t bound = looks.bound();
  while (bound > 0 && looks.of({bound - 1}).shape == kNoShape) --bound;
  if (bound == 0) return {};
  ByteWriter out;
  std::array<ByteWriter, Turn<D>::kParts> parts;
  ByteWriter components;
  std::uint32_t last = 0;
  out.varint(bound);
  for (std::uint32_t id = 0; id < bound; ++id) {
    const Look<D> look = looks.of({id});
    put_shape(look.shape, last, out);
    if (look.shape == kNoShape) continue;
    components.u8(look.turn.left_out);
    for (std::size_t k = 0; k < parts.size(); ++k) parts[k].varint(zigzag(look.turn.parts[k]));
  }
  out.blob(components.bytes());
  for (const ByteWriter& part : parts) out.blob(part.bytes());
  return compress(out.bytes());
}

template <int D>
Looks<D> decode_looks(std::span<const std::uint8_t> bytes, std::size_t bound) {
  Looks<D> looks;
  if (bytes.empty()) return looks;
  const Bytes plain = decompress(bytes);
  ByteReader in(plain);
  std::vector<std::uint32_t> shapes(in.count());
  if (shapes.size() > bound) fail_damaged("a keyframe has looks of objects that it does not have");
  std::uint32_t last = 0;
  for (std::uint32_t& shape : shapes) shape = get_shape(in, last);
  ByteReader components(in.blob());
  std::vector<ByteReader> parts;
  for (std::size_t k = 0; k < Turn<D>::kParts; ++k) parts.emplace_back(in.blob());
  for (std::uint32_t id = 0; id < shapes.size(); ++id) {
    if (shapes[id] == kNoShape) continue;
    const std::uint8_t left_out = get_component<D>(components);
    TurnParts<D> read{};
    std::ranges::transform(parts, read.begin(), [](ByteReader& part) {
      const std::uint32_t x = part.number();
      if (bits_in(x) > kMostBits) fail_damaged("an object is turned as nothing can be");
      return unzigzag(x);
    });
    looks.set({id}, {shapes[id], make_turn<D>(left_out, {}, read)});
  }
  if (!in.empty() || !components.empty() || !std::ranges::all_of(parts, &ByteReader::empty))
    fail_damaged("a keyframe has more looks than objects");
  return looks;
}

#define KERF_INSTANTIATE(D)                        \
  template class LookPredictor<D>;                 \
  template class LookEncoder<D>;                   \
  template class LookDecoder<D>;                   \
  template Bytes encode_looks<D>(const Looks<D>&); \
  template Looks<D> decode_looks<D>(std::span<const std::uint8_t>, std::size_t);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
