#include "viz/debugger/model/lanes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kerf {
namespace {

/// A scale is clipped if its end would be more than so many times the 99th percentile.
constexpr float kOutlier = 2;

std::uint64_t operators(const StepRow& row) {
  return std::accumulate(row.statistics.operators.begin(), row.statistics.operators.end(), std::uint64_t{0});
}

/// The least value that is not exceeded by more than a hundredth of them. Reorders them.
float percentile_99(std::vector<float>& values) {
  const std::size_t rank = values.size() - 1 - values.size() / 100;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::ranges::nth_element(values, place);
  return *place;
}

}  // namespace

Lane::Lane(std::string_view name, std::vector<float> values)
    : name_(name), values_(std::move(values)), pyramid_(values_) {
  sums_.reserve(values_.size() + 1);
  sums_.push_back(0);
  for (const float x : values_) sums_.push_back(sums_.back() + (std::isfinite(x) ? double{x} : 0));
  find_extremes();
  find_outliers();
}

void Lane::find_extremes() {
  const LaneRange all = pyramid_.range(0, values_.size());
  if (all.is_absent()) return;
  const auto first_with = [&](float value) {
    return static_cast<std::uint32_t>(std::ranges::find(values_, value) - values_.begin()) + 1;
  };
  least_step_ = first_with(all.least);
  greatest_step_ = first_with(all.greatest);
  greatest_ = clipped_end_ = std::max(0.0F, all.greatest);
}

void Lane::find_outliers() {
  std::vector<float> present;
  std::ranges::copy_if(values_, std::back_inserter(present), [](float x) { return std::isfinite(x); });
  if (present.empty()) return;
  const float end = percentile_99(present);
  if (end <= 0 || greatest_ <= kOutlier * end) return;
  clipped_end_ = end;
  above_ = static_cast<std::size_t>(std::ranges::count_if(present, [&](float x) { return x > end; }));
}

std::optional<double> Lane::value(std::uint32_t step) const {
  if (step == 0 || step > values_.size() || !std::isfinite(values_[step - 1])) return std::nullopt;
  return double{values_[step - 1]};
}

LaneRange Lane::range(std::uint32_t first, std::uint32_t last) const {
  return pyramid_.range(std::max(1U, first) - 1, last);
}

double Lane::sum(std::uint32_t first, std::uint32_t last) const {
  const std::size_t end = std::min<std::size_t>(last, values_.size());
  const std::size_t begin = std::min<std::size_t>(std::max(1U, first) - 1, end);
  return end == 0 ? 0 : sums_[end] - sums_[begin];
}

const std::vector<LaneRange>& Lane::columns(const TimeWindow& window, std::size_t columns) const {
  auto& [kept_window, ranges] = columns_[window.shows_all() ? 0 : 1];
  if (kept_window == window && ranges.size() == columns) return ranges;
  kept_window = window;
  ranges.resize(columns);
  for (std::size_t k = 0; k < columns; ++k) {
    const TimeWindow::Column column = window.column(k, columns);
    ranges[k] = pyramid_.range(column.before, column.last);
  }
  return ranges;
}

std::vector<Lane> make_lanes(std::span<const StepRow> rows) {
  std::vector<Lane> lanes;
  const auto add = [&](std::string_view name, auto value) {
    std::vector<float> values;
    values.reserve(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) values.push_back(static_cast<float>(value(k)));
    lanes.emplace_back(name, std::move(values));
  };
  add("operators", [&](std::size_t k) { return operators(rows[k]) - (k > 0 ? operators(rows[k - 1]) : 0); });
  add("pairs", [&](std::size_t k) { return rows[k].pairs; });
  add("height", [&](std::size_t k) { return rows[k].statistics.height; });
  add("redundancy %", [&](std::size_t k) { return 100 * rows[k].statistics.redundancy; });
  add("step ms", [&](std::size_t k) { return 1e3 * rows[k].seconds(); });
  add("deferred", [&](std::size_t k) { return rows[k].statistics.deferred; });
  return lanes;
}

}  // namespace kerf
