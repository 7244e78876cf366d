#pragma once

#include <Eigen/Core>

#include "viz/draw/camera.h"
#include "viz/draw/color.h"

namespace kerf {

/// Unit, towards the light: it comes from above, over the viewer's left shoulder.
Eigen::Vector3d light_of(const View& view);

/// A face's colour in that light; `cosine`: of the angle between its normal and the light.
Color lit_face(Color color, double cosine);

/// How much of its colour a thing keeps: what is far away in the framed box fades a little into the ground.
double clearness(const View& view, const Eigen::Vector3d& point);

}  // namespace kerf
