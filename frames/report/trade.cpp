#include "frames/report/trade.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "frames/page/pareto.h"

namespace kerf {
namespace {

double error_of(const Json& row, const Trade& trade) {
  return row.at(trade.error).get<double>() * trade.error_scale;
}

double time_of(const Json& row, const Trade& trade) { return row.at(trade.time).get<double>(); }

PlotSeries& series_of(Plot& plot, const std::string& family) {
  const auto found = std::find_if(plot.series.begin(), plot.series.end(),
                                  [&](const PlotSeries& series) { return series.name == family; });
  if (found != plot.series.end()) return *found;
  const bool in_order = family.starts_with("every") || family.starts_with("rounded");
  plot.series.push_back({family, {}, in_order ? PlotStyle::joined : PlotStyle::points, -1});
  return plot.series.back();
}

/// None if the row does not have it. The figure itself is always in it.
std::optional<PlotRange> range_of(const Json& row, const std::string& figure, double scale) {
  if (!row.contains(low_key(figure)) || !row.contains(high_key(figure))) return std::nullopt;
  const double value = row.at(figure).get<double>();
  return PlotRange{std::min(value, row.at(low_key(figure)).get<double>()) * scale,
                   std::max(value, row.at(high_key(figure)).get<double>()) * scale};
}

PlotPoint point_of(const Json& row, const Trade& trade, bool on_front) {
  const std::string setting = row.at("setting").get<std::string>();
  PlotPoint point{error_of(row, trade), time_of(row, trade), on_front ? short_name(setting) : "", on_front,
                  setting};
  point.x_range = range_of(row, trade.error, trade.error_scale);
  point.y_range = range_of(row, trade.time, 1);
  return point;
}

}  // namespace

std::string low_key(const std::string& figure) { return figure + "_low"; }
std::string high_key(const std::string& figure) { return figure + "_high"; }

std::vector<bool> front_of(const Json& rows, const Trade& trade) {
  std::vector<Cost> costs;
  constexpr double kNever = std::numeric_limits<double>::infinity();
  for (const Json& row : rows)
    costs.push_back(row.at("family") == kControl ? Cost{kNever, kNever}
                                                 : Cost{error_of(row, trade), time_of(row, trade)});
  return pareto_front(costs);
}

Plot plot_of(const Json& rows, const Trade& trade, const std::string& title, const Json& all) {
  Plot plot{title, trade.error_label, trade.time_label, true, true, {}};
  for (const Json& row : all) series_of(plot, row.at("family").get<std::string>());
  const std::vector<bool> front = front_of(rows, trade);
  for (std::size_t k = 0; k < rows.size(); ++k)
    series_of(plot, rows[k].at("family").get<std::string>())
        .points.push_back(point_of(rows[k], trade, front[k]));
  return plot;
}

Json recommended_within(const Json& rows, const Trade& trade, double most_error) {
  constexpr double kNoise = 1.05;
  double least = std::numeric_limits<double>::infinity();
  for (const Json& row : rows)
    if (error_of(row, trade) <= most_error) least = std::min(least, time_of(row, trade));
  const auto is_within = [&](const Json& row, double most_time) {
    return error_of(row, trade) <= most_error && time_of(row, trade) <= most_time;
  };
  if (!rows.empty() && is_within(rows.front(), kNoise * least)) return rows.front();
  for (const Json& row : rows)
    if (is_within(row, least)) return row;
  return {};
}

std::string short_name(const std::string& setting) {
  const std::size_t colon = setting.find(':');
  return colon == std::string::npos ? setting : setting.substr(colon + 1);
}

}  // namespace kerf
