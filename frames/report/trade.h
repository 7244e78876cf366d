#pragma once

#include <string>
#include <vector>

#include "frames/page/cell.h"
#include "frames/page/plot.h"

namespace kerf {

/// Two figures of rows, of which less is better: what a plot of speed against error has on its axes.
struct Trade {
  std::string error;  ///< key of the rows
  std::string time;   ///< key of the rows
  double error_scale = 1;
  std::string error_label;
  std::string time_label;
};

/// The family of what is shown beside settings and is none: it is never on a front.
inline constexpr const char* kControl = "control";

/// Which rows are on the Pareto front.
std::vector<bool> front_of(const Json& rows, const Trade& trade);
/// The rows as a plot: a series for each "family", rows on the front marked and labelled with their
/// "setting"; those of approximate families are joined. Both axes are logarithmic. If they are some of the
/// rows of another plot, `all` are its rows, and families look as they do there.
Plot plot_of(const Json& rows, const Trade& trade, const std::string& title, const Json& all = {});
/// Of the rows with at most so much error the first that is within a twentieth of the fastest: who recommends
/// does not tell noise from gain. Null if there is none.
Json recommended_within(const Json& rows, const Trade& trade, double most_error);
/// A setting as a label: without what all have.
std::string short_name(const std::string& setting);

}  // namespace kerf
