#include "core/query/text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace kerf {

std::string number_text(double x) {
  std::array<char, 32> text{};
  const int size = std::snprintf(text.data(), text.size(), "%g", x);
  return {text.data(), static_cast<std::size_t>(size)};
}

std::string node_text(NodeId node) { return "n" + std::to_string(node.value); }

std::string sides_text(const Sides& sides) {
  if (sides.straddle()) return "both sides";
  return sides.left ? "left" : "right";
}

std::string interval_text(const Interval& interval) {
  return "[" + number_text(static_cast<double>(interval.lo)) + ", " +
         number_text(static_cast<double>(interval.hi)) + "]";
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
std::string plane_text(const Plane<D>& plane) {
  std::string text;
  for (int axis = 0; axis < D; ++axis) {
    const auto part = static_cast<double>(plane.normal[axis]);
    if (part == 0) continue;
    const std::string sign = part < 0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
    const std::string factor = std::abs(part) == 1 ? "" : number_text(std::abs(part)) + " ";
    text += sign + factor + "xyz"[axis];
  }
  return text + " = " + number_text(static_cast<double>(plane.offset));
}

template std::string box_text<2>(const Box<2>&);
template std::string box_text<3>(const Box<3>&);
template std::string plane_text<2>(const Plane<2>&);
template std::string plane_text<3>(const Plane<3>&);

}  // namespace kerf
