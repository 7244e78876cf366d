#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/objects/object_table.h"
#include "core/recording/bits.h"

namespace kerf {

/// The numbers of a volume in order: min and max of each axis in turn, then those of its kind.
template <int D>
constexpr std::size_t channel_count(VolumeKind kind) {
  return static_cast<std::size_t>(2 * D + extra_size<D>(kind));
}

/// Predicts each number of a volume from its last three values and from its partner's (the min of the same
/// axis), so that only the difference is stored, without loss: as its length in bits, which compresses well,
/// and the bits themselves, which do not. Of four rules each number uses the one with the least recent error:
/// as it was, as fast as it was, as accelerated as it was, moved as its partner has just moved.
template <int D>
class VolumePredictor {
 public:
  explicit VolumePredictor(VolumeKind kind) : channels_(channel_count<D>(kind)) {}

  /// Forgets all motion: every object of the table stands where it is.
  void restart(const ObjectTable<D>& table);

  /// `values` are the first `count` numbers of the object's volume. Appends one length for each to
  /// `lengths[channel]`. Returns whether any differs from its last value.
  bool encode(ObjectId object, std::span<const Scalar> values, std::vector<Bytes>& lengths, BitWriter& bits);
  /// The reverse, with the given lengths, each up to 32.
  bool decode(ObjectId object, std::span<const std::uint8_t> lengths, BitReader& bits,
              std::span<Scalar> values);

 private:
  static constexpr std::size_t kRules = 4;
  using Foretold = std::array<std::int32_t, kRules>;
  using Errors = std::array<std::uint32_t, kRules>;

  /// One number of one volume: its last values, latest first, and the recent error of each rule, in bits.
  struct Track {
    std::array<Scalar, 3> past{};
    std::array<std::uint8_t, kRules> error{};
  };

  Track* tracks_of(ObjectId object);
  static Foretold foretell(const Track& track, const Track* partner);
  static std::size_t best_rule(const Track& track);
  /// The error of each rule.
  static Errors errors_of(const Foretold& foretold, Scalar value);
  static void learn(Track& track, const Errors& errors, Scalar value);
  [[nodiscard]] static const Track* partner_of(const Track* tracks, std::size_t channel) {
    return channel < 2 * D && channel % 2 == 1 ? tracks + channel - 1 : nullptr;
  }

  std::size_t channels_;
  std::vector<Track> tracks_;  ///< by object, then channel
};

}  // namespace kerf
