#pragma once

#include <string_view>
#include <vector>

#include "tests/hard/cases.h"
#include "tests/hard/trial.h"

namespace kerf::test {

/// Our tree at its busiest: small leaves, many straddlers allowed, everything done at once.
inline constexpr std::string_view kEagerConfig =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=4,max_threshold=8";

/// The same with every policy beyond the paper.
inline constexpr std::string_view kFastConfig =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=4,max_threshold=8,"
    "free_directions=0,byte_sweep=1,skin=8,stream_share=0.06,bulk_factor=2";

/// The ways in which each case is tried on a kind of volume: the paper's configuration, the eager one, the
/// fast one, and the case's own, with boxes and with turned volumes.
inline std::vector<Setting> settings_for(const HardCase& hard_case, VolumeKind kind) {
  std::vector<std::string_view> configs{"", kEagerConfig, kFastConfig};
  if (!hard_case.config.empty()) configs.push_back(hard_case.config);
  std::vector<Setting> settings;
  for (const Feed feed : {Feed::boxes, Feed::posed}) {
    if (feed == Feed::posed && kind == VolumeKind::box) continue;
    for (const std::string_view config : configs)
      settings.push_back({kind, feed, config, hard_case.flush_to_zero, 1});
  }
  return settings;
}

}  // namespace kerf::test
