#pragma once

#include <algorithm>
#include <limits>
#include <optional>

namespace kerf {

/// When a window is to be drawn again though the user does nothing more. Dear ImGui needs a few frames until
/// what an action leads to is seen, and a hint comes once the mouse has rested. Times are in seconds.
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
  /// After so many seconds a frame is due; infinity: none is.
  [[nodiscard]] double seconds_to_next(double now) const {
    if (settling_ > 0) return 0;
    return hint_ ? std::max(0.0, *hint_ - now) : std::numeric_limits<double>::infinity();
  }

 private:
  int settling_ = kSettling;
  std::optional<double> hint_;
};

}  // namespace kerf
