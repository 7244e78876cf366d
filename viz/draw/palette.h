#pragma once

#include <array>
#include <cstdint>

#include "viz/draw/color.h"

/// The colours of a frame. Categories are from Okabe and Ito's set, populations from the middle of viridis:
/// both can be distinguished with any kind of colour vision, on the light ground and, where it matters, in
/// greyscale.
namespace kerf::palette {

inline constexpr Color kGround{250, 250, 247};
inline constexpr Color kInk{25, 25, 25};
inline constexpr Color kFaintInk{110, 110, 110};
inline constexpr Color kPanel{238, 238, 233};

inline constexpr Color kMoving{86, 180, 233};      // sky blue
inline constexpr Color kFixed{168, 166, 160};      // warm grey, no hue
inline constexpr Color kStraddler{255, 255, 255};  // white: lighter than any population
inline constexpr Color kPartitioner{0, 114, 178};  // blue
inline constexpr Color kCandidate{213, 94, 0};     // vermillion, dashed
inline constexpr Color kContact{20, 20, 20};       // black, solid, with a marker
inline constexpr Color kOperator{204, 0, 120};     // a strong relative of reddish purple

inline constexpr Color kMissed{230, 0, 0};   // an error, edged in ink: an overlap that was not reported
inline constexpr Color kExtra{255, 214, 0};  // an error, edged in ink: a pair that is none

/// The lines of a plot, the easiest to distinguish first: Okabe and Ito's set, black last.
inline constexpr std::array<Color, 8> kSeries{{{0, 114, 178},
                                               {213, 94, 0},
                                               {0, 158, 115},
                                               {204, 121, 167},
                                               {230, 159, 0},
                                               {86, 180, 233},
                                               {120, 120, 120},
                                               {20, 20, 20}}};

/// What is selected, of the tree.
inline constexpr Color kSelected{180, 112, 0};

/// The lanes of the debugger: the lines of a plot, dark enough for small marks on white.
inline constexpr std::array<Color, 6> kLanes{
    {kSeries[0], kSeries[1], {0, 145, 105}, {190, 90, 150}, kSelected, {30, 140, 200}}};

/// Colour of a leaf's population, 0 to `largest`: blue to light green.
Color population_color(std::uint32_t population, std::uint32_t largest);

}  // namespace kerf::palette
