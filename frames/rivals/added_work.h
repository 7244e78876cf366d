#pragma once

#include <cstdint>

namespace kerf {

/// A broad phase with a library that does only part of the work: it leaves candidates to be tested, or keeps
/// pairs that the caller has to visit. The rest of a step is the library's own cost.
class AddedWork {
 public:
  AddedWork() = default;
  AddedWork(const AddedWork&) = delete;
  AddedWork& operator=(const AddedWork&) = delete;
  virtual ~AddedWork() = default;

  /// Completes the answer of the last step once more, with the same pairs, and returns the time of that.
  /// Setting boxes counts for the library. A step itself reads no clock: on small scenes that would be a good
  /// part of its time.
  virtual std::uint64_t time_added() = 0;
};

}  // namespace kerf
