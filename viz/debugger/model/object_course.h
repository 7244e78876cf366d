#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/recording/recording_reader.h"

namespace kerf {

/// What one object does in each step of a run, the first being step 1. Where there is no value, such as while
/// the object is absent, it is not a number.
struct ObjectCourse {
  std::vector<float> leaves;  ///< that hold it
  std::vector<float> pairs;   ///< that it is in
  std::vector<float> speed;   ///< the way of its box's centre since the step before
};

/// Runs the tree again, without its pairs, and tests the object's box with all others. Calls `goes_on` with
/// each step; once that returns false, later steps have no values.
template <int D>
ObjectCourse find_course(RecordingReader<D>& recording, ObjectId object,
                         const std::function<bool(std::uint32_t)>& goes_on);

}  // namespace kerf
