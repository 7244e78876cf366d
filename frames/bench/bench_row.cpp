#include "frames/bench/bench_row.h"

#include <algorithm>
#include <cmath>

namespace kerf {

RoundRatio ratio_of_rounds(const BenchRow& row, const BenchRow& base) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < std::min(row.round_ns.size(), base.round_ns.size()); ++k)
    ratios.push_back(row.round_ns[k] / base.round_ns[k]);
  std::ranges::sort(ratios);
  return {percentile(ratios, 0.5), ratios.front(), ratios.back()};
}

double median_round(const BenchRow& row) {
  std::vector<double> rounds = row.round_ns;
  std::ranges::sort(rounds);
  return percentile(rounds, 0.5);
}

void set_times(BenchRow& row, std::vector<double> each) {
  std::ranges::sort(each);
  row.median_ns = percentile(each, 0.5);
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
