#include <algorithm>

#include "frames/page/gnuplot.h"
#include "frames/page/plot.h"
#include "frames/page/plot_parts.h"
#include "frames/page/short_number.h"

namespace kerf {
namespace {

constexpr int kBarPlotWidth = 940;
constexpr int kRow = 26;
constexpr int kAround = 110;

/// Row, value, the end of the error bar, and both as text, which stands there.
std::string data_block(const BarPlot& plot) {
  std::string data = "$bars << EOD\n";
  for (std::size_t k = 0; k < plot.bars.size(); ++k) {
    const double value = plot.bars[k].value;
    const double most = std::max(value, plot.bars[k].most);
    data += std::to_string(k) + " " + plot_number(value) + " " + plot_number(most) + " \"" +
            short_number(value) + (most > value ? ", " + short_number(most) : "") + "\"\n";
  }
  return data + "EOD\n";
}

}  // namespace

std::string draw(const BarPlot& plot, std::string_view id) {
  double most = 0;
  std::vector<std::string> names;
  for (const BarPlot::Bar& bar : plot.bars) {
    most = std::max({most, bar.value, bar.most});
    names.push_back(bar.name);
  }
  const double end = most > 0 ? 1.25 * most : 1;
  const std::string script =
      frame_script(plot.title, plot.x_label) +
      "unset key\nunset grid\nset lmargin at screen 0.27\nset rmargin at screen 0.97\nset yrange [" +
      std::to_string(plot.bars.size()) + ":-1]\nset xrange [0:" + plot_number(end) +
      "]\nset style fill solid 0.85 noborder\nset ytics scale 0 " + names_as_tics(names) + "\n" +
      data_block(plot) + "plot $bars using ($2/2):1:(0):2:($1-0.36):($1+0.36) with boxxyerror lc rgb " +
      series_color(0) +
      ", $bars using 2:1:2:3 with xerrorbars ps 0 lw 1 lc rgb '#555555', $bars using 3:1:4 with labels left "
      "offset 0.5,0";
  return run_gnuplot(script, kBarPlotWidth, kAround + kRow * static_cast<int>(plot.bars.size()), id);
}

}  // namespace kerf
