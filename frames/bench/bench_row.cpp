#include "frames/bench/bench_row.h"

#include <algorithm>
#include <cmath>

#include "core/base/median.h"

namespace kerf {

RoundRatio ratio_of_rounds(const BenchRow& row, const BenchRow& base) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < std::min(row.round_ns.size(), base.round_ns.size()); ++k)
    ratios.push_back(row.round_ns[k] / base.round_ns[k]);
  const auto [least, most] = std::ranges::minmax(ratios);
  return {median(ratios), least, most};
}

double median_round(const BenchRow& row) { return median(row.round_ns); }

void share_among(BenchRow& row, std::uint32_t objects) {
  const double factor = double{1} * row.cell.objects / objects;
  row.cell.objects = objects;
  for (double* const time :
       {&row.median_ns, &row.p90_ns, &row.p99_ns, &row.max_ns, &row.native_ns, &row.build_ns})
    *time *= factor;
  for (double& time : row.round_ns) time *= factor;
  for (float& time : row.step_ns) time *= static_cast<float>(factor);
}

void set_times(BenchRow& row, std::vector<double> each) {
  std::ranges::sort(each);
  row.median_ns = median(each);
  row.p90_ns = percentile(each, 0.9);
  row.p99_ns = percentile(each, 0.99);
  row.max_ns = each.empty() ? 0 : each.back();
}

double percentile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

}  // namespace kerf
