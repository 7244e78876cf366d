#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "frames/page/cell.h"

namespace kerf {

/// How late pairs are reported. A meeting begins in the first step in which two boxes overlap and ends when
/// they part; it is detected in the first of these steps in which the pair is reported. The steps before that
/// are its lag: all of its steps, if it is never reported. A meeting that is undetected when the run ends
/// counts as one that ends then: its lag is that at least. Meetings that exist from the beginning do not
/// count.
class Meetings {
 public:
  /// The pairs of the next step, both sorted.
  void add(std::span<const Pair> truth, std::span<const Pair> reported);

  /// {"meetings", "never_share" (that ended undetected), "lag_mean", "lag_p99", "lag_max" (steps)}, as if the
  /// run ended here.
  [[nodiscard]] Json figures() const;

 private:
  struct Meeting {
    Pair pair;
    std::uint32_t begin = 0;
    bool waits = false;  ///< not yet detected
  };

  void detect(Meeting& meeting);
  void end(const Meeting& meeting);
  [[nodiscard]] Json figures_of_ended() const;

  std::vector<Meeting> open_;  ///< sorted by pair
  std::vector<Meeting> next_;
  std::vector<double> lags_;
  std::uint64_t never_ = 0;
  std::uint32_t step_ = 0;
};

}  // namespace kerf
