#pragma once

#include <span>
#include <vector>

#include "core/base/bytes.h"
#include "core/recording/recording_info.h"
#include "core/trace/event.h"

namespace kerf {

/// Appends the events of one step. Their ids are consecutive, so only the first is stored.
void put_events(std::span<const Event> events, ByteWriter& out);
/// Reads what `put_events` wrote of the step of that row. Throws std::runtime_error for damaged bytes, and
/// for another count of events than the row's before it makes room for them.
std::vector<Event> get_events(ByteReader& in, const StepRow& row);

}  // namespace kerf
