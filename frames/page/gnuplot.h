#pragma once

#include <string>
#include <string_view>

namespace kerf {

/// A text as gnuplot has it, in quotes.
std::string in_quotes(std::string_view text);
/// The shortest text that gives the number back.
std::string plot_number(double x);

/// Throws std::runtime_error, saying what to install, if there is no gnuplot: before hours are spent on
/// figures that nobody can draw.
void require_gnuplot();

/// Has gnuplot run the script; false if it does not take it. What it says on the way is not shown.
bool feed_gnuplot(const std::string& script);

/// The picture that a script draws, of so many pixels, as an SVG element for a page in which `id` is unlike
/// all others. The script is told no terminal and no output. Throws std::runtime_error if gnuplot does not
/// take the script.
std::string run_gnuplot(const std::string& script, int width, int height, std::string_view id);

}  // namespace kerf
