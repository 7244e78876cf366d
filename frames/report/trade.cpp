#include "frames/report/trade.h"

#include <algorithm>
#include <limits>

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

}  // namespace

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
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::string label = front[k] ? short_name(rows[k].at("setting").get<std::string>()) : "";
    series_of(plot, rows[k].at("family").get<std::string>())
        .points.push_back({error_of(rows[k], trade), time_of(rows[k], trade), label, front[k]});
  }
  return plot;
}

Json recommended_within(const Json& rows, const Trade& trade, double most_error) {
  constexpr double kNoise = 1.05;
  double least = std::numeric_limits<double>::infinity();
  for (const Json& row : rows)
    if (error_of(row, trade) <= most_error) least = std::min(least, time_of(row, trade));
  for (const Json& row : rows)
    if (error_of(row, trade) <= most_error && time_of(row, trade) <= kNoise * least) return row;
  return {};
}

std::string short_name(const std::string& setting) {
  const std::size_t colon = setting.find(':');
  return colon == std::string::npos ? setting : setting.substr(colon + 1);
}

}  // namespace kerf
