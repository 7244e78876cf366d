#pragma once

#include <span>
#include <vector>

#include "viz/draw/overlay.h"

/// Items set one after the other into lines, like words.
namespace kerf::flow {

struct Spot {
  int x = 0;
  int line = 0;
};

/// Space between a band's border and its letters.
int padding(const Font& font);

struct Piece {
  int width = 0;
  bool begins_line = false;
};

/// Begins a new line where a piece asks for it and before each piece that would cross `right`.
std::vector<Spot> arrange(std::span<const Piece> pieces, int gap, int left, int right);
int lines(std::span<const Spot> spots);
/// Of a band that has so many lines.
int band_height(const Font& font, int lines);

/// What stands behind the last piece that has room.
inline constexpr const char* kMore = "...";

/// The pieces that have room, the first ones, and a spot for `kMore` where these are not all.
struct Fitted {
  std::size_t shown = 0;
  std::vector<Spot> spots;
};

std::vector<Piece> pieces_of(const Font& font, std::span<const CaptionItem> items);
std::vector<Piece> pieces_of(const Font& font, std::span<const LegendItem> items);
/// Pieces across the picture, with two letters between them.
std::vector<Spot> arrange_across(const Font& font, int picture_width, std::span<const Piece> pieces);
Fitted fit_across(const Font& font, int picture_width, int lines, std::span<const Piece> pieces);

}  // namespace kerf::flow
