#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/given_names.h"
#include "core/recording/operator_rows.h"

namespace kerf {

/// Operators that undo each other or never act.
enum class ThrashKind : std::uint8_t {
  split_merge_split,  ///< a node was split, merged and split again
  balance_ping_pong,  ///< a partitioner was shifted one way, back, and that way again
  starved,            ///< an operator was listed and waited
};
std::string_view to_string(ThrashKind kind);

struct Thrash {
  ThrashKind kind = ThrashKind::starved;
  Operator op = Operator::split;  ///< for starved ones
  NodeId node;
  std::uint64_t event = 0;  ///< the event that completes it; for starved ones, the one that listed it
  std::uint32_t first_step = 0;
  std::uint32_t last_step = 0;  ///< for operators that still wait, the last of the run
};

/// All cases within `steps` steps, or for starved ones longer than that, by event. O(events).
std::vector<Thrash> find_thrash(std::span<const OperatorRow> operators, std::uint32_t last_step,
                                std::uint32_t steps);

/// "n17 was split, merged and split again, steps 20 to 60".
std::string to_text(const Thrash& thrash, const GivenNames& names);

}  // namespace kerf
