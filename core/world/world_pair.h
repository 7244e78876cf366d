#pragma once

#include <cstdint>

#include "core/world/handle.h"

namespace kerf {

/// A pair as a World reports it. 24 bytes without padding, so that lists of them can be shared with other
/// languages.
struct WorldPair {
  static constexpr std::uint32_t kSensor = 1;  ///< one of both is a sensor, or both are

  Handle a;  ///< the one with the smaller index
  Handle b;
  std::uint32_t flags = 0;
  std::uint32_t reserved = 0;

  [[nodiscard]] constexpr bool is_sensor() const { return (flags & kSensor) != 0; }
  friend constexpr bool operator==(const WorldPair&, const WorldPair&) = default;
};

}  // namespace kerf
