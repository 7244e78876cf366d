#pragma once

#include <utility>
#include <vector>

#include "core/trace/decision.h"
#include "core/trace/event.h"
#include "core/trace/trace.h"

namespace kerf {

/// Numbers events and passes them to the trace. Since a number names an event before it happens, the reporter
/// also keeps the decisions about events. With NoTrace every call compiles to nothing, the construction of
/// the event included.
template <class Trace>
class Reporter {
 public:
  [[nodiscard]] Trace& trace() { return trace_; }
  void begin_step(std::uint32_t step) { step_ = step; }
  /// The id of the next event.
  [[nodiscard]] std::uint64_t next_id() const { return next_id_; }
  /// Continues as if everything up to `next_id` in `step` had been reported.
  void resume(std::uint64_t next_id, std::uint32_t step) {
    next_id_ = next_id;
    step_ = step;
  }

  /// The decisions hold for the whole run, `resume` included.
  void decide(std::vector<Decision> decisions) { decisions_ = std::move(decisions); }
  /// The decision about the next event, if there is one for that operator. Null: Algorithm 1 decides.
  [[nodiscard]] const Decision* decision(Operator op) const {
    if constexpr (Trace::kEnabled)
      for (const Decision& decision : decisions_)
        if (decision.event == next_id_ && decision.op == op) return &decision;
    return nullptr;
  }
  [[nodiscard]] bool refuses(Operator op) const {
    const Decision* const decided = decision(op);
    return decided != nullptr && !decided->plane;
  }

  /// `make()` builds the body; it is called only if a trace receives it.
  template <class Make>
  void report(Make make) {
    if constexpr (Trace::kEnabled) trace_.record({next_id_++, step_, EventBody{make()}});
  }

 private:
  [[no_unique_address]] Trace trace_;
  std::uint64_t next_id_ = 0;
  std::uint32_t step_ = 0;
  std::vector<Decision> decisions_;
};

}  // namespace kerf
