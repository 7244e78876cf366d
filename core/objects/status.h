#pragma once

#include <cstdint>
#include <string_view>

namespace kerf {

/// Whether an object can move by itself. Two fixed objects are never a pair: no engine wants them.
enum class Mobility : std::uint8_t { moving, fixed };

/// The answer of a broad phase to one request. Any status but `ok` and `clamped` leaves the healthy objects
/// and their pairs as they were.
enum class [[nodiscard]] Status : std::uint8_t{
    ok,
    clamped,       ///< accepted; infinite bounds were clamped to +-FLT_MAX
    quarantined,   ///< NaN or min > max: the object takes part in no pair until a valid box comes
    unknown_id,    ///< no such object: nothing was done
    duplicate_id,  ///< the object exists already: nothing was done
    sparse_id,     ///< far beyond the number of objects (see kFreeIds): nothing was done; number them anew
};

/// Nothing was done.
constexpr bool is_refused(Status status) {
  return status == Status::unknown_id || status == Status::duplicate_id || status == Status::sparse_id;
}

std::string_view to_string(Status status);

}  // namespace kerf
