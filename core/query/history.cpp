#include "core/query/history.h"

#include "core/base/float_mode.h"
#include "core/replay/judge_theirs.h"

namespace kerf {
namespace {

/// Makes the calls of a step for one of two objects, and returns whether there was one.
template <int D>
bool apply_those_of(const StepRequests<D>& requests, const Pair& pair, ObjectTable<D>& table) {
  bool changed = false;
  for_each_request(requests, table.kind(), [&](const ObjectRequest<D>& request) {
    if (request.object != pair.a && request.object != pair.b) return;
    changed = true;
    apply(request, table);
  });
  return changed;
}

}  // namespace

template <int D>
std::vector<PairChange> pair_history(RecordingReader<D>& recording, const Pair& pair, std::uint32_t up_to) {
  const DefaultFloats floats;
  std::vector<PairChange> history;
  ObjectTable<D> table(recording.info().volume);
  bool was = false;
  for (std::uint32_t step = 1; step <= up_to; ++step) {
    if (!apply_those_of(recording.step(step).requests, pair, table)) continue;
    const bool is = table.is_placed(pair.a) && table.is_placed(pair.b) && table.is_pair(pair.a, pair.b) &&
                    (!recording.info().imported || overlap_as_given(recording, step, table, pair));
    if (is != was) history.push_back({step, is});
    was = is;
  }
  return history;
}

template <int D>
std::vector<Event> node_history(RecordingReader<D>& recording, NodeId node, std::uint32_t up_to) {
  std::vector<Event> history;
  for (const OperatorRow& row : recording.operators()) {
    if (row.step > up_to) break;
    if (row.node.node == node) history.push_back(recording.event(row.event));
  }
  return history;
}

#define KERF_INSTANTIATE(D)                                                                          \
  template std::vector<PairChange> pair_history<D>(RecordingReader<D>&, const Pair&, std::uint32_t); \
  template std::vector<Event> node_history<D>(RecordingReader<D>&, NodeId, std::uint32_t);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
