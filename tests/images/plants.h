#pragma once

#include <array>
#include <string_view>

#include "viz/draw/frame_renderer.h"

namespace kerf::test {

/// Bugs that a drawing can have, as they are planted into the triangles that are drawn.
enum class Plant { missing_plane, moved_plane, missing_pair, recolored_pair, leaf_tint, missing_box };
inline constexpr std::array kPlants{Plant::missing_plane,  Plant::moved_plane, Plant::missing_pair,
                                    Plant::recolored_pair, Plant::leaf_tint,   Plant::missing_box};

/// "a missing plane"
std::string_view describe(Plant plant);

/// What the plant falls on: of the things of its kind the one in the middle by visible pixels. Where no
/// leaves are drawn, a tint falls on an object.
Drawn victim(Plant plant, const FrameIds& ids);

/// Plants the bug into what a renderer draws. `width`, `height`: of the picture.
Tamper tamper(Plant plant, const Drawn& victim, int width, int height);

}  // namespace kerf::test
