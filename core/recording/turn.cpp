#include "core/recording/turn.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/base/damage.h"

namespace kerf {
namespace {

constexpr double kWholeTurn = 65'536;
constexpr std::int32_t kOne = 4'096;  ///< of a component

/// A unit quaternion: w, x, y, z.
using Quaternion = std::array<double, 4>;

std::int16_t wrapped(std::int32_t angle) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(static_cast<std::uint32_t>(angle)));
}

Quaternion quaternion_of(const Turn<3>& turn) {
  Quaternion q{};
  std::int32_t rest = kOne * kOne;
  std::size_t part = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (k == turn.left_out) continue;
    const std::int32_t x = turn.parts[part++];
    rest -= x * x;
    q[k] = static_cast<double>(x) / kOne;
  }
  q[turn.left_out] = std::sqrt(static_cast<double>(std::max(rest, 0))) / kOne;
  return q;
}

/// The components but one, as if that one had a plus.
TurnParts<3> parts_without(const Quaternion& q, std::uint8_t left_out) {
  const double scale = q[left_out] < 0 ? -kOne : kOne;
  TurnParts<3> parts{};
  std::size_t part = 0;
  for (std::size_t k = 0; k < 4; ++k)
    if (k != left_out) parts[part++] = static_cast<std::int32_t>(std::nearbyint(scale * q[k]));
  return parts;
}

/// Shepperd's method: from the largest of the four squares, so that no small number is divided by.
Quaternion quaternion_of(const std::array<Vector<3>, 3>& axes) {
  const auto at = [&](int row, int column) {
    return static_cast<double>(axes[static_cast<std::size_t>(column)][row]);
  };
  const double trace = at(0, 0) + at(1, 1) + at(2, 2);
  const std::array<double, 4> squares{trace, at(0, 0), at(1, 1), at(2, 2)};
  const auto largest = static_cast<int>(std::ranges::max_element(squares) - squares.begin());
  Quaternion q{};
  if (largest == 0) {
    q = {1 + trace, at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1)};
  } else {
    const int i = largest - 1;
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    q[0] = at(k, j) - at(j, k);
    q[static_cast<std::size_t>(i) + 1] = 1 + at(i, i) - at(j, j) - at(k, k);
    q[static_cast<std::size_t>(j) + 1] = at(j, i) + at(i, j);
    q[static_cast<std::size_t>(k) + 1] = at(k, i) + at(i, k);
  }
  double norm = 0;
  for (const double x : q) norm += x * x;
  norm = std::sqrt(norm);
  for (double& x : q) x /= norm;
  return q;
}

}  // namespace

template <>
Turn<2> turn_of<2>(const std::array<Vector<2>, 2>& axes) {
  const double angle = std::atan2(static_cast<double>(axes[0][1]), static_cast<double>(axes[0][0]));
  const double part = std::nearbyint(angle / (2 * std::numbers::pi) * kWholeTurn);
  return {0, {wrapped(static_cast<std::int32_t>(part))}};
}

template <>
Turn<3> turn_of<3>(const std::array<Vector<3>, 3>& axes) {
  const Quaternion q = quaternion_of(axes);
  const auto largest = std::ranges::max_element(q, {}, [](double x) { return std::abs(x); });
  Turn<3> turn{static_cast<std::uint8_t>(largest - q.begin()), {}};
  std::ranges::transform(parts_without(q, turn.left_out), turn.parts.begin(),
                         [](std::int32_t part) { return static_cast<std::int16_t>(part); });
  return turn;
}

template <>
std::array<Vector<2>, 2> axes_of<2>(const Turn<2>& turn) {
  const double angle = 2 * std::numbers::pi * static_cast<double>(turn.parts[0]) / kWholeTurn;
  const auto c = static_cast<Scalar>(std::cos(angle));
  const auto s = static_cast<Scalar>(std::sin(angle));
  return {Vector<2>{{c, s}}, Vector<2>{{-s, c}}};
}

template <>
std::array<Vector<3>, 3> axes_of<3>(const Turn<3>& turn) {
  const auto [w, x, y, z] = quaternion_of(turn);
  const auto axis = [](double a, double b, double c) {
    return Vector<3>{{static_cast<Scalar>(a), static_cast<Scalar>(b), static_cast<Scalar>(c)}};
  };
  return {axis(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)),
          axis(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)),
          axis(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y))};
}

template <>
TurnParts<2> parts_of<2>(const Turn<2>& turn, std::uint8_t /*left_out*/) {
  return {turn.parts[0]};
}

template <>
TurnParts<3> parts_of<3>(const Turn<3>& turn, std::uint8_t left_out) {
  if (turn.left_out != left_out) return parts_without(quaternion_of(turn), left_out);
  return {turn.parts[0], turn.parts[1], turn.parts[2]};
}

template <>
TurnParts<2> parts_after<2>(const Turn<2>& now, const Turn<2>& before, std::uint8_t /*left_out*/) {
  return {wrapped(2 * now.parts[0] - before.parts[0])};
}

/// For unit quaternions, now * conjugate(before) * now = 2 (now . before) now - before.
template <>
TurnParts<3> parts_after<3>(const Turn<3>& now, const Turn<3>& before, std::uint8_t left_out) {
  if (now == before) return parts_of(now, left_out);
  const Quaternion a = quaternion_of(now);
  const Quaternion b = quaternion_of(before);
  const double along = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  Quaternion next{};
  for (std::size_t k = 0; k < 4; ++k) next[k] = 2 * along * a[k] - b[k];
  return parts_without(next, left_out);
}

template <>
std::int32_t difference<2>(std::int32_t from, std::int32_t to) {
  return wrapped(to - from);
}

template <>
std::int32_t difference<3>(std::int32_t from, std::int32_t to) {
  return to - from;
}

template <>
Turn<2> make_turn<2>(std::uint8_t /*left_out*/, const TurnParts<2>& foretold,
                     const TurnParts<2>& differences) {
  return {0, {wrapped(foretold[0] + differences[0])}};
}

template <>
Turn<3> make_turn<3>(std::uint8_t left_out, const TurnParts<3>& foretold, const TurnParts<3>& differences) {
  Turn<3> turn{left_out, {}};
  std::int32_t squares = 0;
  for (std::size_t k = 0; k < turn.parts.size(); ++k) {
    const std::int64_t part = std::int64_t{foretold[k]} + differences[k];
    if (part < -kOne || part > kOne) fail_damaged("an object is turned as nothing can be");
    turn.parts[k] = static_cast<std::int16_t>(part);
    squares += turn.parts[k] * turn.parts[k];
  }
  if (squares > kOne * kOne) fail_damaged("an object is turned as nothing can be");
  return turn;
}

}  // namespace kerf
