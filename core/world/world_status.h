#pragma once

#include <cstdint>
#include <string_view>

namespace kerf {

/// The answer of a World to a request. All but `ok` and `clamped` are failures: nothing was done for the
/// object.
enum class [[nodiscard]] WorldStatus : std::uint8_t{
    ok,
    clamped,       ///< done; infinite bounds of the box were replaced by +-FLT_MAX
    stale_handle,  ///< names no object of this world: removed, of a world with another tag, or none
    bad_box,       ///< NaN, or min > max: the object stays where it was
    bad_value,     ///< an unknown kind, a margin that is no length, or a vector that is not finite
    bad_length,    ///< the lists of a batch have different lengths
    full,          ///< no index is free: `step()` frees those of removed objects
    unstepped,     ///< there are requests since the last `step()`: call it first
    damaged,       ///< the bytes are no state that a World of this version and dimension wrote
    busy,          ///< asked for by the pair callback, while the step runs
};

constexpr bool is_failure(WorldStatus status) { return status > WorldStatus::clamped; }

/// A sentence that says what is wrong and what to do.
std::string_view to_string(WorldStatus status);

}  // namespace kerf
