#pragma once

#include <array>

#include "viz/image/image.h"

/// The colour spaces of FLIP (Andersson et al. 2020, sections 4.1 and 5), for the illuminant D65.
namespace kerf::flip_color {

using Triple = std::array<float, 3>;

/// A pixel of an 8-bit sRGB picture, laid over white, in linear RGB from 0 to 1.
Triple linear_rgb(const std::uint8_t* rgba);
/// YCxCz, a linear opponent space: luminance, red against green, blue against yellow.
Triple ycxcz(const Triple& linear_rgb);
Triple linear_rgb_of_ycxcz(const Triple& ycxcz);
/// CIELAB with its chroma scaled by lightness (Hunt's effect).
Triple hunt_lab(const Triple& linear_rgb);
/// Distance of two colours in L*a*b* (Abasi et al. 2020): lightness and chroma are added.
float hyab(const Triple& a, const Triple& b);

}  // namespace kerf::flip_color
