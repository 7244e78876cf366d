#pragma once

#include <string>
#include <vector>

#include "viz/draw/draw_list.h"

namespace kerf {

/// The changes between two pictures in words, the gravest first: "plane n17 missing", "pair 12-77 recoloured
/// from #d55e00 to #141414", "plane n3 moved by (1.0, 0.0) pixels". Empty: the same was drawn at the same
/// place. Rasterisers may round edges differently: items of a few pixels may be visible or not, and borders
/// may lie a pixel apart. Throws std::invalid_argument if the sizes differ.
std::vector<std::string> compare_drawn(const FrameIds& reference, const FrameIds& test);

/// The ids of two pictures combined: grey where they agree, red where an item of the reference is gone, blue
/// where one has come, violet where one took another's place.
Image id_difference(const FrameIds& reference, const FrameIds& test);

}  // namespace kerf
