#pragma once

#include <variant>

#include "viz/draw/camera.h"

namespace kerf {

/// What the user chose of a camera, in either dimension.
using AnyCamera = std::variant<CameraChoice<2>, CameraChoice<3>>;

}  // namespace kerf
