#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viz/debugger/model/time_window.h"

namespace kerf {

/// A span of the selection's history.
struct Ribbon {
  enum class Kind : std::uint8_t {
    life,     ///< a node, from the split that made it to the merge or swap that ended it
    divided,  ///< within its life: it had children
    listed,   ///< Algorithm 1 listed an operator at the node ...
    refused,  ///< ... that did not act
    acted,
    pair,  ///< two objects were one
  };
  std::uint32_t first_step = 0;  ///< 0: from the beginning
  std::uint32_t last_step = 0;
  Kind kind = Kind::pair;

  /// Its time.
  [[nodiscard]] double begin() const { return first_step == 0 ? 0 : first_step - 1.0; }
  friend bool operator==(const Ribbon&, const Ribbon&) = default;
};
inline constexpr std::size_t kRibbonKinds = 6;

/// The ribbons that are seen in the window. Of those of a kind that would be drawn over the same pixels, one
/// is left: a node of a long run has more operators than a lane has pixels.
std::vector<Ribbon> thin_out(std::span<const Ribbon> ribbons, const TimeScale& scale);

}  // namespace kerf
