#include "core/recording/volume_predictor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace kerf {
namespace {

/// Floats as integers in the same order, so that near floats are near integers. Every bit pattern has its
/// own.
std::int32_t ordered(Scalar x) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  return bits ^ ((bits >> 31) & 0x7FFFFFFF);
}
Scalar unordered(std::int32_t x) { return std::bit_cast<Scalar>(x ^ ((x >> 31) & 0x7FFFFFFF)); }

/// The nearest float of finite size; NaN becomes 0.
Scalar to_scalar(double x) {
  constexpr double kMax = std::numeric_limits<Scalar>::max();
  if (std::abs(x) <= kMax) return static_cast<Scalar>(x);
  return std::isnan(x) ? 0.0F : static_cast<Scalar>(std::copysign(kMax, x));
}

std::uint32_t distance(std::int32_t from, std::int32_t to) {
  const std::uint32_t wrapped = static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from);
  return zigzag(static_cast<std::int32_t>(wrapped));
}

std::int32_t moved(std::int32_t from, std::uint32_t distance) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(from) +
                                   static_cast<std::uint32_t>(unzigzag(distance)));
}

}  // namespace

template <int D>
auto VolumePredictor<D>::tracks_of(ObjectId object) -> Track* {
  const std::size_t end = (object.index() + 1) * channels_;
  if (tracks_.size() < end) tracks_.resize(end);
  return tracks_.data() + end - channels_;
}

template <int D>
void VolumePredictor<D>::restart(const ObjectTable<D>& table) {
  tracks_.assign(table.bound() * channels_, {});
  for (std::uint32_t id = 0; id < table.bound(); ++id) {
    if (!table.is_placed({id})) continue;
    Track* const tracks = tracks_of({id});
    const Box<D> box = table.box({id});
    for (int axis = 0; axis < D; ++axis) {
      tracks[2 * axis].past.fill(box.min[axis]);
      tracks[2 * axis + 1].past.fill(box.max[axis]);
    }
    for (std::size_t channel = 2 * D; channel < channels_; ++channel)
      tracks[channel].past.fill(table.extra({id})[channel - 2 * D]);
  }
}

template <int D>
auto VolumePredictor<D>::foretell(const Track& track, const Track* partner) -> Foretold {
  const double a = static_cast<double>(track.past[0]);
  const double b = static_cast<double>(track.past[1]);
  const double c = static_cast<double>(track.past[2]);
  const std::int32_t still = ordered(track.past[0]);
  Foretold foretold{still, ordered(to_scalar(2 * a - b)), ordered(to_scalar(3 * (a - b) + c)), still};
  if (partner != nullptr)  // it has its new value already
    foretold[3] = ordered(
        to_scalar(a + (static_cast<double>(partner->past[0]) - static_cast<double>(partner->past[1]))));
  return foretold;
}

template <int D>
std::size_t VolumePredictor<D>::best_rule(const Track& track) {
  return static_cast<std::size_t>(std::min_element(track.error.begin(), track.error.end()) -
                                  track.error.begin());
}

template <int D>
void VolumePredictor<D>::learn(Track& track, const Foretold& foretold, Scalar value) {
  for (std::size_t rule = 0; rule < kRules; ++rule) {
    const auto bits = static_cast<unsigned>(std::bit_width(distance(foretold[rule], ordered(value))));
    track.error[rule] = static_cast<std::uint8_t>((track.error[rule] + 2 * bits) / 2);
  }
  track.past = {value, track.past[0], track.past[1]};
}

template <int D>
bool VolumePredictor<D>::encode(ObjectId object, std::span<const Scalar> values, std::vector<Bytes>& lengths,
                                BitWriter& bits) {
  Track* const tracks = tracks_of(object);
  bool changed = false;
  for (std::size_t channel = 0; channel < values.size(); ++channel) {
    Track& track = tracks[channel];
    const Foretold foretold = foretell(track, partner_of(tracks, channel));
    changed |= foretold[0] != ordered(values[channel]);
    const std::uint32_t error = distance(foretold[best_rule(track)], ordered(values[channel]));
    const auto length = static_cast<unsigned>(std::bit_width(error));
    lengths[channel].push_back(static_cast<std::uint8_t>(length));
    if (length > 1) bits.put(error ^ (1U << (length - 1)), length - 1);  // the highest bit is known to be set
    learn(track, foretold, values[channel]);
  }
  return changed;
}

template <int D>
void VolumePredictor<D>::decode(ObjectId object, std::span<const std::uint8_t> lengths, BitReader& bits,
                                std::span<Scalar> values) {
  Track* const tracks = tracks_of(object);
  for (std::size_t channel = 0; channel < values.size(); ++channel) {
    Track& track = tracks[channel];
    const Foretold foretold = foretell(track, partner_of(tracks, channel));
    const unsigned length = std::min<unsigned>(lengths[channel], 32);
    std::uint32_t error = length == 0 ? 0 : 1U << (length - 1);
    if (length > 1) error |= bits.get(length - 1);
    values[channel] = unordered(moved(foretold[best_rule(track)], error));
    learn(track, foretold, values[channel]);
  }
}

template class VolumePredictor<2>;
template class VolumePredictor<3>;

}  // namespace kerf
