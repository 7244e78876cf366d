#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "core/trace/event.h"

namespace kerf {

/// What a broad phase reports to. With NoTrace nothing is built and nothing is called.
struct NoTrace {
  static constexpr bool kEnabled = false;
};

/// Keeps every event until taken.
class EventLog {
 public:
  static constexpr bool kEnabled = true;
  void record(Event event) { events_.push_back(std::move(event)); }
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  /// Gives the events away and starts afresh.
  std::vector<Event> take() { return std::exchange(events_, {}); }

 private:
  std::vector<Event> events_;
};

/// Tells each event at the moment in which it happens: whoever listens may look at the tree in the middle of
/// a step, but not change it.
class Watch {
 public:
  static constexpr bool kEnabled = true;
  void record(const Event& event) const {
    if (on_event) on_event(event);
  }
  std::function<void(const Event&)> on_event;
};

/// INSTANTIATE(D, TRACE) for both dimensions and each of the above.
#define KERF_FOR_EACH_TRACE(INSTANTIATE) \
  INSTANTIATE(2, NoTrace)                \
  INSTANTIATE(3, NoTrace)                \
  INSTANTIATE(2, EventLog)               \
  INSTANTIATE(3, EventLog)               \
  INSTANTIATE(2, Watch)                  \
  INSTANTIATE(3, Watch)

}  // namespace kerf
