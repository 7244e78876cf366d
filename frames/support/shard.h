#pragma once

#include <cstdint>
#include <string>

namespace kerf {

/// Every `count`-th item of some work, from item `index` on.
struct Shard {
  std::uint32_t index = 0;
  std::uint32_t count = 1;
  [[nodiscard]] bool has(std::uint64_t item) const { return item % count == index; }
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// "3/8" is the third of eight. Throws UsageError, which names --shard, for anything else.
Shard parse_shard(const std::string& text);

}  // namespace kerf
