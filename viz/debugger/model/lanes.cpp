#include "viz/debugger/model/lanes.h"

#include <algorithm>
#include <numeric>

namespace kerf {
namespace {

std::uint64_t operators(const StepRow& row) {
  return std::accumulate(row.statistics.operators.begin(), row.statistics.operators.end(), std::uint64_t{0});
}

}  // namespace

std::vector<Lane> make_lanes(std::span<const StepRow> rows) {
  std::vector<Lane> lanes;
  const auto add = [&](std::string_view name, auto value) {
    Lane lane{name, {}, 0};
    for (std::size_t k = 0; k < rows.size(); ++k) lane.values.push_back(static_cast<float>(value(k)));
    for (const float x : lane.values) lane.largest = std::max(lane.largest, x);
    lanes.push_back(std::move(lane));
  };
  add("operators", [&](std::size_t k) { return operators(rows[k]) - (k > 0 ? operators(rows[k - 1]) : 0); });
  add("pairs", [&](std::size_t k) { return rows[k].pairs; });
  add("height", [&](std::size_t k) { return rows[k].statistics.height; });
  add("redundancy %", [&](std::size_t k) { return 100 * rows[k].statistics.redundancy; });
  add("step ms", [&](std::size_t k) { return 1e3 * rows[k].seconds(); });
  add("deferred", [&](std::size_t k) { return rows[k].statistics.deferred; });
  return lanes;
}

std::vector<ColumnRange> columns_of(const Lane& lane, std::size_t columns) {
  std::vector<ColumnRange> result;
  const std::size_t count = lane.values.size();
  if (count == 0) return result;
  for (std::size_t column = 0; column < columns; ++column) {
    const std::size_t first = std::min(column * count / columns, count - 1);
    const std::size_t last = std::max(first + 1, (column + 1) * count / columns);
    const auto [least, greatest] =
        std::minmax_element(lane.values.begin() + static_cast<std::ptrdiff_t>(first),
                            lane.values.begin() + static_cast<std::ptrdiff_t>(last));
    result.push_back({*least, *greatest});
  }
  return result;
}

}  // namespace kerf
