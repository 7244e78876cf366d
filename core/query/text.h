#pragma once

#include <string>

#include "core/base/ids.h"
#include "core/geometry/box.h"
#include "core/geometry/plane.h"

namespace kerf {

/// A number with up to six digits, as printf's %g.
std::string number_text(double x);
/// "n17"
std::string node_text(NodeId node);
/// "left", "right" or "both sides"
std::string sides_text(const Sides& sides);
/// "[0, 1]"
std::string interval_text(const Interval& interval);
/// "x [0, 1]  y [2, 3]"
template <int D>
std::string box_text(const Box<D>& box);
/// "0.6 x + 0.8 y = 3.5"
template <int D>
std::string plane_text(const Plane<D>& plane);

}  // namespace kerf
