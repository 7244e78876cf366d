#pragma once

#include <initializer_list>
#include <string>

#include "core/base/ids.h"
#include "core/geometry/box.h"
#include "core/geometry/given_box.h"
#include "core/geometry/plane.h"

namespace kerf {

inline constexpr int kDigits = 6;
/// A number with up to so many digits, as printf's %g.
std::string number_text(double x, int digits = kDigits);
/// How many digits, six at least, make numbers that differ look different.
int digits_apart(std::initializer_list<double> numbers);
/// "n17"
std::string node_text(NodeId node);
/// "left", "right" or "both sides"
std::string sides_text(const Sides& sides);
/// "[0, 1]"
std::string interval_text(const Interval& interval, int digits = kDigits);
/// "x [0, 1]  y [2, 3]"
template <int D>
std::string box_text(const Box<D>& box);
/// With as many digits as distinguish its bounds from those of another box.
template <int D>
std::string box_text(const GivenBox<D>& box, const GivenBox<D>& beside);
/// "0.6 x + 0.8 y = 3.5"
template <int D>
std::string plane_text(const Plane<D>& plane, int digits = kDigits);

}  // namespace kerf
