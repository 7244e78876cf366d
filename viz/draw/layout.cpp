#include <algorithm>

#include "viz/draw/flow.h"
#include "viz/draw/overlay.h"

namespace kerf {
namespace {

/// Of the picture's height; the rest belongs to the scene.
constexpr double kMostCaption = 0.34;
constexpr double kMostLegend = 0.22;

int most_lines(const Font& font, int height, double part) {
  return static_cast<int>(part * height) / font.line_height();
}

}  // namespace

namespace flow {

int padding(const Font& font) { return std::max(3, font.line_height() / 4); }

std::vector<Spot> arrange(std::span<const Piece> pieces, int gap, int left, int right) {
  std::vector<Spot> spots;
  Spot next{left, 0};
  for (const Piece& piece : pieces) {
    if (next.x > left && (piece.begins_line || next.x + piece.width > right)) next = {left, next.line + 1};
    spots.push_back(next);
    next.x += piece.width + gap;
  }
  return spots;
}

int lines(std::span<const Spot> spots) { return spots.empty() ? 0 : spots.back().line + 1; }

int band_height(const Font& font, int lines) {
  return lines == 0 ? 0 : lines * font.line_height() + 2 * padding(font);
}

std::vector<Spot> arrange_across(const Font& font, int picture_width, std::span<const Piece> pieces) {
  return arrange(pieces, 2 * font.advance(), padding(font), picture_width - padding(font));
}

Fitted fit_across(const Font& font, int picture_width, int lines, std::span<const Piece> pieces) {
  Fitted fitted{pieces.size(), arrange_across(font, picture_width, pieces)};
  std::vector<Piece> kept(pieces.begin(), pieces.end());
  while (fitted.shown > 0 && flow::lines(fitted.spots) > lines) {
    kept.resize(--fitted.shown);
    kept.push_back({font.width(kMore)});
    fitted.spots = arrange_across(font, picture_width, kept);
  }
  return fitted;
}

}  // namespace flow

int font_pixels(int picture_height) { return std::clamp(picture_height / 40, 11, 128); }

Layout make_layout(const Font& font, int width, int height, const std::vector<CaptionItem>& caption,
                   bool has_log, const std::vector<LegendItem>& legend) {
  const int caption_lines =
      flow::lines(flow::arrange_across(font, width, flow::pieces_of(font, caption))) + (has_log ? 1 : 0);
  const int legend_lines = flow::lines(flow::arrange_across(font, width, flow::pieces_of(font, legend)));
  Layout layout;
  layout.caption_height =
      flow::band_height(font, std::min(caption_lines, most_lines(font, height, kMostCaption)));
  layout.legend_height =
      flow::band_height(font, std::min(legend_lines, most_lines(font, height, kMostLegend)));
  layout.scene = {0, static_cast<double>(layout.caption_height), static_cast<double>(width),
                  static_cast<double>(height - layout.caption_height - layout.legend_height)};
  return layout;
}

}  // namespace kerf
