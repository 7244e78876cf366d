#include "tests/fuzz/tree/config_reader.h"

#include <algorithm>
#include <array>

namespace kerf::test {
namespace {

constexpr std::array<float, 6> kShares{0, 0.025F, 0.3F, 0.5F, 0.9F, 1};
constexpr std::array<float, 6> kEntryLimits{1, 1.1F, 1.5F, 2, 4, 1000};

void change_thresholds(Config& config, ByteReader& bytes) {
  const std::uint32_t one = 1 + bytes.below(12);
  const std::uint32_t other = 1 + bytes.below(12);
  config.min_threshold = std::min(one, other);
  config.max_threshold = std::max(one, other);
}

void change_switch(Config& config, ByteReader& bytes) {
  constexpr std::array kSwitches{&Config::split,
                                 &Config::shift_split,
                                 &Config::merge,
                                 &Config::balance,
                                 &Config::scene_redundancy,
                                 &Config::swap,
                                 &Config::restless,
                                 &Config::resting_pairs,
                                 &Config::dense,
                                 &Config::leaf_boxes,
                                 &Config::rows};
  bool& on = config.*kSwitches[bytes.below(kSwitches.size())];
  on = !on;
}

}  // namespace

Config small_tree_config() {
  Config config;
  config.directions = 12;
  config.min_threshold = 2;
  config.max_threshold = 4;
  config.max_redundancy = 0.5F;
  config.schedule_interval = 1;
  config.budget_divisor = 2;
  config.max_height = 63;
  return config;
}

void change_parameter(Config& config, ByteReader& bytes) {
  const auto share = [&bytes] { return kShares[bytes.below(kShares.size())]; };
  switch (bytes.below(19)) {
    case 0:
      return change_thresholds(config, bytes);
    case 1:
      config.candidate_factor = static_cast<float>(bytes.below(5));
      break;
    case 2:
      config.sample = 2 + bytes.below(64);
      break;
    case 3:
      config.free_directions = bytes.below(2) == 0;
      break;
    case 4:
      config.min_balance = share();
      break;
    case 5:
    case 6:
      config.max_redundancy = share();
      break;
    case 7:
      config.repair_redundancy = share();
      break;
    case 8:
      config.merge_fraction = share();
      break;
    case 9:
      config.event_capacity = bytes.below(8);
      break;
    case 10:
      config.budget_divisor = bytes.below(4);
      break;
    case 11:
      config.schedule_interval = 1 + bytes.below(3);
      break;
    case 12:
      config.max_height = bytes.below(64);
      break;
    case 13:
      config.byte_sweep = bytes.below(3) != 0;
      break;
    case 14:
      config.skin = static_cast<float>(bytes.below(3)) * 4;
      break;
    case 15:
      config.stream_share = share() / 4;  // or nothing would ever be placed in one pass while pairs are kept
      break;
    case 16:
      config.bulk_factor = static_cast<float>(bytes.below(3));
      break;
    case 17:
      change_switch(config, bytes);
      break;
    default:
      config.max_entries = kEntryLimits[bytes.below(kEntryLimits.size())];
      break;
  }
}

}  // namespace kerf::test
