#pragma once

#include <string>
#include <string_view>

namespace kerf {

/// A text quoted for gnuplot.
std::string in_quotes(std::string_view text);
/// The shortest text that reads back as the number.
std::string plot_number(double x);

/// Throws std::runtime_error, saying what to install, if there is no gnuplot. Call it before hours are spent
/// on figures that cannot be drawn.
void require_gnuplot();

/// Runs a script in gnuplot; false if gnuplot refuses it. Its output is discarded.
bool feed_gnuplot(const std::string& script);

/// The picture of a script, of so many pixels, as an SVG element for a page in which `id` is unique. The
/// script sets neither terminal nor output. Throws std::runtime_error if gnuplot refuses the script.
std::string run_gnuplot(const std::string& script, int width, int height, std::string_view id);

}  // namespace kerf
