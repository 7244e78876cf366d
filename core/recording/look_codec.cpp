#include "core/recording/look_codec.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "core/recording/compression.h"

namespace kerf {
namespace {

/// What a request changes in the look of its object.
struct Changes {
  static constexpr std::uint8_t kTurn = 1;
  static constexpr std::uint8_t kComponent = 2;  ///< of the turn, that is left out
  static constexpr std::uint8_t kShape = 4;      ///< and turn and component anew
  static constexpr std::uint8_t kStretch = 8;
  static constexpr std::uint8_t kEnd = 16;
};

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

/// Between next to nothing and three times the size.
std::int16_t checked_stretch(std::int32_t stretch) {
  constexpr std::int32_t kLeast = -500;
  constexpr std::int32_t kMost = 1'024;
  if (stretch < kLeast || stretch > kMost) fail_damaged("an object is stretched as nothing can be");
  return static_cast<std::int16_t>(stretch);
}

std::int32_t get_part(ByteReader& in) {
  const std::uint32_t x = in.number();
  if (bits_in(x) > kMostBits) fail_damaged("an object is turned as nothing can be");
  return unzigzag(x);
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
    tracks_[id].before = tracks_[id].now;
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
  return parts_after(track.now.turn, track.before.turn, left_out);
}

template <int D>
std::array<std::int32_t, D> LookPredictor<D>::foretell_stretch(const Track& track) {
  std::array<std::int32_t, D> stretch{};
  for (std::size_t i = 0; i < D; ++i) stretch[i] = 2 * track.now.stretch[i] - track.before.stretch[i];
  return stretch;
}

template <int D>
void LookPredictor<D>::learn(Track& track, const Look<D>& look) {
  if (look.turn != track.now.turn) {
    const std::uint8_t left_out = look.turn.left_out;
    const TurnParts<D> parts = parts_of(look.turn, left_out);
    const std::array foretold{parts_of(track.now.turn, left_out),
                              parts_after(track.now.turn, track.before.turn, left_out)};
    for (std::size_t rule = 0; rule < foretold.size(); ++rule) {
      const unsigned bits = error_of<D>(foretold[rule], parts);
      track.error[rule] = static_cast<std::uint8_t>((track.error[rule] + 2 * bits) / 2);
    }
  }
  const bool is_new = track.before.shape != look.shape;
  track.before = is_new ? look : track.now;
  track.now = look;
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
  const bool reshaped = look.shape != track.now.shape;
  if (reshaped) {
    kinds_.u8(Changes::kShape | (look.stretch == Stretch<D>{} ? 0 : Changes::kStretch));
    put_shape(look.shape, last_shape_, numbers_);
    LookPredictor<D>::reset(track, look.shape);
    if (look.shape == kNoShape) return;
  }
  const bool turned = reshaped || look.turn != track.now.turn;
  const bool turned_about = reshaped || look.turn.left_out != track.now.turn.left_out;
  const bool stretched = look.stretch != track.now.stretch;
  if (!reshaped)
    kinds_.u8(static_cast<std::uint8_t>((turned ? Changes::kTurn : 0) |
                                        (turned_about ? Changes::kComponent : 0) |
                                        (stretched ? Changes::kStretch : 0)));
  if (turned_about) numbers_.u8(look.turn.left_out);
  const TurnParts<D> foretold = LookPredictor<D>::foretell(track, look.turn.left_out);
  const TurnParts<D> parts = parts_of(look.turn, look.turn.left_out);
  for (std::size_t k = 0; turned && k < parts.size(); ++k)
    add_difference(k, difference<D>(foretold[k], parts[k]));
  const auto stretch = LookPredictor<D>::foretell_stretch(track);
  for (std::size_t i = 0; stretched && i < D; ++i)
    add_difference(parts.size() + i, look.stretch[i] - stretch[i]);
  LookPredictor<D>::learn(track, look);
}

template <int D>
void LookEncoder<D>::add_difference(std::size_t column, std::int32_t difference) {
  const std::uint32_t off = zigzag(difference);
  const unsigned length = bits_in(off);
  lengths_[column].u8(static_cast<std::uint8_t>(length));
  if (length > 1) bits_.put(off ^ (1U << (length - 1)), length - 1);  // the highest bit is known to be set
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
  for (std::size_t k = 0; k < kLookColumns<D>; ++k) lengths_.emplace_back(block.blob());
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
  const std::uint8_t kinds = kinds_.choice(Changes::kEnd);
  const auto has = [kinds](std::uint8_t kind) { return (kinds & kind) != 0; };
  const bool reshaped = has(Changes::kShape);
  if (reshaped) {
    LookPredictor<D>::reset(track, get_shape(numbers_, last_shape_));
    if (track.now.shape == kNoShape) {
      changes.push_back({object, track.now});
      return;
    }
  }
  Look<D> look = track.now;
  if (reshaped || has(Changes::kComponent)) look.turn.left_out = get_component<D>(numbers_);
  if (reshaped || has(Changes::kTurn)) look.turn = read_turn(track, look.turn.left_out);
  if (has(Changes::kStretch)) look.stretch = read_stretch(track);
  LookPredictor<D>::learn(track, look);
  if (kinds != 0) changes.push_back({object, look});
}

template <int D>
std::int32_t LookDecoder<D>::read_difference(std::size_t column) {
  const unsigned length = lengths_[column].choice(kMostBits + 1);
  std::uint32_t off = length == 0 ? 0 : 1U << (length - 1);
  if (length > 1) off |= bits_.get(length - 1);
  return unzigzag(off);
}

template <int D>
Turn<D> LookDecoder<D>::read_turn(const typename LookPredictor<D>::Track& track, std::uint8_t left_out) {
  TurnParts<D> differences{};
  for (std::size_t k = 0; k < differences.size(); ++k) differences[k] = read_difference(k);
  return make_turn<D>(left_out, LookPredictor<D>::foretell(track, left_out), differences);
}

template <int D>
Stretch<D> LookDecoder<D>::read_stretch(const typename LookPredictor<D>::Track& track) {
  const auto foretold = LookPredictor<D>::foretell_stretch(track);
  Stretch<D> stretch{};
  for (std::size_t i = 0; i < D; ++i)
    stretch[i] = checked_stretch(foretold[i] + read_difference(Turn<D>::kParts + i));
  return stretch;
}

template <int D>
Bytes encode_looks(const Looks<D>& looks) {
  std::uint32_t bound = looks.bound();
  while (bound > 0 && looks.of({bound - 1}).shape == kNoShape) --bound;
  if (bound == 0) return {};
  ByteWriter out;
  std::array<ByteWriter, kLookColumns<D>> parts;
  ByteWriter components;
  std::uint32_t last = 0;
  out.varint(bound);
  for (std::uint32_t id = 0; id < bound; ++id) {
    const Look<D> look = looks.of({id});
    put_shape(look.shape, last, out);
    if (look.shape == kNoShape) continue;
    components.u8(look.turn.left_out);
    std::size_t column = 0;
    for (const std::int16_t part : look.turn.parts) parts[column++].varint(zigzag(part));
    for (const std::int16_t part : look.stretch) parts[column++].varint(zigzag(part));
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
  for (std::size_t k = 0; k < kLookColumns<D>; ++k) parts.emplace_back(in.blob());
  for (std::uint32_t id = 0; id < shapes.size(); ++id) {
    if (shapes[id] == kNoShape) continue;
    const std::uint8_t left_out = get_component<D>(components);
    std::array<std::int32_t, kLookColumns<D>> read{};
    std::ranges::transform(parts, read.begin(), get_part);
    TurnParts<D> turn{};
    std::copy_n(read.begin(), turn.size(), turn.begin());
    Look<D> look{shapes[id], make_turn<D>(left_out, {}, turn), {}};
    for (std::size_t i = 0; i < D; ++i) look.stretch[i] = checked_stretch(read[turn.size() + i]);
    looks.set({id}, look);
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
