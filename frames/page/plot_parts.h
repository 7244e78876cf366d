#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace kerf {

// Lines of gnuplot scripts that several kinds of plots share.

/// The k-th colour of a plot, "#0072b2"; see viz/draw/palette.h.
std::string series_hex(std::size_t k);
/// The same in gnuplot's quotes.
std::string series_color(std::size_t k);
/// " at screen X": a place in pixels, of `of` pixels.
std::string at_pixel(double pixels, double of);
/// Title, label, border and grid.
std::string frame_script(const std::string& title, const std::string& x_label);
/// Names as tics at 0, 1, 2 and so on.
std::string names_as_tics(const std::vector<std::string>& names);

}  // namespace kerf
