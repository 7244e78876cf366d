#include "core/query/text.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/nearest_long_doubles.h"

namespace kerf {

std::string number_text(double x, int digits) {
  const NearestLongDoubles nearest;
  std::array<char, 40> text{};
  const int size = std::snprintf(text.data(), text.size(), "%.*g", digits, x);
  return {text.data(), static_cast<std::size_t>(size)};
}

int digits_apart(std::initializer_list<double> numbers) {
  constexpr int kMost = 17;  // these distinguish any two doubles
  const auto look_alike = [&](int digits) {
    for (const double x : numbers)
      for (const double y : numbers)
        if (x < y && number_text(x, digits) == number_text(y, digits)) return true;
    return false;
  };
  int digits = kDigits;
  while (digits < kMost && look_alike(digits)) ++digits;
  return digits;
}

std::string node_text(NodeId node) { return "n" + std::to_string(node.value); }

std::string sides_text(const Sides& sides) {
  if (sides.straddle()) return "both sides";
  return sides.left ? "left" : "right";
}

std::string interval_text(const Interval& interval, int digits) {
  return "[" + number_text(static_cast<double>(interval.lo), digits) + ", " +
         number_text(static_cast<double>(interval.hi), digits) + "]";
}

template <int D>
std::string box_text(const Box<D>& box) {
  std::string text;
  for (int axis = 0; axis < D; ++axis)
    text += std::string(axis == 0 ? "" : "  ") + "xyz"[axis] + " " +
            interval_text({box.min[axis], box.max[axis]});
  return text;
}

template <int D>
std::string box_text(const GivenBox<D>& box, const GivenBox<D>& beside) {
  std::string text;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const int digits = digits_apart({box.min[axis], box.max[axis], beside.min[axis], beside.max[axis]});
    text += std::string(axis == 0 ? "" : "  ") + "xyz"[axis] + " [" + number_text(box.min[axis], digits) +
            ", " + number_text(box.max[axis], digits) + "]";
  }
  return text;
}

template <int D>
std::string plane_text(const Plane<D>& plane, int digits) {
  std::string text;
  for (int axis = 0; axis < D; ++axis) {
    const auto part = static_cast<double>(plane.normal[axis]);
    if (part == 0) continue;
    const std::string sign = part < 0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
    const std::string factor = std::abs(part) == 1 ? "" : number_text(std::abs(part)) + " ";
    text += sign + factor + "xyz"[axis];
  }
  return text + " = " + number_text(static_cast<double>(plane.offset), digits);
}

template std::string box_text<2>(const Box<2>&);
template std::string box_text<3>(const Box<3>&);
template std::string box_text<2>(const GivenBox<2>&, const GivenBox<2>&);
template std::string box_text<3>(const GivenBox<3>&, const GivenBox<3>&);
template std::string plane_text<2>(const Plane<2>&, int);
template std::string plane_text<3>(const Plane<3>&, int);

}  // namespace kerf
