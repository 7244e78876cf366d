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

  /// The time for completing the answer in the last step; setting boxes counts for the library.
  [[nodiscard]] virtual std::uint64_t added_nanoseconds() const = 0;
};

}  // namespace kerf
