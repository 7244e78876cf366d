#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/vector.h"

namespace kerf {

/// How a body is turned, rounded to whole numbers: no point of it is off by more than 2^-10 of its distance
/// from the body's origin.
template <int D>
struct Turn {
  static constexpr std::size_t kParts = D == 2 ? 1 : 3;

  /// 3D: the component of the unit quaternion (w, x, y, z) that is not stored, a largest one. Its sign is
  /// plus.
  std::uint8_t left_out = 0;
  /// 2D: the angle, in 65,536ths of a turn. 3D: the other components, in 4,096ths.
  std::array<std::int16_t, kParts> parts{};

  friend bool operator==(const Turn&, const Turn&) = default;
};

/// `axes`: where the body's axes point; orthonormal, right-handed.
template <int D>
Turn<D> turn_of(const std::array<Vector<D>, D>& axes);
template <int D>
std::array<Vector<D>, D> axes_of(const Turn<D>& turn);

/// The parts of a turn as a codec sees them.
template <int D>
using TurnParts = std::array<std::int32_t, Turn<D>::kParts>;

/// The parts of `turn` if `left_out` is left out.
template <int D>
TurnParts<D> parts_of(const Turn<D>& turn, std::uint8_t left_out);
/// The parts of the next turn if a body goes on to turn as it did from `before` to `now`. The same numbers on
/// every machine.
template <int D>
TurnParts<D> parts_after(const Turn<D>& now, const Turn<D>& before, std::uint8_t left_out);
/// How far a part is from the one foretold; in 2D angles wrap around.
template <int D>
std::int32_t difference(std::int32_t from, std::int32_t to);
/// The turn with the parts so far from those foretold. Throws std::runtime_error if there is none: then the
/// recording is damaged.
template <int D>
Turn<D> make_turn(std::uint8_t left_out, const TurnParts<D>& foretold, const TurnParts<D>& differences);

}  // namespace kerf
