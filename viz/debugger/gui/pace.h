#pragma once

#include <algorithm>
#include <limits>
#include <optional>

namespace kerf {

/// Decides when a window is drawn again without further input. Dear ImGui needs a few frames to show the
/// effect of an action, and a hint appears once the mouse has rested. Times are in seconds.
class Pace {
 public:
  static constexpr int kSettling = 3;    ///< a window of Dear ImGui knows its size in the second frame
  static constexpr double kRest = 0.65;  ///< a little more than `widgets::hint` waits

  void user_acted(double now) {
    settling_ = kSettling;
    hint_ = now + kRest;
  }
  void drawn(double now) {
    settling_ = std::max(0, settling_ - 1);
    if (!hint_ || now < *hint_) return;
    hint_.reset();
    settling_ = kSettling;
  }
  /// The seconds until the next frame is due; infinity: none is.
  [[nodiscard]] double seconds_to_next(double now) const {
    if (settling_ > 0) return 0;
    return hint_ ? std::max(0.0, *hint_ - now) : std::numeric_limits<double>::infinity();
  }

 private:
  int settling_ = kSettling;
  std::optional<double> hint_;
};

}  // namespace kerf
