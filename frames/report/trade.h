#pragma once

#include <string>
#include <vector>

#include "frames/page/cell.h"
#include "frames/page/plot.h"

namespace kerf {

/// The two figures of rows on the axes of a plot of speed against error; less is better.
struct Trade {
  std::string error;  ///< key of the rows
  std::string time;   ///< key of the rows
  double error_scale = 1;
  std::string error_label;
  std::string time_label;
};

/// The family of rows that are shown for comparison and are no settings: they are never on a front.
inline constexpr const char* kControl = "control";

/// Where a row has what its figure spreads over, if it does.
std::string low_key(const std::string& figure);
std::string high_key(const std::string& figure);

/// For each row whether it is on the Pareto front.
std::vector<bool> front_of(const Json& rows, const Trade& trade);
/// The rows as a plot: a series for each "family", rows on the front marked and labelled with their
/// "setting"; those of approximate families are joined. Both axes are logarithmic. If they are some of the
/// rows of another plot, `all` are its rows, and families look as they do there.
Plot plot_of(const Json& rows, const Trade& trade, const std::string& title, const Json& all = {});
/// The fastest row with at most so much error. The first row, kerf as it is, if it has no more error and is
/// within a twentieth of the fastest: smaller gains are noise. Null if there is none.
Json recommended_within(const Json& rows, const Trade& trade, double most_error);
/// A setting as a label: without the part that all have in common.
std::string short_name(const std::string& setting);

}  // namespace kerf
