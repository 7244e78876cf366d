#pragma once

#include <cstdint>

namespace kerf {

/// A broad phase whose library answers less than ours are asked for: it leaves candidates to be tested, or
/// keeps pairs that have to be gone through. The rest of a step is what the library costs by itself.
class AddedWork {
 public:
  AddedWork() = default;
  AddedWork(const AddedWork&) = delete;
  AddedWork& operator=(const AddedWork&) = delete;
  virtual ~AddedWork() = default;

  /// How long completing the answer took in the last step; setting boxes counts for the library.
  [[nodiscard]] virtual std::uint64_t added_nanoseconds() const = 0;
};

}  // namespace kerf
