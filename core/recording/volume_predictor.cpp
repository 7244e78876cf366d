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

/// The number of bits up to the highest one, of 2 * x + 1: to the compiler there is then always a set bit, or
/// it would make a needless branch.
unsigned bits_in(std::uint32_t x) {
  return static_cast<unsigned>(std::bit_width((std::uint64_t{x} << 1U) | 1U)) - 1;
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
  for_each_placed(table, [&](ObjectId object) {
    Track* const tracks = tracks_of(object);
    const Box<D> box = table.box(object);
    for (int axis = 0; axis < D; ++axis) {
      tracks[2 * axis].past.fill(box.min[axis]);
      tracks[2 * axis + 1].past.fill(box.max[axis]);
    }
    for (std::size_t channel = 2 * D; channel < channels_; ++channel)
      tracks[channel].past.fill(table.extra(object)[channel - 2 * D]);
  });
}

/// Inline, like the next function: four bytes stored and sixteen loaded would make the processor wait.
template <int D>
[[gnu::always_inline]] inline auto VolumePredictor<D>::foretell(const Track& track, const Track* partner)
    -> Foretold {
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

/// Without a branch: nothing predicts the outcome.
template <int D>
std::size_t VolumePredictor<D>::best_rule(const Track& track) {
  const auto ranked = [&track](std::uint32_t rule) { return std::uint32_t{track.error[rule]} << 2U | rule; };
  static_assert(kRules == 4);
  return std::min(std::min(ranked(0), ranked(1)), std::min(ranked(2), ranked(3))) & 3U;
}

template <int D>
[[gnu::always_inline]] inline auto VolumePredictor<D>::errors_of(const Foretold& foretold, Scalar value)
    -> Errors {
  Errors errors;
  for (std::size_t rule = 0; rule < kRules; ++rule) errors[rule] = distance(foretold[rule], ordered(value));
  return errors;
}

template <int D>
void VolumePredictor<D>::learn(Track& track, const Errors& errors, Scalar value) {
  for (std::size_t rule = 0; rule < kRules; ++rule) {
    const auto bits = bits_in(errors[rule]);
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
    const Errors errors = errors_of(foretell(track, partner_of(tracks, channel)), values[channel]);
    changed |= errors[0] != 0;
    const std::uint32_t error = errors[best_rule(track)];
    const auto length = bits_in(error);
    lengths[channel].push_back(static_cast<std::uint8_t>(length));
    if (length > 1) bits.put(error ^ (1U << (length - 1)), length - 1);  // the highest bit is known to be set
    learn(track, errors, values[channel]);
  }
  return changed;
}

template <int D>
bool VolumePredictor<D>::decode(ObjectId object, std::span<const std::uint8_t> lengths, BitReader& bits,
                                std::span<Scalar> values) {
  Track* const tracks = tracks_of(object);
  bool changed = false;
  for (std::size_t channel = 0; channel < values.size(); ++channel) {
    Track& track = tracks[channel];
    const Foretold foretold = foretell(track, partner_of(tracks, channel));
    const unsigned length = lengths[channel];
    std::uint32_t error = length == 0 ? 0 : 1U << (length - 1);
    if (length > 1) error |= bits.get(length - 1);
    values[channel] = unordered(moved(foretold[best_rule(track)], error));
    const Errors errors = errors_of(foretold, values[channel]);
    changed |= errors[0] != 0;
    learn(track, errors, values[channel]);
  }
  return changed;
}

template class VolumePredictor<2>;
template class VolumePredictor<3>;

}  // namespace kerf
