#pragma once

#include <span>
#include <vector>

#include "viz/draw/draw_context.h"
#include "viz/draw/panes.h"

namespace kerf {

/// The language of all structures: a cell's outline has the colour of its depth, its area that of how many
/// objects it holds, on a logarithmic ramp that ends at kFullCell; what siblings share is darkened.
inline constexpr std::uint32_t kDeepCell = 12;
inline constexpr std::uint32_t kFullCell = 64;
Color depth_color(std::uint32_t depth);
Color fill_color(std::uint32_t objects);
inline constexpr Color kSiblingOverlap{204, 0, 120};
inline constexpr Color kRejectedTest{95, 95, 95};
inline constexpr Color kAxisStrip{0, 114, 178};

/// By object: grey if fixed, white in several cells; in 3D by the fullest cell.
template <int D>
std::vector<Color> object_colors(const StructureParts<D>& parts, std::span<const Body<D>> bodies);

/// Cells filled by what they hold, and what siblings share.
void draw_cell_areas(const DrawContext<2>& context, const StructureParts<2>& parts, Batch& batch);
/// Their outlines: what is cut by planes has these, other cells their boxes.
template <int D>
void draw_cell_outlines(const DrawContext<D>& context, const StructureParts<D>& parts, Batch& batch);

/// Tests that found no pair, dim.
template <int D>
void draw_rejected(const DrawContext<D>& context, std::span<const Pair> rejected, Batch& batch);

}  // namespace kerf
