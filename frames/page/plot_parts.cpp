#include "frames/page/plot_parts.h"

#include <array>
#include <cstdio>

#include "frames/page/gnuplot.h"
#include "viz/draw/palette.h"

namespace kerf {

std::string series_hex(std::size_t k) {
  const Color& color = palette::kSeries[k % palette::kSeries.size()];
  std::array<char, 10> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", color.r, color.g, color.b);
  return text.data();
}

std::string series_color(std::size_t k) { return "'" + series_hex(k) + "'"; }

std::string at_pixel(double pixels, double of) { return " at screen " + plot_number(pixels / of); }

std::string frame_script(const std::string& title, const std::string& x_label) {
  return "set title " + in_quotes(title) + "\nset xlabel " + in_quotes(x_label) +
         "\nset border lc rgb '#555555'\nset grid lc rgb '#e4e4e0' lt 1\n";
}

std::string names_as_tics(const std::vector<std::string>& names) {
  std::string text = "(";
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : ", ") + in_quotes(names[k]) + " " + std::to_string(k);
  return text + ")";
}

}  // namespace kerf
