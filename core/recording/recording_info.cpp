#include "core/recording/recording_info.h"

#include <algorithm>
#include <iterator>

#include "core/base/random.h"

namespace kerf {

const Config& config_of(const RecordingInfo& info, std::uint32_t step) {
  const auto after = std::ranges::upper_bound(info.changes, step, {}, &ConfigChange::step);
  return after == info.changes.begin() ? info.config : std::prev(after)->config;
}

std::uint64_t hash_pairs(std::span<const Pair> pairs) {
  std::uint64_t sum = pairs.size();
  for (const Pair& pair : pairs) sum += Random((std::uint64_t{pair.a.value} << 32U) | pair.b.value).bits();
  return sum;
}

std::string to_hex(std::uint64_t hash) {
  std::string text(16, '0');
  for (std::size_t k = text.size(); k > 0; --k, hash >>= 4U) text[k - 1] = "0123456789abcdef"[hash & 15U];
  return text;
}

}  // namespace kerf
