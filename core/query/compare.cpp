#include "core/query/compare.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/trace/event_facts.h"

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

std::optional<EventDifference> first_difference(const std::vector<Event>& a, const std::vector<Event>& b,
                                                bool (*counts)(const Event&)) {
  auto in_a = a.begin();
  auto in_b = b.begin();
  for (;; ++in_a, ++in_b) {
    in_a = std::find_if(in_a, a.end(), counts);
    in_b = std::find_if(in_b, b.end(), counts);
    if (in_a == a.end() || in_b == b.end() || in_a->body != in_b->body) break;
  }
  if (in_a == a.end() && in_b == b.end()) return std::nullopt;
  EventDifference difference;
  if (in_a != a.end()) difference.a = *in_a;
  if (in_b != b.end()) difference.b = *in_b;
  difference.step = difference.a ? difference.a->step : difference.b->step;
  return difference;
}

bool is_event(const Event& /*any*/) { return true; }

}  // namespace

template <int D>
RecordingComparison compare(RecordingReader<D>& a, RecordingReader<D>& b) {
  RecordingComparison result{summary(a.rows()), summary(b.rows()), {}, {}, {}, {}, {}};
  for (std::uint32_t step = 1; step <= std::min(a.steps(), b.steps()); ++step) {
    if (!result.state && a.row(step).state_hash != b.row(step).state_hash) result.state = step;
    if (!result.pairs && a.row(step).pairs_hash != b.row(step).pairs_hash) result.pairs = step;
    if (!result.requests && !same_requests(a.step(step).requests, b.step(step).requests))
      result.requests = step;
    const auto differs = [&](bool (*counts)(const Event&)) {
      return first_difference(a.step(step).events, b.step(step).events, counts);
    };
    if (!result.events) result.events = differs(is_event);
    if (result.events && !result.operators) result.operators = differs(is_outcome);
    if (result.state && result.pairs && result.requests && result.operators) break;
  }
  return result;
}

template RecordingComparison compare<2>(RecordingReader<2>&, RecordingReader<2>&);
template RecordingComparison compare<3>(RecordingReader<3>&, RecordingReader<3>&);

}  // namespace kerf
