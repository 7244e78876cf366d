#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "core/trace/event.h"

namespace kerf {

/// The receiver of a broad phase's events. With NoTrace nothing is built and nothing is called.
struct NoTrace {
  static constexpr bool kEnabled = false;
};

/// Keeps every event until taken.
class EventLog {
 public:
  static constexpr bool kEnabled = true;
  void record(Event event) { events_.push_back(std::move(event)); }
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  /// Returns the events and starts afresh.
  std::vector<Event> take() { return std::exchange(events_, {}); }

 private:
  std::vector<Event> events_;
};

/// Calls a listener at each event. The listener may read the tree in the middle of a step, but not change it.
class Watch {
 public:
  static constexpr bool kEnabled = true;
  void record(const Event& event) const {
    if (on_event) on_event(event);
  }
  std::function<void(const Event&)> on_event;
};

/// INSTANTIATE(D, TRACE) for both dimensions and each trace above.
#define KERF_FOR_EACH_TRACE(INSTANTIATE) \
  INSTANTIATE(2, NoTrace)                \
  INSTANTIATE(3, NoTrace)                \
  INSTANTIATE(2, EventLog)               \
  INSTANTIATE(3, EventLog)               \
  INSTANTIATE(2, Watch)                  \
  INSTANTIATE(3, Watch)

}  // namespace kerf
