#pragma once

#include <map>
#include <optional>

#include "viz/debugger/model/run.h"

namespace kerf {

/// A node on which an operator has acted stays marked for so many steps, ever less.
inline constexpr std::uint32_t kMarkedSteps = 4;

/// The living nodes on which operators acted up to the run's moment: 1 in its step, less in the steps before,
/// none after `kMarkedSteps`. It depends on the moment alone, so that a picture is the same from both sides.
std::map<NodeId, double> recent_operators(Run& run);

/// The last operator that acted up to the run's moment; none if none has.
std::optional<OperatorRow> last_operator(Run& run);

}  // namespace kerf
