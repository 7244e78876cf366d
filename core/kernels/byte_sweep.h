#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/kernels/clumps.h"
#include "core/kernels/float_sweep.h"
#include "core/kernels/found_rows.h"
#include "core/kernels/leaf_view.h"
#include "core/kernels/sweep_tuning.h"

namespace kerf {

/// The sweep of one leaf by vectors of bytes.
///
/// Each axis is mapped to bytes by a function whose every operation is monotone, also in floats (ByteScale),
/// so every overlap remains and a few are added. Entries are ordered by counting along the axis that
/// separates best, in finer steps where bytes are too coarse, and each is compared, 32 or 64 at a time, with
/// those behind it that begin before it ends. A leaf of clumps far from one another is divided between them;
/// where that does not help, as where sizes span decades around one place, floats are swept (FloatSweep).
/// Findings of bytes are confirmed on the floats; in dense leaves only those that bytes do not
/// prove. The pairs are exact, and in the same order for every width of vectors.
template <int D>
class ByteSweep {
 public:
  /// Appends the closed overlaps among the view's boxes whose `apart` masks have no common bit, as canonical
  /// pairs.
  void find(const LeafView<D>& leaf, PairBuffer& pairs);

  bool is_clumped = false;   ///< of the last leaf: its boxes lay in clumps, most of which shared a byte
  bool may_be_dense = true;  ///< false: floats confirm all pairs, however dense the boxes lie

  // The kernels' memory, kept between leaves: an array for each thing, since vectors read them side by side.
  static constexpr std::size_t kPad = 64;  ///< bytes that may be read beyond the end of a plane
  std::vector<ByteKey<D>> keys;            ///< of the entries in their own order
  std::vector<std::uint32_t> order;        ///< the places of the entries in the view, in order
  std::vector<ByteKey<D>> sorted_keys;     ///< of the entries in order
  std::vector<std::uint8_t> planes;        ///< bytes in order: min of each axis, then max
  std::vector<std::uint32_t> fine;   ///< steps of the entries: of min in the low half, of max in the high one
  std::vector<std::uint16_t> stops;  ///< the steps at which the entries end, in order
  /// [q + 1]: entries that begin at step q or before. Where the steps are bytes there are 256.
  std::array<std::uint32_t, tuning::kFineSteps + 1> ends{};
  Findings found{};
  std::size_t stride = 0;
  int axis = 0;           ///< along which the entries are ordered
  bool is_fine = false;   ///< steps of that axis are finer than bytes; only then `fine` is in use
  bool is_short = false;  ///< few entries begin before another one ends
  bool is_dense =
      false;  ///< most pairs are proved by bytes alone; only then are the following members in use
  std::vector<std::uint32_t> objects;  ///< of the entries in order
  std::vector<std::uint8_t> apart;     ///< exclusion masks folded to a byte, in order
  std::vector<std::uint32_t> others;   ///< those of one entry's pairs that need no floats
  PairBuffer unsure;                   ///< the pairs that need the floats
  FloatSweep floats;                   ///< where no bytes separate the boxes
  Clumps<D> clumps;                    ///< parts of a leaf that have yet to be swept

  [[nodiscard]] std::uint8_t* plane(std::size_t k) { return planes.data() + k * stride; }
  void make_room(std::size_t n);
};

}  // namespace kerf
