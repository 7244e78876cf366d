#pragma once

#include <span>
#include <vector>

#include "core/base/bytes.h"
#include "core/trace/event.h"

namespace kerf {

/// Appends the events of one step. Their ids are consecutive, so only the first is stored.
void put_events(std::span<const Event> events, ByteWriter& out);
/// Reads what `put_events` wrote. Throws std::runtime_error for damaged bytes.
std::vector<Event> get_events(ByteReader& in, std::uint32_t step, std::uint64_t first_id);

}  // namespace kerf
