#pragma once

#include <cstdint>

namespace kerf {

/// How many wrong pairs a step has.
struct Alarm {
  std::uint32_t step = 0;
  std::uint64_t missed = 0;
  std::uint64_t extra = 0;
  std::uint64_t twice = 0;
  [[nodiscard]] bool is_wrong() const { return missed + extra + twice > 0; }
};

}  // namespace kerf
