#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/kernels/found_rows.h"
#include "core/kernels/leaf_view.h"

namespace kerf {

/// The sweep of one leaf by vectors of bytes.
///
/// Each axis is mapped onto bytes by a function each operation of which is monotone, in floats, too
/// (ByteScale): every overlap stays one and a few are invented. Bytes are ordered along the axis that
/// separates best by counting, compared 64 at a time with all that begin before the entry ends, and what is
/// found is confirmed on the floats; where boxes lie dense, only that of which bytes alone do not make sure.
/// So the pairs are exact, and the same in the same order whatever the width of the machine's vectors.
template <int D>
class ByteSweep {
 public:
  /// Appends the closed overlaps among the view's boxes whose `apart` have no bit in common, as canonical
  /// pairs.
  void find(const LeafView<D>& leaf, PairBuffer& pairs);

  bool may_be_dense = true;  ///< false: floats confirm all pairs, however dense the boxes lie

  // The kernels' memory, kept between leaves: an array for each thing, since vectors read them side by side.
  static constexpr std::size_t kPad = 64;  ///< bytes that may be read beyond the end of a plane
  std::vector<ByteKey<D>> keys;            ///< of the entries as they came
  std::vector<std::uint32_t> order;        ///< the places of the entries in the view, in order
  std::vector<ByteKey<D>> sorted_keys;     ///< of the entries in order
  std::vector<std::uint8_t> planes;        ///< bytes in order: min of each axis, then max
  std::array<std::uint32_t, 257> ends{};   ///< [q + 1]: entries that begin at or before q
  Findings found{};
  std::size_t stride = 0;
  int axis = 0;           ///< along which the entries are ordered
  bool is_dense = false;  ///< most pairs are told by bytes alone; only then is what follows in use
  std::vector<std::uint32_t> objects;  ///< of the entries in order
  std::vector<std::uint8_t> apart;     ///< what keeps them apart, in order, in a byte
  PairBuffer unsure;                   ///< the pairs of which floats had to tell

  [[nodiscard]] std::uint8_t* plane(std::size_t k) { return planes.data() + k * stride; }
  void make_room(std::size_t n);
};

extern template class ByteSweep<2>;
extern template class ByteSweep<3>;

}  // namespace kerf
