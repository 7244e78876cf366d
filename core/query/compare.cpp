#include "core/query/compare.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace kerf {
namespace {

RecordingSummary summary(std::span<const StepRow> rows) {
  RecordingSummary result;
  result.steps = static_cast<std::uint32_t>(rows.size());
  if (rows.empty()) return result;
  result.operators = rows.back().statistics.operators;
  result.refused = rows.back().statistics.refused;
  std::vector<double> times;
  for (const StepRow& row : rows) {
    result.pairs += row.pairs;
    result.height = std::max(result.height, row.statistics.height);
    result.redundancy += row.statistics.redundancy / static_cast<double>(rows.size());
    times.push_back(1e3 * row.seconds());
  }
  std::ranges::sort(times);
  result.milliseconds = times[times.size() / 2];
  result.most_milliseconds = times.back();
  return result;
}

/// The same bits: NaN equals itself.
template <int D>
bool same_boxes(const std::vector<Box<D>>& a, const std::vector<Box<D>>& b) {
  return std::ranges::equal(a, b, [](const Box<D>& x, const Box<D>& y) {
    for (int axis = 0; axis < D; ++axis)
      if (std::bit_cast<std::uint32_t>(x.min[axis]) != std::bit_cast<std::uint32_t>(y.min[axis]) ||
          std::bit_cast<std::uint32_t>(x.max[axis]) != std::bit_cast<std::uint32_t>(y.max[axis]))
        return false;
    return true;
  });
}

template <int D>
bool same_requests(const StepRequests<D>& a, const StepRequests<D>& b) {
  return a.calls == b.calls && a.objects == b.objects && same_boxes(a.boxes, b.boxes) && a.extra == b.extra;
}

void compare_events(const std::vector<Event>& a, const std::vector<Event>& b, std::uint32_t step,
                    RecordingComparison& result) {
  const auto [in_a, in_b] =
      std::ranges::mismatch(a, b, [](const Event& x, const Event& y) { return x.body == y.body; });
  if (in_a == a.end() && in_b == b.end()) return;
  result.events = step;
  if (in_a != a.end()) result.a_event = describe(*in_a);
  if (in_b != b.end()) result.b_event = describe(*in_b);
}

}  // namespace

template <int D>
RecordingComparison compare(RecordingReader<D>& a, RecordingReader<D>& b) {
  RecordingComparison result{summary(a.rows()), summary(b.rows()), {}, {}, {}, {}, {}, {}};
  for (std::uint32_t step = 1; step <= std::min(a.steps(), b.steps()); ++step) {
    if (!result.state && a.row(step).state_hash != b.row(step).state_hash) result.state = step;
    if (!result.pairs && a.row(step).pairs_hash != b.row(step).pairs_hash) result.pairs = step;
    if (!result.requests && !same_requests(a.step(step).requests, b.step(step).requests))
      result.requests = step;
    if (!result.events) compare_events(a.step(step).events, b.step(step).events, step, result);
    if (result.state && result.pairs && result.requests && result.events) break;
  }
  return result;
}

template RecordingComparison compare<2>(RecordingReader<2>&, RecordingReader<2>&);
template RecordingComparison compare<3>(RecordingReader<3>&, RecordingReader<3>&);

}  // namespace kerf
