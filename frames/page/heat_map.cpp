#include "frames/page/gnuplot.h"
#include "frames/page/plot.h"
#include "frames/page/plot_parts.h"

namespace kerf {
namespace {

// Pixels.
constexpr int kCell = 22;
constexpr int kNames = 270;
constexpr int kHeads = 210;
constexpr int kKey = 120;
constexpr int kFoot = 20;

/// The places of all cells of one kind.
std::string data_of(const HeatMap& map, int kind) {
  std::string data;
  for (std::size_t row = 0; row < map.rows.size(); ++row)
    for (std::size_t column = 0; column < map.columns.size(); ++column)
      if (map.kinds[row][column] == kind) data += std::to_string(column) + " " + std::to_string(row) + "\n";
  return data;
}

std::string axes_script(const HeatMap& map, int width, int height) {
  const std::string last_column = plot_number(static_cast<double>(map.columns.size()) - 0.5);
  const std::string last_row = plot_number(static_cast<double>(map.rows.size()) - 0.5);
  return "set lmargin" + at_pixel(kNames, width) + "\nset rmargin" + at_pixel(width - kKey, width) +
         "\nset tmargin" + at_pixel(height - kHeads, height) + "\nset bmargin" + at_pixel(kFoot, height) +
         "\nset xrange [-0.5:" + last_column + "]\nset x2range [-0.5:" + last_column + "]\nset yrange [" +
         last_row + ":-0.5]\nunset xtics\nset x2tics scale 0 rotate by 60 " + names_as_tics(map.columns) +
         "\nset ytics scale 0 " + names_as_tics(map.rows) +
         "\nset style fill solid noborder\nset key outside right top Left reverse samplen 1\n";
}

}  // namespace

std::string draw(const HeatMap& map, std::string_view id) {
  const int width = kNames + kKey + kCell * static_cast<int>(map.columns.size());
  const int height = kHeads + kFoot + kCell * static_cast<int>(map.rows.size());
  std::string script = axes_script(map, width, height);
  std::string what;
  for (std::size_t kind = 0; kind < map.kind_names.size(); ++kind) {
    const std::string data = data_of(map, static_cast<int>(kind));
    if (data.empty()) continue;
    const std::string name = "$k" + std::to_string(kind);
    script += name + " << EOD\n" + data + "EOD\n";
    what += (what.empty() ? "plot " : ", ") + name + " using 1:2:(0.46):(0.46) with boxxyerror lc rgb " +
            series_color(kind) + " title " + in_quotes(map.kind_names[kind]);
  }
  return run_gnuplot(script + what, width, height, id);
}

}  // namespace kerf
