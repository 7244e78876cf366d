#include "core/query/object_bound.h"

#include <algorithm>
#include <cstddef>

#include "core/tree/projector.h"

namespace kerf {
namespace {

template <int D>
std::uint32_t bound_of_inserted(const StepRequests<D>& requests) {
  std::uint32_t bound = 0;
  std::size_t next = 0;
  for (const Call& call : requests.calls) {
    for (std::size_t k = next; is_insert(call.kind) && k < next + call.count; ++k)
      bound = std::max(bound, requests.objects[k].value + 1);
    next += call.count;
  }
  return bound;
}

}  // namespace

template <int D>
std::uint32_t object_bound(RecordingReader<D>& recording) {
  const std::uint32_t last = recording.steps();
  const std::uint32_t keyframe = recording.keyframe_before(last);
  std::uint32_t bound = 0;
  if (keyframe > 0) {
    const RecordingInfo& info = recording.info();
    const auto projector = make_projector<D>(config_of(info, keyframe), info.volume);
    bound = static_cast<std::uint32_t>(recording.keyframe(keyframe, projector).latest.bound());
  }
  for (std::uint32_t step = keyframe + 1; step <= last; ++step)
    bound = std::max(bound, bound_of_inserted(recording.step(step).requests));
  return bound;
}

template std::uint32_t object_bound(RecordingReader<2>&);
template std::uint32_t object_bound(RecordingReader<3>&);

}  // namespace kerf
