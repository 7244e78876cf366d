#pragma once

#include <cstdint>

#include "core/recording/recording_reader.h"

namespace kerf {

/// More than the number of each object that the recording has in any of its steps. Reads the steps since the
/// last keyframe. Throws std::runtime_error if they are damaged.
template <int D>
std::uint32_t object_bound(RecordingReader<D>& recording);

}  // namespace kerf
