#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/recording/bits.h"
#include "core/recording/look.h"
#include "core/recording/step_requests.h"

namespace kerf {

/// Foretells how an object is turned: as it was, or as fast as it turned, by which of the two was less off
/// lately; and its stretch, as fast as it grew. An object without a request has the look that it had.
template <int D>
class LookPredictor {
 public:
  struct Track {
    Look<D> now;
    Look<D> before;
    std::array<std::uint8_t, 2> error{};  ///< of either rule, in bits
  };

  /// Forgets all motion.
  void restart(const Looks<D>& looks);
  Track& track(ObjectId object);
  [[nodiscard]] Looks<D> looks() const;

  static TurnParts<D> foretell(const Track& track, std::uint8_t left_out);
  static std::array<std::int32_t, D> foretell_stretch(const Track& track);
  static void learn(Track& track, const Look<D>& look);
  /// Another shape: what it had learnt of the old one is void.
  static void reset(Track& track, std::uint32_t shape) { track = {{shape, {}, {}}, {}, {}}; }

 private:
  std::vector<Track> tracks_;  ///< by object
};

/// Of the parts of a turn, then of the axes of a stretch.
template <int D>
inline constexpr std::size_t kLookColumns = Turn<D>::kParts + D;

/// The looks of a block's objects in columns: for each request what changes, then numbers of shapes and of
/// components left out, then for each part of a turn, and of a stretch, the lengths of its differences from
/// the one foretold; their bits follow.
template <int D>
class LookEncoder {
 public:
  void restart(const Looks<D>& looks) { predictor_.restart(looks); }
  /// `looks`: one for each of the requests' objects. Empty: nothing is known of any, in the whole recording.
  void add(const StepRequests<D>& requests, std::span<const Look<D>> looks);
  /// Appends the columns and begins anew.
  void take(ByteWriter& block);
  [[nodiscard]] Looks<D> looks() const { return predictor_.looks(); }

 private:
  void add(typename LookPredictor<D>::Track& track, const Look<D>& look);
  void add_difference(std::size_t column, std::int32_t difference);

  LookPredictor<D> predictor_;
  std::uint32_t last_shape_ = 0;
  ByteWriter kinds_;
  ByteWriter numbers_;
  std::array<ByteWriter, kLookColumns<D>> lengths_;
  BitWriter bits_;
};

/// Reads what LookEncoder wrote. Throws std::runtime_error for damaged columns.
template <int D>
class LookDecoder {
 public:
  void restart(const Looks<D>& looks) { predictor_.restart(looks); }
  /// The columns of a block.
  void open(ByteReader& block);
  /// The changes by the requests of the block's next step.
  std::vector<LookChange<D>> read(const StepRequests<D>& requests);
  /// Whether all of the block was read.
  [[nodiscard]] bool empty() const;

 private:
  void read_one(ObjectId object, std::vector<LookChange<D>>& changes);
  std::int32_t read_difference(std::size_t column);
  Turn<D> read_turn(const typename LookPredictor<D>::Track& track, std::uint8_t left_out);
  Stretch<D> read_stretch(const typename LookPredictor<D>::Track& track);

  LookPredictor<D> predictor_;
  std::uint32_t last_shape_ = 0;
  bool has_looks_ = false;
  ByteReader kinds_{{}};
  ByteReader numbers_{{}};
  std::vector<ByteReader> lengths_;
  BitReader bits_{{}};
};

/// All looks at a keyframe; no bytes if no object has one.
template <int D>
Bytes encode_looks(const Looks<D>& looks);
/// The reverse, for a table with `bound` places. Throws std::runtime_error for damaged bytes.
template <int D>
Looks<D> decode_looks(std::span<const std::uint8_t> bytes, std::size_t bound);

}  // namespace kerf
