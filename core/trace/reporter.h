#pragma once

#include <utility>

#include "core/trace/event.h"
#include "core/trace/trace.h"

namespace kerf {

/// Numbers events and hands them to the trace. With NoTrace every call compiles to nothing, the building of
/// the event included.
template <class Trace>
class Reporter {
 public:
  [[nodiscard]] Trace& trace() { return trace_; }
  void begin_step(std::uint32_t step) { step_ = step; }
  /// The id of the event to come.
  [[nodiscard]] std::uint64_t next_id() const { return next_id_; }
  /// As if everything up to `next_id` in `step` had been reported.
  void resume(std::uint64_t next_id, std::uint32_t step) {
    next_id_ = next_id;
    step_ = step;
  }

  /// `make()` builds the body; it is called only when somebody watches.
  template <class Make>
  void report(Make make) {
    if constexpr (Trace::kEnabled) trace_.record({next_id_++, step_, EventBody{make()}});
  }

 private:
  [[no_unique_address]] Trace trace_;
  std::uint64_t next_id_ = 0;
  std::uint32_t step_ = 0;
};

}  // namespace kerf
